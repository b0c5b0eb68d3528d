#include "core/method/stages/treatment.h"

#include <algorithm>
#include <limits>

#include "core/mesh/edit.h"
#include "core/mesh/patch.h"
#include "core/mesh/trial.h"

namespace triscope {
namespace {

constexpr int kPatchDepth = 7;

bool better(const Breach& l, const Breach& r) {
  return l.broken < r.broken || (l.broken == r.broken && l.excess < r.excess * (1.0 - 1e-6));
}

/// An edit that changes which vertices there are, better or not, to try a second one after.
struct Lead {
  Breach after;
  Remedy remedy;
};
constexpr std::size_t kLeads = 6;

struct Search {
  const MeshState& state;
  double floor = 0.0;
  Breach best;
  Treatment chosen{};
  std::vector<Lead> leads;  // best first
  Room& room;
};

void takeLead(std::vector<Lead>& leads, const Breach& after, const Remedy& remedy) {
  const auto place = std::find_if(leads.begin(), leads.end(), [&](const Lead& l) { return better(after, l.after); });
  leads.insert(place, {after, remedy});
  if (leads.size() > kLeads) leads.pop_back();
}

// Tries the remedies for the trial's mesh, `first` having been made already; without one, leads are collected too.
void tryRemedies(Search& search, const Remedy& first) {
  std::vector<Remedy> remedies;
  Trial& trial = search.room.trial;
  collectRemedies(trial.unedited, remedies);
  const Slot start = firstLive(trial.unedited);
  for (const Remedy& remedy : remedies) {
    const bool lead = first.edit == MeshEdit::none && remedy.edit != MeshEdit::move;
    trial.mesh.touched->clear();
    if (applyRemedy(trial.mesh, search.state, remedy, start, search.floor, search.room).refusal != Refusal::none)
      continue;
    int most = search.best.broken;
    if (lead) {
      most = search.leads.size() < kLeads ? std::numeric_limits<int>::max()
                                          : std::max(most, search.leads.back().after.broken);
    }
    const Breach after = judgeEdit(trial, most);
    takeBack(trial);
    if (after.shortest < search.floor * search.floor) continue;
    if (better(after, search.best)) {
      search.best = after;
      search.chosen = first.edit == MeshEdit::none ? Treatment{remedy, Remedy{}} : Treatment{first, remedy};
    }
    if (search.best.broken == 0) return;  // nothing can be better
    if (lead) takeLead(search.leads, after, remedy);
  }
}

// From the patch's numbering to the mesh's. What the first edit makes has the next number in both.
template <class Id, class Value>
Id translated(Id local, const Per<Id, Id>& ofMesh, const Per<Id, Value>& all) {
  return ofMesh.has(local) ? ofMesh[local] : Id(all.next().n + local.n - ofMesh.next().n);
}

void translate(const Mesh& mesh, const Patch& patch, Remedy& remedy) {
  if (remedy.vertex.exists()) remedy.vertex = translated(remedy.vertex, patch.vertices, mesh.points);
  if (remedy.edge.exists()) remedy.edge = translated(remedy.edge, patch.edges, mesh.edges);
}

}  // namespace

Treatment bestTreatment(const MeshState& state, Slot slot, double& floor, Room& room) {
  Patch& patch = room.patch;
  Trial& trial = room.trial;
  extractPatch(state.mesh, slot, kPatchDepth, patch);
  beginTrial(trial, patch.mesh);
  floor = std::min(state.minEdge, std::sqrt(trial.whole.shortest) * (1.0 - 1e-9));
  Search search{state, floor, trial.whole, {}, {}, room};
  tryRemedies(search, {});
  for (std::size_t k = 0; search.chosen[0].edit == MeshEdit::none && k < search.leads.size(); ++k) {
    if (k > 0) beginTrial(trial, patch.mesh);
    applyRemedy(trial.mesh, state, search.leads[k].remedy, Slot(0), floor, room);
    keepEdit(trial);
    tryRemedies(search, search.leads[k].remedy);
  }
  for (Remedy& remedy : search.chosen) translate(state.mesh, patch, remedy);
  return search.chosen;
}

}  // namespace triscope
