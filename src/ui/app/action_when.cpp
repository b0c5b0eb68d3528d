// When what concerns the run, files, edits and the picture can be done.
#include "ui/app/action_when.h"

namespace triscope::when {
namespace {

constexpr const char* kOpening = "Another domain is being opened; wait, or press Esc to keep this one.";

std::string hasWorst(const RunView& view, Slot Quality::* slot) {
  if (view.now() == nullptr || !(view.now()->quality.*slot).exists()) return "There are no triangles to judge yet.";
  return {};
}

}  // namespace

std::string always(const RunView& /*view*/) { return {}; }

std::string hasMesh(const RunView& view) { return view.now() == nullptr ? "There is nothing to look at yet." : ""; }

std::string goesOn(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  const MeshState& state = view.now()->state;
  if (state.failed) return "The method stopped here; change a parameter or the domain.";
  return state.stage == Stage::finished ? "The run is finished. Go back, or restart." : "";
}

std::string goesBack(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  return view.now()->state.tick == 0 ? "This is the start of the run." : "";
}

std::string playsOrPauses(const RunView& view) {
  return view.session.busy() && !view.session.stale() ? std::string() : goesOn(view);
}

std::string stepsInto(const RunView& view) {
  // Its phases are gone through even where nothing follows them.
  if (view.ui.insertion.now && view.ui.insertion.phase != InsertionPhase::filled) return {};
  return goesOn(view);
}

std::string slower(const RunView& view) { return view.ui.speed <= 1.0 ? "This is the slowest." : ""; }

std::string faster(const RunView& view) {
  return view.ui.speed >= 100000.0 ? "This is the fastest; go to the end instead." : "";
}

std::string savesSession(const RunView& view) {
  if (view.now() == nullptr) return "There is nothing to save yet.";
  return view.ui.document.saving ? "The session is being written." : "";
}

std::string restores(const RunView& view) { return view.ui.document.kept.empty() ? "No work was left behind." : ""; }

std::string writes(const RunView& view) {
  if (view.now() == nullptr) return "There is nothing to write yet.";
  return view.ui.exporting ? "A file is being written." : "";
}

std::string readsAgain(const RunView& view) {
  if (view.now() == nullptr) return "No domain is open.";
  return view.now()->state.domain->file.empty() ? "This sample is built in; there is no file to read again." : "";
}

std::string undoes(const RunView& view) {
  if (view.ui.document.opening) return kOpening;
  return view.ui.undo.empty() ? "Nothing has been changed." : "";
}

std::string redoes(const RunView& view) {
  if (view.ui.document.opening) return kOpening;
  return view.ui.redo.empty() ? "Nothing was taken back." : "";
}

std::string placesDensity(const RunView& view) {
  if (view.now() == nullptr) return "There is no domain yet.";
  return view.ui.document.opening ? kOpening : "";
}

std::string deletesDensity(const RunView& view) {
  return view.request() != nullptr ? "" : "No density constraint is selected.";
}

std::string hasWorstAspect(const RunView& view) { return hasWorst(view, &Quality::aspectAt); }
std::string hasWorstArea(const RunView& view) { return hasWorst(view, &Quality::areaRatioAt); }
std::string hasWorstEdge(const RunView& view) { return hasWorst(view, &Quality::edgeRatioAt); }

std::string larger(const RunView& view) { return view.ui.scale() >= 3.0 ? "300 % is the largest." : ""; }
std::string smaller(const RunView& view) { return view.ui.scale() <= 0.75 ? "75 % is the smallest." : ""; }

}  // namespace triscope::when
