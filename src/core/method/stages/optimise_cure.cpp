#include "core/method/stages/optimise_cure.h"

#include <algorithm>
#include <utility>

#include "core/mesh/centroid.h"
#include "core/optimise/cure.h"

namespace triscope {
namespace {

constexpr std::uint32_t kEdits = 12;   // tried around a triangle
constexpr std::uint32_t kFirsts = 10;  // of pairs
constexpr std::uint32_t kSeconds = 10;
constexpr int kRings = 3;              // relaxed around it
constexpr double kBetter = 0.8;        // of the penalty before: at most so much is left by an edit that does not cure
constexpr double kPairPatient = 1e-6;  // penalty of a triangle beyond the slack that is worth a pair
constexpr std::size_t kPairPatients = 60;
// What no edit can cure ends in bounded time: so many are tried in all, and one more for so many triangles.
constexpr std::uint64_t kAllEdits = 2000;
constexpr std::uint64_t kTrianglesAnEdit = 2;
constexpr std::uint64_t kAllPairs = 400;
constexpr std::uint64_t kTrianglesAPair = 40;
constexpr std::uint64_t kWorkOfATry = 128;  // in decisions of other kinds, MeshState::heavyWork

// A sequence of edits around the patient, tried: rolled back by takeBack().
struct Tried {
  EditMark before;
  PatchPenalty penalty;
};

void takeBack(Optimiser& o, const EditMark& before) {
  undoEdits(o.state.mesh, o.work.room.log, before);
  o.state.sizes.resize(before.allVertices);
}

Rule ruleOf(CureKind kind) { return static_cast<Rule>(static_cast<int>(Rule::cure_relax) + static_cast<int>(kind)); }

EditMark beginTry(Optimiser& o) {
  o.state.heavyWork += kWorkOfATry;
  beginEdits(o.work.room.log);
  o.work.room.touched.clear();
  return markOf(o.state.mesh, o.work.room.log);
}

// One edit around the patient. Nothing, with nothing changed, where it is not possible.
std::optional<Tried> tryEdit(Optimiser& o, const CureEdit& edit, CurePatch patch, const CureAims& aims) {
  const EditMark before = beginTry(o);
  if (!makeEdit(o.work, edit)) return std::nullopt;
  return Tried{before, settle(o.work, edit.kind, aims, patch)};
}

// Edits around what is worst after a first one that was settled; the mesh stays as the first left it.
std::vector<CureEdit> secondEdits(Optimiser& o, const CurePatch& patch, const CureAims& aims) {
  std::vector<CureEdit> edits;
  const Slot worst = worstIn(o.work, patch.all, aims);
  if (worst.exists()) collectEdits(o.work, worst, edits);
  return edits;
}

struct TriedPair {
  std::optional<Tried> tried;
  bool firstPossible = false;
  std::size_t offered = 0;  // second edits that there are
};

TriedPair tryPair(Optimiser& o, const CureEdit& first, std::uint32_t second, CurePatch patch, const CureAims& aims) {
  TriedPair pair;
  const EditMark before = beginTry(o);
  if (!makeEdit(o.work, first)) return pair;
  pair.firstPossible = true;
  settle(o.work, first.kind, aims, patch);
  const std::vector<CureEdit> seconds = secondEdits(o, patch, aims);
  pair.offered = seconds.size();
  o.work.room.touched.clear();
  if (second >= seconds.size() || !makeEdit(o.work, seconds[second])) {
    takeBack(o, before);
    return pair;
  }
  pair.tried = Tried{before, settle(o.work, seconds[second].kind, aims, patch)};
  return pair;
}

// Whether every edit has been tried around it already, and nothing near it has changed since.
bool isHopeless(const Optimising& ahead, const Mesh& mesh, Slot slot) {
  return ahead.hopeless.has(slot) && ahead.hopeless[slot] == idOf(mesh, slot);
}

void giveUp(Optimiser& o) {
  Optimising& ahead = o.ahead;
  const Slot slot = std::exchange(ahead.cure.patient, {});
  if (!ahead.hopeless.has(slot)) ahead.hopeless.resize(o.state.mesh.triangles.size(), {});
  ahead.hopeless[slot] = idOf(o.state.mesh, slot);
}

// What was given up near a patch may be worth another look now that the patch is another.
void giveHopeAround(Optimiser& o, const CurePatch& patch) {
  std::vector<Vertex>& around = o.work.room.patch;
  verticesAround(o.work, patch.all, kRings + 2, around);
  forEachTriangleAround(o.work, around, [&](Slot slot) {
    if (o.ahead.hopeless.has(slot)) o.ahead.hopeless[slot] = {};
  });
}

// The patch around the patient at hand, or around the next triangle that is beyond the aims, with the edits to try
// there; false when there is none.
bool takePatient(Optimiser& o, double beyond, const CureAims& aims, int rings, CurePatch& patch) {
  Optimising& ahead = o.ahead;
  const Mesh& mesh = o.state.mesh;
  if (ahead.cure.patient.exists()) {
    patchAround(o.work, ahead.cure.patient, rings, patch);
    return true;
  }
  while (o.state.cursor.index < ahead.bad.size()) {
    const Slot slot = ahead.bad[o.state.cursor.index++];
    if (!mesh.alive(slot) || isHopeless(ahead, mesh, slot)) continue;
    if (penaltyOf(mesh, o.state.sizes, slot, aims.slack) <= beyond) continue;
    ahead.cure = {};
    ahead.cure.patient = slot;
    patchAround(o.work, slot, rings, patch);
    ahead.cure.before = penaltyOf(o.work, patch.all, aims).sum;
    ahead.edits.clear();
    collectEdits(o.work, slot, ahead.edits);
    return true;
  }
  return false;
}

EditReport reportOn(Optimiser& o, Rule rule) {
  const Slot patient = o.ahead.cure.patient;
  return {.rule = rule,
          .subject = idOf(o.state.mesh, patient),
          .at = centroidOf(o.state.mesh, patient),
          .limit = o.ahead.cure.before};
}

void takeNote(CureProgress& cure, double sum, std::uint32_t first, std::uint32_t second) {
  if (cure.any && !(sum < cure.best)) return;
  cure.any = true;
  cure.best = sum;
  cure.bestFirst = first;
  cure.bestSecond = second;
}

Outcome keep(Optimiser& o, EditReport report, const Tried& tried, const CurePatch& patch) {
  giveHopeAround(o, patch);
  report.measured = tried.penalty.sum;
  o.ahead.cure.patient = {};
  return decideKept(o, report, tried.before);
}

Outcome giveBack(Optimiser& o, EditReport report, const Tried& tried) {
  takeBack(o, tried.before);
  report.measured = tried.penalty.sum;
  report.refusal = Refusal::patch_worse;
  return decideUndone(o, report);
}

}  // namespace

void beginCure(Optimiser& o) {
  const Mesh& mesh = o.state.mesh;
  const CureAims aims = cureAimsFor(aimsOf(o.state.settings));
  Optimising& ahead = o.ahead;
  ahead.waits = {};
  ahead.visits = {};
  ahead.cure = {};
  ahead.bad.clear();
  struct Bad {
    double beyond;
    Slot slot;
  };
  std::vector<Bad> bad;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const double beyond = penaltyOf(mesh, o.state.sizes, slot, aims.slack);
    if (beyond > kCured) bad.push_back({beyond, slot});
  }
  std::ranges::sort(bad, {}, [](const Bad& b) { return std::pair(-b.beyond, b.slot); });
  for (const Bad& one : bad) ahead.bad.push_back(one.slot);
}

