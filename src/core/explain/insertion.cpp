#include "core/explain/insertion.h"

#include <fmt/format.h>

#include <array>

#include "core/base/index_text.h"
#include "core/explain/fields.h"
#include "core/mesh/edit.h"
#include "core/mesh/locate.h"

namespace triscope {
namespace {

bool isStep(Rule rule) { return wordsOf(rule).family == Family::step; }

/// Where the stage began to walk: at the candidate, at the vertex that a front's point stands off, or where the last
/// insertion left off.
Slot startOfWalk(const Mesh& mesh, const Insertion& insertion) {
  if (insertion.candidate.exists()) return insertion.candidate;
  if (insertion.owner.exists()) return mesh.vertexTriangle[insertion.owner];
  return mesh.lastTriangle;
}

/// A boundary edge as a half-edge of the triangulation, none when that lacks it.
Half halfAlong(const Mesh& mesh, EdgeId edge) {
  if (!mesh.edges.has(edge)) return {};
  const BoundaryEdge& e = mesh.edges[edge];
  return exists(e) ? edgeBetween(mesh, e.v0, e.v1) : Half();
}

/// Step 5 measures from the middle of the edge shared with the other triangle to the candidate's apex.
Measured overEdge(const Mesh& mesh, const Insertion& insertion) {
  const Event& event = insertion.event;
  Measured measured{event.at, event.at, event.measured, event.limit, TriangleId(event.other)};
  for (int i = 0; i < 3; ++i) {
    const Half half = halfOf(insertion.candidate, i);
    const Half across = oppositeOf(mesh, half);
    if (!across.exists() || idOf(mesh, triangleOf(across)) != measured.limitFrom) continue;
    measured.from = midpoint(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)));
    measured.to = pointOf(mesh, apexOf(mesh, half));
  }
  return measured;
}

std::optional<Measured> measuredBy(const Mesh& mesh, const Insertion& insertion) {
  const Event& event = insertion.event;
  if (isStep(event.rule) && insertion.candidate.exists()) {
    if (event.rule == Rule::step5) return overEdge(mesh, insertion);
    const Point corner = pointOf(mesh, triangleAt(mesh, insertion.candidate).v[0]);
    return Measured{event.at, corner, event.measured, event.limit, TriangleId(event.other)};
  }
  if (insertion.owner.exists() && event.limit > 0.0)
    return Measured{event.at, pointOf(mesh, insertion.owner), event.measured, event.limit, {}};
  return std::nullopt;
}

std::string candidateCaption(const Insertion& insertion) {
  const Event& e = insertion.event;
  if (insertion.splits.exists())
    return fmt::format("A boundary edge is to be split at {}, half way along its curve: {}.", shortPlace(insertion.at),
                       describe(e.rule));
  if (!insertion.measured)
    return fmt::format("A point is to go in at {}: {}.", shortPlace(insertion.at), describe(e.rule));
  const Measured& m = *insertion.measured;
  if (insertion.owner.exists())
    return fmt::format(
        "A point off vertex {} is to go in at {}, {} away. No other vertex may be nearer to it than {} (dashed).",
        insertion.owner, shortPlace(insertion.at), shortNumber(m.length), shortNumber(m.limit));
  const std::string other = !m.limitFrom.exists() ? std::string() : fmt::format(" of triangle {}", m.limitFrom);
  const std::string_view limit = wordsOf(e.rule).limit;
  if (e.rule == Rule::step5)
    return fmt::format(
        "Triangle {} is the candidate. Its apex lies {} from the middle of the edge that it shares with triangle {}; "
        "the limit is that one's {} = {} (dashed).",
        e.subject, shortNumber(m.length), m.limitFrom, limit, shortNumber(m.limit));
  return fmt::format("Triangle {} is the candidate. Its circumcircle has R = {}; the limit is {}{} = {} (dashed).",
                     e.subject, shortNumber(m.length), limit, other, shortNumber(m.limit));
}

