#include "core/mesh/edit_log.h"

#include <gtest/gtest.h>

#include "core/domain/curve.h"
#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/collapse_edge.h"
#include "core/mesh/edit.h"
#include "core/mesh/slide.h"
#include "core/mesh/split_edge.h"
#include "core/mesh/validate.h"
#include "support/domains.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::edit_log_test {
namespace {

using support::Random;

/// What is wrong but for the Delaunay property and triangles that lie wrong way round: edits of the links alone leave
/// those to their callers.
std::string brokenLinks(const Mesh& mesh) {
  for (const Violation& violation : validate(mesh, 1000))
    if (violation.what == Broken::link || violation.what == Broken::vertex || violation.what == Broken::boundary)
      return violation.message;
  return {};
}

/// One edit somewhere in the mesh; false when it was not possible.
bool editSomewhere(MeshState& state, Random& random, EditLog& log) {
  Mesh& mesh = state.mesh;
  const Slot slot(random.below(mesh.triangles.size()));
  if (!mesh.alive(slot)) return false;
  const Half half = halfOf(slot, static_cast<int>(random.below(3)));
  const Half across = oppositeOf(mesh, half);
  const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
  const Point middle = midpoint(pointOf(mesh, a), pointOf(mesh, b));
  switch (random.below(5)) {
    case 0:
      if (!across.exists() || constrained(mesh, half) ||
          edgeBetween(mesh, apexOf(mesh, half), apexOf(mesh, across)).exists())
        return false;
      flipEdge(mesh, half, log);
      return true;
    case 1:
      if (!across.exists() || constrained(mesh, half)) return false;
      splitInnerEdge(mesh, half, middle, 1, log);
      return true;
    case 2: {
      if (!constrained(mesh, half)) return false;
      const EdgeId edge = findBoundaryEdge(mesh, a, b);
      const double t = 0.5 * (mesh.edges[edge].t0 + mesh.edges[edge].t1);
      splitBorderEdge(mesh, half, edge, t, pointAt(state.domain->curves[mesh.edges[edge].curve], t), 1, log);
      return true;
    }
    case 3:
      return (!mesh.vertexEdge[a].exists() || onCurve(mesh, a)) && collapseEdge(mesh, a, b, log);
    default: {
      const std::optional<OnCurve> place = onCurve(mesh, a);
      if (!place) {
        movePoint(mesh, a, middle, log);
        return true;
      }
      const double t = random.between(mesh.edges[place->before].t0, mesh.edges[place->after].t1);
      slideVertex(mesh, a, *place, t, pointAt(state.domain->curves[place->curve], t), log);
      return true;
    }
  }
}

TEST(EditLog, GivesBackTheVeryMeshWhateverWasEdited) {
  for (const char* const text : {support::kFrame, support::kCrackedFrame, support::kRound}) {
    MeshState state = support::after(support::domainFrom(text), Stage::step2);
    Random random{71};
    EditLog log;
    int made = 0;
    for (int k = 0; k < 150; ++k) {
      const Mesh before = state.mesh;
      beginEdits(log);
      const EditMark mark = markOf(state.mesh, log);
      for (std::size_t n = 1 + random.below(12); n-- > 0;) {
        made += editSomewhere(state, random, log) ? 1 : 0;
        ASSERT_EQ(brokenLinks(state.mesh), "");
      }
      undoEdits(state.mesh, log, mark);
      ASSERT_EQ(support::difference(state.mesh, before), "") << "after " << made << " edits of " << text;
      // Every now and then one stays, so that what comes next begins from an edited mesh.
      if (k % 5 == 0) {
        editSomewhere(state, random, log);
        ASSERT_EQ(brokenLinks(state.mesh), "");
      }
    }
    EXPECT_GT(made, 200);
  }
}

TEST(EditLog, TellsFollowersOfNoSlotThatCameAndWent) {
  MeshState state = support::after(support::domainFrom(support::kRound), Stage::step2);
  Random random{5};
  EditLog log;
  ChangeLog changes(state.mesh);
  beginEdits(log);
  const EditMark mark = markOf(state.mesh, log);
  for (int k = 0; k < 60; ++k) editSomewhere(state, random, log);
  ASSERT_GT(state.mesh.triangles.size(), mark.allSlots);
  undoEdits(state.mesh, log, mark);
  EXPECT_FALSE(changes.slots().empty());
  for (const Slot slot : changes.slots()) EXPECT_TRUE(state.mesh.triangles.has(slot));
}

TEST(EditLog, GivesBackTheMeshOfAMarkOnTheWay) {
  MeshState state = support::after(support::domainFrom(support::kRound), Stage::step2);
  Random random{5};
  EditLog log;
  beginEdits(log);
  for (int k = 0; k < 40; ++k) editSomewhere(state, random, log);
  const Mesh half = state.mesh;
  const EditMark mark = markOf(state.mesh, log);
  for (int k = 0; k < 40; ++k) editSomewhere(state, random, log);
  undoEdits(state.mesh, log, mark);
  EXPECT_EQ(support::difference(state.mesh, half), "");
}

TEST(SplitEdge, PutsAVertexIntoTheBoundaryOnItsCurve) {
  const support::DomainPtr domain = support::domainFrom(support::kRound);
  MeshState state = support::after(domain, Stage::step2);
  Mesh& mesh = state.mesh;
  EditLog log;
  int split = 0;
  for (const Slot slot : support::liveSlots(mesh)) {
    for (const Half half : halvesOf(slot)) {
      if (split == 10 || oppositeOf(mesh, half).exists()) continue;
      const EdgeId edge = findBoundaryEdge(mesh, startOf(mesh, half), endOf(mesh, half));
      const BoundaryEdge was = mesh.edges[edge];
      const double t = 0.5 * (was.t0 + was.t1);
      const Point at = pointAt(domain->curves[was.curve], t);
      const Vertex middle = splitBorderEdge(mesh, half, edge, t, at, 1, log);
      EXPECT_EQ(pointOf(mesh, middle), at);
      const std::optional<OnCurve> place = onCurve(mesh, middle);
      ASSERT_TRUE(place);
      EXPECT_EQ(place->t, t);
      EXPECT_EQ(mesh.edges[place->before].v0, was.v0);
      EXPECT_EQ(mesh.edges[place->after].v1, was.v1);
      ASSERT_EQ(brokenLinks(mesh), "");
      // Merged again, the edge is what it was, and so is the mesh but for what was born meanwhile.
      const std::size_t live = mesh.liveCount();
      ASSERT_TRUE(collapseEdge(mesh, middle, was.v1, log));
      EXPECT_EQ(mesh.liveCount(), live - 1);
      const EdgeId merged = findBoundaryEdge(mesh, was.v0, was.v1);
      ASSERT_TRUE(merged.exists());
      EXPECT_EQ(mesh.edges[merged].t0, was.t0);
      EXPECT_EQ(mesh.edges[merged].t1, was.t1);
      ASSERT_EQ(brokenLinks(mesh), "");
      ++split;
    }
  }
  EXPECT_EQ(split, 10);
}

TEST(CollapseEdge, RefusesWhatWouldBeNoTriangulation) {
  // Three triangles around a vertex inside: the outline is the only other triangle there could be.
  Mesh mesh = support::meshOf({{0, 0}, {4, 0}, {2, 4}, {2, 1}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EditLog log;
  const Mesh before = mesh;
  EXPECT_FALSE(collapseEdge(mesh, Vertex(0), Vertex(1), log)) << "the input's own point";
  EXPECT_EQ(support::difference(mesh, before), "");
  EXPECT_TRUE(collapseEdge(mesh, Vertex(3), Vertex(0), log)) << "the outline stays";
  EXPECT_EQ(mesh.liveCount(), 1u);
}

}  // namespace
}  // namespace triscope::edit_log_test
