// What the panels ask of the state: what is selected, where the run is.
#include "ui/model/view.h"

namespace triscope {

const DensityRequest* RunView::request() const {
  const std::shared_ptr<const Domain>& domain = session.domain();
  const std::optional<std::size_t>& index = ui.density.request;
  if (now() == nullptr || domain == nullptr || ui.document.opening || !index) return nullptr;
  return *index < domain->density.size() ? &domain->density[*index] : nullptr;
}

bool RunView::inInsertion() const {
  const InsertionUi& insertion = ui.insertion;
  if (insertion.now == nullptr || now() == nullptr || session.stale()) return false;
  return now()->state.tick == (insertion.phase == InsertionPhase::filled ? insertion.after : insertion.after - 1);
}

Stage stageOf(const Snapshot& now) {
  return now.last && now.state.stage != Stage::finished ? now.last->stage : now.state.stage;
}

}  // namespace triscope
