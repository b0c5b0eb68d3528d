#include "core/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/counted.h"
#include "core/estimate.h"
#include "core/pipeline.h"
#include "core/quality/bound_figure.h"

namespace triscope {
namespace {

std::string capitalised(std::string_view text) {
  std::string result(text);
  if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

/// "1.98": four significant digits are what a reader can compare at a glance.
std::string number(double value) { return fmt::format("{:.4g}", value); }

std::string place(Point p) { return fmt::format("({}, {})", number(p.x), number(p.y)); }

/// "triangle 5790", or a stand-in where no triangle is named.
std::string triangle(std::uint32_t id) {
  return id == kNoId ? std::string("the boundary") : fmt::format("triangle {}", id);
}

/// ", triangle 12", or nothing where no other triangle is named.
std::string named(std::uint32_t id) { return id == kNoId ? std::string() : fmt::format(", triangle {}", id); }

/// "its circumradius R = 2.31 is not below its shortest edge e = 1.98"
std::string reasonOf(const Event& e) {
  const std::string m = number(e.measured);
  const std::string l = number(e.limit);
  switch (e.rule) {
    case Rule::step1:
      return fmt::format("its circumradius R = {} is not below the edge length h = {} wanted at the circumcentre", m,
                         l);
    case Rule::step2:
      return fmt::format("its circumradius R = {} is not below h = {}, the smallest edge length wanted at its corners",
                         m, l);
    case Rule::step3:
      return fmt::format("its circumradius R = {} is not below its shortest edge e = {}", m, l);
    case Rule::step4:
      return fmt::format("its circumradius R = {} is not below the shortest edge e = {} of its neighbour{}", m, l,
                         named(e.other));
    case Rule::step5:
      return fmt::format(
          "its apex lies {} from the middle of the edge shared with its neighbour{}: not nearer than that one's "
          "shortest "
          "edge and height, e + height = {}",
          m, named(e.other), l);
    default:
      return std::string(describe(e.rule));
  }
}

/// What the decision did to the triangulation: " 4 triangles gave way to 6."
std::string effectOf(const Event& e) {
  if (e.createdCount == 0) return {};
  if (e.removedCount == 0) return fmt::format(" It made {}.", counted(e.createdCount, "triangle", "triangles"));
  return fmt::format(" {} gave way to {}.", capitalised(counted(e.removedCount, "triangle", "triangles")),
                     grouped(e.createdCount));
}

/// " off vertex 12" for a point of a front.
std::string offVertex(const Event& e) {
  return e.other == kNoId ? std::string() : fmt::format(" off vertex {}", e.other);
}

std::string insertion(const Event& e) {
  const std::string rule = capitalised(name(e.rule));
  switch (e.rule) {
    case Rule::initial:
      return fmt::format("Vertex {}, a boundary point, joined the triangulation.", e.vertex) + effectOf(e);
    case Rule::first_front:
    case Rule::second_front:
      return fmt::format("{}: vertex {} was placed at {}{}, {}.", rule, e.vertex, place(e.at), offVertex(e),
                         describe(e.rule)) +
             effectOf(e);
    case Rule::repair:
      return fmt::format("{} put vertex {} at {}, near {}: {}.", rule, e.vertex, place(e.at), triangle(e.subject),
                         describe(e.rule)) +
             effectOf(e);
    case Rule::step5:
      return fmt::format("{} put vertex {} across an edge of {}: {}.", rule, e.vertex, triangle(e.subject),
                         reasonOf(e)) +
             effectOf(e);
    default:
      return fmt::format("{} put vertex {} at the circumcentre of {}: {}.", rule, e.vertex, triangle(e.subject),
                         reasonOf(e)) +
             effectOf(e);
  }
}

/// Why not: the refusal, with its figures where it was a comparison.
std::string refusalOf(const Event& e) {
  std::string why(describe(e.refusal));
  switch (e.refusal) {
    case Refusal::too_close:
    case Refusal::edge_below_minimum:
      return fmt::format("{} ({} < {})", why, number(e.measured), number(e.limit));
    case Refusal::too_many_triangles:
      return fmt::format("{} ({} > {:.0f})", why, roughCount(e.measured), e.limit);
    case Refusal::star_worse:  // in aspect ratio, or else in one of the measures that the event does not name
      return e.measured > e.limit ? fmt::format("{} (aspect ratio {:.4g}, now {:.4g})", why, e.measured, e.limit)
                                  : why + " (in obtuse angles, area ratio or edge ratio)";
    default:
      return why;
  }
}

/// A point that was not put in. The figures of steps 1-5 are the rule's, those of the fronts the refusal's.
std::string refused(const Event& e) {
  const std::string rule = capitalised(name(e.rule));
  if (e.rule == Rule::repair)
    return fmt::format("{} left {} alone: every edit tried around it leaves as much broken.", rule,
                       triangle(e.subject));
  if (e.rule >= Rule::step1 && e.rule <= Rule::step5)
    return fmt::format("{} proposed a vertex at {} for {}, because {}; it was refused: {}.", rule, place(e.at),
                       triangle(e.subject), reasonOf(e), describe(e.refusal));
  return fmt::format("{} proposed a vertex at {}{}, and it was refused: {}.", rule, place(e.at), offVertex(e),
                     refusalOf(e));
}

std::string movement(const Event& e) {
  std::string text = fmt::format("{}: vertex {} moved by {} to {}: {}.", capitalised(name(e.rule)), e.vertex,
                                 number(distance(e.from, e.at)), place(e.at), describe(e.rule));
  // Step 6 measures the triangles around it before and after.
  if (e.stage == Stage::refine && e.limit > 0.0)
    text += fmt::format(" The worst aspect ratio around it went from {:.4g} to {:.4g}.", e.limit, e.measured);
  return text;
}

std::string constraint(const Event& e) {
  return fmt::format("An edge length of {} is wanted at {}: {}.", number(e.measured), place(e.at), describe(e.rule));
}

/// " beside cell 4" where the decision follows from a neighbour.
std::string besideCell(const Event& e) {
  const bool neighbour = e.rule == Rule::advancing_front || e.rule == Rule::balance;
  return neighbour && e.other != kNoId ? fmt::format(" beside cell {}", e.other) : std::string();
}

std::string ranking(const Event& e) {
  std::string text = fmt::format("Cell {} took density rank {}", e.subject, number(e.measured));
  if (e.limit > 0.0 && e.limit != e.measured) text += fmt::format(" instead of {}", number(e.limit));
  return text + besideCell(e) + fmt::format(": {}.", describe(e.rule));
}

struct Leaves {
  std::uint64_t cells = 0;
  int lowest = 0;  // density ranks among those that the domain meets
  int highest = 0;
};

Leaves leavesOf(const Quadtree& tree) {
  Leaves leaves;
  for (const Cell& cell : tree.cells) {
    if (cell.child >= 0) continue;
    ++leaves.cells;
    if (cell.type == CellType::outside) continue;
    leaves.lowest = leaves.lowest == 0 ? cell.density : std::min<int>(leaves.lowest, cell.density);
    leaves.highest = std::max<int>(leaves.highest, cell.density);
  }
  return leaves;
}

}  // namespace

std::string captionOf(const Event& e) {
  const std::string stage = capitalised(infoOf(e.stage).name);
  switch (e.kind) {
    case EventKind::stage_begun:
      if (e.round > 0) return fmt::format("{} begins, round {}: it {}.", stage, e.round, infoOf(e.stage).does);
      return fmt::format("{} begins: it {}.", stage, infoOf(e.stage).does);
    case EventKind::stage_finished:
      if (e.subject > 0) return fmt::format("{} is over after {}.", stage, counted(e.subject, "change", "changes"));
      return fmt::format("{} is over{}.", stage, e.stage >= Stage::step1 ? ": it had nothing to change" : "");
    case EventKind::constraint_found:
      return constraint(e);
    case EventKind::cell_split:
      return fmt::format("Cell {} was split into four{}: {}.", e.subject, besideCell(e), describe(e.rule));
    case EventKind::cell_ranked:
      return ranking(e);
    case EventKind::boundary_point:
      return fmt::format("Boundary point {} was placed at {} on curve {}, where edges of h = {} are wanted.", e.other,
                         place(e.at), e.subject, number(e.measured));
    case EventKind::vertex_inserted:
      return insertion(e);
    case EventKind::vertex_refused:
      return refused(e);
    case EventKind::edge_split:
      return fmt::format("Boundary edge {} was split at vertex {}: {}.", e.subject, e.vertex, describe(e.rule)) +
             effectOf(e);
    case EventKind::vertex_removed:
      return fmt::format("Vertex {} was removed: {}.", e.vertex, describe(e.rule));
    case EventKind::triangle_removed:
      return fmt::format("Triangle {} was removed: {}.", e.subject, describe(e.rule));
    case EventKind::edge_flipped:
      return fmt::format("The edge between triangles {} and {} was flipped: {}.", e.subject, e.other, describe(e.rule));
    case EventKind::vertex_moved:
      return movement(e);
    case EventKind::vertex_kept:
      return fmt::format("{}: vertex {} stays where it is, because {}.", capitalised(name(e.rule)), e.vertex,
                         refusalOf(e));
    case EventKind::failure:
      return fmt::format("{} cannot go on at {}{}.", stage, place(e.at),
                         e.refusal == Refusal::none ? std::string() : ": " + refusalOf(e));
  }
  return {};
}

std::string captionOf(const Event& e, const MeshState& state) {
  const std::string stage = capitalised(infoOf(e.stage).name);
  const std::string triangles = counted(state.mesh.liveCount(), "triangle", "triangles");
  switch (e.stage) {
    case Stage::constraints:
      return fmt::format("{} are done: {} found, Δx = {}.", stage, grouped(state.constraints.size()),
                         number(state.minEdge));
    case Stage::quadtree:
      return fmt::format("{} is done: {}.", stage, counted(leavesOf(state.tree).cells, "leaf cell", "leaf cells"));
    case Stage::density: {
      const Leaves leaves = leavesOf(state.tree);
      return fmt::format(
          "{} is done: {}, ranks {}–{}, {} estimated, {} of memory.", stage,
          counted(leaves.cells, "leaf cell", "leaf cells"), leaves.lowest, leaves.highest,
          counted(static_cast<std::uint64_t>(std::llround(state.estimatedTriangles)), "triangle", "triangles"),
          bytesText(estimateOf(state).bytes));
    }
    case Stage::boundary:
      return fmt::format(
          "{} are done: {} placed between those of the input.", stage,
          std::count_if(state.boundary.begin(), state.boundary.end(), [](const BoundaryPoint& p) { return !p.kept; }));
    case Stage::triangulation:
      return fmt::format("{} is done: {}, those outside the domain among them.", stage, triangles);
    case Stage::recovery:
      return e.subject == 0 ? fmt::format("{} is done: no boundary edge was missing.", stage)
                            : fmt::format("{} is done: {} split.", stage, counted(e.subject, "edge was", "edges were"));
    case Stage::carve:
      return fmt::format("{} is done: {} outside gave way, {} stay.", stage, grouped(e.subject),
                         grouped(state.mesh.liveCount()));
    case Stage::repair:
      if (e.subject == 0) return fmt::format("{} is done: nothing was mended; {}.", stage, triangles);
      return fmt::format("{} is done: {}, {}.", stage, counted(e.subject, "edit", "edits"), triangles);
    case Stage::refine:
      return fmt::format("{} is done: {} in it, {}.", stage, counted(e.subject, "change", "changes"), triangles);
    case Stage::finished:
      break;
    default:  // fronts, steps 1 to 5
      if (e.subject == 0) return fmt::format("{} is done: it had nothing to change; {}.", stage, triangles);
      return fmt::format("{} is done: {} inserted, {}.", stage, counted(e.subject, "point", "points"), triangles);
  }
  return {};
}

std::string summaryOf(const MeshState& state, const Quality& q) {
  if (state.failed && state.estimatedTriangles > state.settings.maxTriangles)
    return fmt::format("Stopped before a mesh of about {} triangles was made: {} are allowed.",
                       roughCount(state.estimatedTriangles),
                       grouped(static_cast<std::uint64_t>(state.settings.maxTriangles)));
  if (state.failed)
    return fmt::format("The method stopped in {}; the mesh is shown as it was then.", infoOf(state.stage).name);
  const std::string stage = capitalised(infoOf(state.stage).name);
  if (state.stage != Stage::finished) {
    if (state.cursor.begun) return fmt::format("{} goes on.", stage);
    return fmt::format("{} comes next: it {}.", stage, infoOf(state.stage).does);
  }
  return fmt::format(
      "Finished after {}: {}, {} of them obtuse. {} of the paper: aspect {}, area ratio {}, edge ratio {}, angles from "
      "{}° to {}°.",
      counted(state.tick, "decision", "decisions"), counted(q.triangles, "triangle", "triangles"),
      q.obtuse == 0 ? std::string("none") : grouped(q.obtuse),
      q.withinBounds() ? "Within all bounds" : "Not within all bounds", besideBound(q.aspectMax, Bounds::aspect, 2),
      besideBound(q.areaRatioMax, Bounds::areaRatio, 2), besideBound(q.edgeRatioMax, Bounds::edgeRatio, 2),
      besideBound(q.minAngle, Bounds::minAngle, 1), besideBound(q.maxAngle, Bounds::maxAngle, 1));
}

}  // namespace triscope
