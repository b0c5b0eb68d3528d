#include "core/mesh/trial.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

void measureWhole(Trial& trial) {
  trial.whole = {};
  trial.broken.clear();
  const Mesh& mesh = trial.unedited;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Breach breach = breachOf(mesh, slot);
    trial.whole.shortest = std::min(trial.whole.shortest, breach.shortest);
    if (breach.broken == 0) continue;
    trial.whole.broken += breach.broken;
    trial.whole.excess += breach.excess;
    trial.broken.push_back({slot, breach});
  }
}

}  // namespace

void beginTrial(Trial& trial, const Mesh& from) {
  trial.unedited = from;
  trial.mesh = from;
  trial.mesh.touched.emplace();
  measureWhole(trial);
}

void keepEdit(Trial& trial) {
  trial.unedited = trial.mesh;
  trial.unedited.touched.reset();
  trial.mesh.touched->clear();
  measureWhole(trial);
}

Breach judgeEdit(Trial& trial, int most) {
  const Mesh& mesh = trial.mesh;
  trial.inRegion.resize(mesh.triangles.size(), 0);
  trial.region.clear();
  const auto take = [&](Slot slot) {
    if (trial.inRegion[slot] != 0) return;
    trial.inRegion[slot] = 1;
    trial.region.push_back(slot);
  };
  for (const Slot slot : *mesh.touched) take(slot);
  // A pair is counted by the lower of its slots, so those beside the touched ones may count otherwise now.
  const std::size_t edited = trial.region.size();
  for (std::size_t k = 0; k < edited; ++k) {
    if (!mesh.alive(trial.region[k])) continue;
    for (const Half across : triangleAt(mesh, trial.region[k]).adj) {
      if (across.exists()) take(triangleOf(across));
    }
  }
  Breach after;
  const auto add = [&](const Breach& breach) {
    after.broken += breach.broken;
    after.excess += breach.excess;
    after.shortest = std::min(after.shortest, breach.shortest);
  };
  for (const Trial::Broken& broken : trial.broken) {
    if (trial.inRegion.has(broken.slot) && trial.inRegion[broken.slot] == 0) add(broken.breach);
  }
  for (const Slot slot : trial.region) {
    if (after.broken <= most && mesh.alive(slot)) add(breachOf(mesh, slot));
    trial.inRegion[slot] = 0;
  }
  return after;
}

void takeBack(Trial& trial) {
  const Mesh& from = trial.unedited;
  Mesh& mesh = trial.mesh;
  const std::size_t vertices = from.points.size();
  const std::size_t slots = from.triangles.size();
  TRISCOPE_CHECK(mesh.points.size() >= vertices && mesh.triangles.size() >= slots && mesh.nextId >= from.nextId,
                 "what an edit adds comes after what there was");
  mesh.points.resize(vertices);
  mesh.kinds.resize(vertices);
  mesh.density.resize(vertices);
  mesh.vertexTriangle.resize(vertices);
  mesh.vertexEdge.resize(vertices);
  mesh.triangles.resize(slots);
  mesh.ids.resize(slots);
  mesh.flags.resize(slots);
  mesh.tested.resize(slots);
  if (mesh.edges.size() != from.edges.size()) mesh.edges = from.edges;
  mesh.freeSlots = from.freeSlots;
  mesh.nextId = from.nextId;
  mesh.lastTriangle = from.lastTriangle;
  const auto restore = [&](Slot slot) {
    mesh.triangles[slot] = from.triangles[slot];
    mesh.ids[slot] = from.ids[slot];
    mesh.flags[slot] = from.flags[slot];
    mesh.tested[slot] = from.tested[slot];
  };
  for (const Slot slot : *mesh.touched) {
    if (!from.triangles.has(slot)) continue;
    restore(slot);
    if (!from.alive(slot)) continue;
    const Triangle& t = triangleAt(from, slot);
    for (const Half across : t.adj) {
      if (across.exists()) restore(triangleOf(across));
    }
    for (const Vertex v : t.v) {
      mesh.points[v] = from.points[v];
      mesh.kinds[v] = from.kinds[v];
      mesh.vertexTriangle[v] = from.vertexTriangle[v];
      mesh.vertexEdge[v] = from.vertexEdge[v];
    }
  }
}

}  // namespace triscope