std::string walkCaption(const Insertion& insertion, const Mesh& mesh) {
  if (insertion.walk.empty())
    return fmt::format("The point lies on the boundary edge itself, at {}: there is no way to look for.",
                       shortPlace(insertion.at));
  const TriangleId first = idOf(mesh, insertion.walk.front());
  const TriangleId last = idOf(mesh, insertion.walk.back());
  if (insertion.walk.size() == 1)
    return fmt::format("Triangle {} holds the point {} itself: the walk is over where it begins.", first,
                       shortPlace(insertion.at));
  return fmt::format("From triangle {} the walk crosses {} {} to triangle {}, which holds the point {}.", first,
                     insertion.walk.size() - 1, insertion.walk.size() == 2 ? "edge" : "edges", last,
                     shortPlace(insertion.at));
}

std::string cavityCaption(const Insertion& insertion) {
  const std::size_t n = insertion.cavity.triangleCount;
  return fmt::format(
      "The cavity: {} {} the point in {} and can be reached without crossing the boundary. {} rim {} stay.", n,
      n == 1 ? "triangle has" : "triangles have", n == 1 ? "its circumcircle" : "their circumcircles",
      insertion.cavity.rimCount, insertion.cavity.rimCount == 1 ? "edge" : "edges");
}

std::string filledCaption(const Insertion& insertion) {
  const Event& e = insertion.event;
  const std::size_t gone = insertion.cavity.triangleCount;
  std::string text =
      fmt::format("Vertex {} is joined to every rim edge: {} {} gave way to {}, from triangle {} on.", e.vertex, gone,
                  gone == 1 ? "triangle" : "triangles", insertion.cavity.rimCount, e.created);
  if (e.createdCount > insertion.cavity.rimCount)
    text += " Edges were flipped after that, because the point on the curve lies off the chord.";
  return text;
}

}  // namespace

std::string_view name(InsertionPhase phase) {
  constexpr std::array<std::string_view, kInsertionPhases> kNames{"candidate", "walk", "cavity", "new triangles"};
  return kNames[static_cast<std::size_t>(phase) - 1];
}

std::optional<Insertion> takeApart(const MeshState& before, const Event& event) {
  if (before.mesh.triangles.empty() || !inserts(event)) return std::nullopt;
  Mesh mesh = before.mesh;  // to look for the cavity marks triangles
  Insertion insertion;
  insertion.event = event;
  insertion.at = event.at;
  const bool split = event.kind == EventKind::edge_split;
  const bool front = wordsOf(event.rule).family == Family::front;
  const bool row = wordsOf(event.rule).family == Family::row && event.subject != kNoId;
  if (isStep(event.rule) || row || (event.rule == Rule::repair && !split))
    insertion.candidate = slotOf(mesh, TriangleId(event.subject));
  if (front && event.other != kNoId) insertion.owner = Vertex(event.other);
  if (split && event.rule != Rule::recover_edge) insertion.splits = halfAlong(mesh, EdgeId(event.subject));
  insertion.measured = measuredBy(mesh, insertion);
  if (insertion.splits.exists()) {
    findSplitCavity(mesh, insertion.at, insertion.splits, insertion.cavity);
    return insertion;
  }
  const Location location = walkTo(mesh, startOfWalk(mesh, insertion), insertion.at, &insertion.walk);
  findCavity(mesh, insertion.at, location.triangle, insertion.cavity);
  return insertion;
}

std::string captionOf(const Insertion& insertion, const Mesh& before, InsertionPhase phase) {
  switch (phase) {
    case InsertionPhase::candidate:
      return candidateCaption(insertion);
    case InsertionPhase::walk:
      return walkCaption(insertion, before);
    case InsertionPhase::cavity:
      return cavityCaption(insertion);
    case InsertionPhase::filled:
      return filledCaption(insertion);
  }
  return {};
}

}  // namespace triscope
