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
  for (std::size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    const auto s = static_cast<std::int32_t>(slot);
    if (!mesh.alive(s)) continue;
    const Breach breach = breachOf(mesh, s);
    trial.whole.shortest = std::min(trial.whole.shortest, breach.shortest);
    if (breach.broken == 0) continue;
    trial.whole.broken += breach.broken;
    trial.whole.excess += breach.excess;
    trial.broken.push_back({s, breach});
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
  const auto take = [&](std::int32_t slot) {
    if (trial.inRegion[at(slot)] != 0) return;
    trial.inRegion[at(slot)] = 1;
    trial.region.push_back(slot);
  };
  for (const std::int32_t slot : *mesh.touched) take(slot);
  // A pair is counted by the lower of its slots, so those beside the touched ones may count otherwise now.
  const std::size_t edited = trial.region.size();
  for (std::size_t k = 0; k < edited; ++k) {
    if (!mesh.alive(trial.region[k])) continue;
    for (const std::int32_t across : triangleAt(mesh, trial.region[k]).adj) {
      if (across >= 0) take(triangleOf(across));
    }
  }
  Breach after;
  const auto add = [&](const Breach& breach) {
    after.broken += breach.broken;
    after.excess += breach.excess;
    after.shortest = std::min(after.shortest, breach.shortest);
  };
  for (const Trial::Broken& broken : trial.broken) {
    if (static_cast<std::size_t>(broken.slot) < trial.inRegion.size() && trial.inRegion[at(broken.slot)] == 0)
      add(broken.breach);
  }
  for (const std::int32_t slot : trial.region) {
    if (after.broken <= most && mesh.alive(slot)) add(breachOf(mesh, slot));
    trial.inRegion[at(slot)] = 0;
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
  const auto restore = [&](std::int32_t slot) {
    mesh.triangles[at(slot)] = from.triangles[at(slot)];
    mesh.ids[at(slot)] = from.ids[at(slot)];
    mesh.flags[at(slot)] = from.flags[at(slot)];
    mesh.tested[at(slot)] = from.tested[at(slot)];
  };
  for (const std::int32_t slot : *mesh.touched) {
    if (at(slot) >= slots) continue;
    restore(slot);
    if (!from.alive(slot)) continue;
    const Triangle& t = triangleAt(from, slot);
    for (const std::int32_t across : t.adj) {
      if (across >= 0) restore(triangleOf(across));
    }
    for (const std::int32_t v : t.v) {
      mesh.points[at(v)] = from.points[at(v)];
      mesh.kinds[at(v)] = from.kinds[at(v)];
      mesh.vertexTriangle[at(v)] = from.vertexTriangle[at(v)];
      mesh.vertexEdge[at(v)] = from.vertexEdge[at(v)];
    }
  }
}

}  // namespace triscope