void beginCurePairs(Optimiser& o) {
  beginCure(o);
  Optimising& ahead = o.ahead;
  const CureAims aims = cureAimsFor(aimsOf(o.state.settings));
  ahead.hopeless = {};
  ahead.tried = 0;
  std::erase_if(ahead.bad, [&](Slot slot) { return touchesSharpCorner(o.work, slot, aims); });
  if (ahead.bad.size() > kPairPatients) ahead.bad.resize(kPairPatients);
}

Outcome runCure(Optimiser& o) {
  Optimising& ahead = o.ahead;
  CureProgress& cure = ahead.cure;
  const CureAims aims = cureAimsFor(aimsOf(o.state.settings));
  CurePatch patch;
  for (;;) {
    const bool isNew = !cure.patient.exists();
    if (!takePatient(o, kCured, aims, kRings, patch)) return Outcome::done;
    if (isNew) ahead.edits.insert(ahead.edits.begin(), CureEdit{});  // to relax the patch comes first
    const std::uint64_t most = kAllEdits + o.state.mesh.liveCount() / kTrianglesAnEdit;
    while (cure.first < ahead.edits.size() && cure.tried < kEdits && ahead.tried < most) {
      const std::uint32_t number = cure.first++;
      const CureEdit edit = ahead.edits[number];
      const EditReport report = reportOn(o, ruleOf(edit.kind));
      const std::optional<Tried> tried = tryEdit(o, edit, patch, aims);
      if (!tried) continue;
      ++cure.tried;
      ++ahead.tried;
      if (tried->penalty.beyond < kCured) return keep(o, report, *tried, patch);
      takeNote(cure, tried->penalty.sum, number, 0);
      return giveBack(o, report, *tried);
    }
    if (cure.any && cure.best < kBetter * cure.before) {
      const CureEdit edit = ahead.edits[cure.bestFirst];
      const EditReport report = reportOn(o, ruleOf(edit.kind));
      if (const std::optional<Tried> tried = tryEdit(o, edit, patch, aims)) return keep(o, report, *tried, patch);
    }
    giveUp(o);
  }
}

Outcome runCurePairs(Optimiser& o) {
  Optimising& ahead = o.ahead;
  CureProgress& cure = ahead.cure;
  const CureAims aims = cureAimsFor(aimsOf(o.state.settings));
  CurePatch patch;
  for (;;) {
    if (!takePatient(o, kPairPatient, aims, kRings + 1, patch)) return Outcome::done;
    const std::uint64_t most = kAllPairs + o.state.mesh.liveCount() / kTrianglesAPair;
    while (cure.first < ahead.edits.size() && cure.firsts < kFirsts && ahead.tried < most) {
      const std::uint32_t first = cure.first, second = cure.second++;
      const EditReport report = reportOn(o, Rule::cure_pair);
      const TriedPair pair = tryPair(o, ahead.edits[first], second, patch, aims);
      const bool over = !pair.firstPossible || cure.second >= pair.offered || cure.tried + 1 >= kSeconds;
      ++ahead.tried;
      if (pair.tried) ++cure.tried;
      if (pair.tried && pair.tried->penalty.beyond < kCured) return keep(o, report, *pair.tried, patch);
      if (pair.tried) takeNote(cure, pair.tried->penalty.sum, first, second);
      if (over) {
        cure.firsts += cure.tried > 0 ? 1 : 0;
        cure.tried = 0;
        cure.second = 0;
        ++cure.first;
      }
      if (pair.tried) return giveBack(o, report, *pair.tried);
    }
    if (cure.any && cure.best < kBetter * cure.before) {
      const EditReport report = reportOn(o, Rule::cure_pair);
      const TriedPair pair = tryPair(o, ahead.edits[cure.bestFirst], cure.bestSecond, patch, aims);
      if (pair.tried) return keep(o, report, *pair.tried, patch);
    }
    giveUp(o);
  }
}

}  // namespace triscope
