#include "render/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "core/base/output_set.h"
#include "core/method/pipeline.h"
#include "render/boundary_points.h"
#include "render/raster.h"
#include "render/svg.h"

namespace triscope {
namespace {

enum class Format : std::uint8_t { unknown, svg, png };

Format formatOf(std::string path) {
  std::transform(path.begin(), path.end(), path.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (path.ends_with(".svg")) return Format::svg;
  if (path.ends_with(".png")) return Format::png;
  return Format::unknown;
}

Error usage(const std::string& path, std::string message, std::string hint) {
  Error error;
  error.kind = ErrorKind::usage;
  error.file = path;
  error.message = std::move(message);
  error.hint = std::move(hint);
  return error;
}

using Cells = CellColoring;
constexpr std::string_view kBlunt = "blunt_body";
constexpr std::string_view kAirfoil = "three_element_airfoil";
// clang-format off
constexpr std::array<FigurePreset, 13> kPresets{{
    {"1a", kBlunt, Stage::constraints, 0, "", Cells::none, "Density constraints: what is strongly curved asks for the shortest edges."},
    {"1b", kBlunt, Stage::quadtree, 0, "", Cells::rank, "The quadtree, split until each cell may hold its density rank, and balanced."},
    {"1c", kBlunt, Stage::density, 24, "", Cells::rank, "An advancing front has begun to spread the ranks from the densest cells."},
    {"1d", kBlunt, Stage::density, 0, "", Cells::type, "The final quadtree and its types of cells."},
    {"4a", kBlunt, Stage::boundary, 0, "", Cells::none, "Points along the object and the outer boundary, one per edge length."},
    {"4b", kBlunt, Stage::carve, 0, "", Cells::none, "Triangulation of the boundary points, without the triangles outside."},
    {"4c", kBlunt, Stage::front2, 0, "", Cells::none, "Two fronts of points near the boundaries."},
    {"4d", kBlunt, Stage::step1, 0, "", Cells::none, "After step 1."},
    {"4e", kBlunt, Stage::step5, 0, "", Cells::none, "After the rounds of steps 2 to 5, without local refinements."},
    {"4f", kBlunt, Stage::refine, 0, "", Cells::none, "After step 6, the local refinements."},
    {"5a", kAirfoil, Stage::refine, 0, "", Cells::none, "The three-element airfoil, the whole mesh."},
    {"5b", kAirfoil, Stage::refine, 0, "slat", Cells::none, "The mesh near the slat."},
    {"5c", kAirfoil, Stage::refine, 0, "flap", Cells::none, "The mesh near the flap."},
}};
// clang-format on

}  // namespace

std::span<const FigurePreset> figurePresets() { return kPresets; }

std::optional<Box> regionAround(const Domain& domain, std::string_view loop) {
  for (const Loop& candidate : domain.loops) {
    if (candidate.name != loop) continue;
    constexpr int kSamples = 64;  // per curve
    Box box;
    for (std::uint32_t i = 0; i < candidate.curveCount; ++i) {
      const Curve& curve = domain.curves[candidate.firstCurve + i];
      for (int k = 0; k <= kSamples; ++k) box.include(pointAt(curve, static_cast<double>(k) / kSamples));
    }
    const double margin = 0.25 * std::max(box.width(), box.height());
    return Box{{box.lo.x - margin, box.lo.y - margin}, {box.hi.x + margin, box.hi.y + margin}};
  }
  return std::nullopt;
}

ViewOptions figureView(Stage stage) {
  ViewOptions view;
  view.decision = false;
  view.quadtree = makesDensity(stage);
  view.constraints = makesDensity(stage);
  view.cells = stage == Stage::constraints ? CellColoring::none : CellColoring::rank;
  view.boundaryPoints = stage >= Stage::boundary && stage <= Stage::front2;
  view.fronts = stage == Stage::front1 || stage == Stage::front2;
  view.worst = stage >= Stage::step1;
  view.obtuse = stage >= Stage::step5;
  return view;
}

std::string figureTitle(const MeshState& state, Stage stage) {
  std::string name = state.domain && !state.domain->name.empty() ? state.domain->name : std::string("domain");
  std::replace(name.begin(), name.end(), '_', ' ');
  if (stage == Stage::finished) return name;
  return fmt::format("{}, after {}", name, inRounds(stage) ? "the rounds of steps 2–5" : infoOf(stage).name);
}

std::string figureCaption(const MeshState& state, Stage stage) {
  const auto leaves = static_cast<std::uint64_t>(
      std::count_if(state.tree.cells.begin(), state.tree.cells.end(), [](const Cell& c) { return c.child < 0; }));
  if (stage <= Stage::quadtree) {
    return fmt::format("Δx = {}; {}, {}.", compact(state.minEdge),
                       counted(state.constraints.size(), "constraint", "constraints"),
                       counted(leaves, "cell", "cells"));
  }
  if (stage == Stage::density) {
    return state.estimatedTriangles > 0.0
               ? fmt::format("Δx = {}; {}; the table of density ranks estimates {}.", compact(state.minEdge),
                             counted(leaves, "cell", "cells"),
                             counted(static_cast<std::uint64_t>(std::llround(state.estimatedTriangles)), "triangle",
                                     "triangles"))
               : fmt::format("Δx = {}; {}.", compact(state.minEdge), counted(leaves, "cell", "cells"));
  }
  if (state.mesh.liveCount() == 0) {
    return fmt::format("Δx = {}; {}.", compact(state.minEdge),
                       counted(distinctBoundaryPoints(state).size(), "boundary point", "boundary points"));
  }
  const Quality q = measure(state.mesh);
  std::string text = fmt::format("Δx = {}; {}, {}", compact(state.minEdge), counted(q.vertices, "vertex", "vertices"),
                                 counted(q.triangles, "triangle", "triangles"));
  if (stage < Stage::step1) return text + ".";
  return text + fmt::format("; angles {}° to {}°, {} obtuse; aspect ratio {}, area ratio {}, edge ratio {} at worst.",
                            compact(q.minAngle), compact(q.maxAngle), grouped(q.obtuse), compact(q.aspectMax),
                            compact(q.areaRatioMax), compact(q.edgeRatioMax));
}

Result<std::string> figureOf(const std::string& path, const MeshState& state, const ViewOptions& view,
                             const FigureOptions& options) {
  const Format format = formatOf(path);
  if (format == Format::unknown) {
    return usage(path, "the name of a figure must end in .svg or .png", "choose one of them");
  }
  constexpr int kMost = 16384;
  if (options.width < 64 || options.height < 64 || options.width > kMost || options.height > kMost) {
    return usage(path, fmt::format("a figure of {} by {} pixels cannot be made", options.width, options.height),
                 fmt::format("give a width and a height between 64 and {}", kMost));
  }
  const Quality quality = measure(state.mesh);
  const Scene scene = buildScene(state, view, nullptr, &quality);
  PictureOptions picture;
  picture.title = options.title;
  picture.caption = options.caption;
  picture.legend = options.legend;
  picture.scale = options.scale;
  const Box box = options.region.value_or(scene.bounds);
  const double margin = options.region ? 0.0 : 4.0 * options.scale;
  const double aspect = box.width() > 0.0 && box.height() > 0.0 ? box.width() / box.height() : 1.0;
  const PictureLayout layout = layoutWithin(options.width, options.height, aspect, scene, picture);
  const Camera camera = fitted(box, layout.plot.width, layout.plot.height, margin);
  if (format == Format::svg) return svg(scene, camera, layout, picture);
  return encodePng(rasterize(scene, camera, layout, picture));
}

Status writeFigure(const std::string& path, const MeshState& state, const ViewOptions& view,
                   const FigureOptions& options) {
  const Result<std::string> picture = figureOf(path, state, view, options);
  return picture.ok() ? writeWhole(path, *picture) : picture.error();
}

}  // namespace triscope
