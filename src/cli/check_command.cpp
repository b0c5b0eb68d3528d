// triscope check: judges any mesh file by the paper's bounds and the rules of validity.
#include <fmt/format.h>

#include "cli/commands.h"
#include "core/domain/read.h"
#include "core/io/against_domain.h"
#include "core/io/mesh_from.h"
#include "core/io/read_mesh.h"
#include "core/mesh/validate.h"
#include "core/quality/quality.h"

namespace triscope {
namespace {

Point centroid(const Mesh& mesh, std::int32_t slot) {
  const Triangle& triangle = triangleAt(mesh, slot);
  return (1.0 / 3.0) * (pointOf(mesh, triangle.v[0]) + pointOf(mesh, triangle.v[1]) + pointOf(mesh, triangle.v[2]));
}

void printCount(std::string_view key, std::size_t value) { fmt::print("{:<18} {}\n", key, value); }

/// One bounded figure, with the bound, the verdict and where the worst triangle is.
void printBounded(const Mesh& mesh, std::string_view key, double value, std::string_view bound, bool met,
                  std::int32_t slot) {
  fmt::print("{:<18} {:<12.7g} {:<7} {:<8}", key, value, bound, met ? "met" : "not met");
  if (slot >= 0) {
    const Point at = centroid(mesh, slot);
    fmt::print(" triangle {} at ({:.6g}, {:.6g})", idOf(mesh, slot), at.x, at.y);
  }
  fmt::print("\n");
}

void printFigures(const Mesh& mesh, const Quality& q) {
  printCount("vertices", q.vertices);
  printCount("triangles", q.triangles);
  printCount("boundary_vertices", q.boundaryVertices);
  printCount("obtuse", q.obtuse);
  fmt::print("{:<18} {:.10g}\n", "area", q.area);
  fmt::print("{:<18} {:.7g}\n", "min_edge_length", q.minEdge);
  printBounded(mesh, "aspect_ratio_max", q.aspectMax, fmt::format("< {:g}", Bounds::aspect),
               q.aspectMax < Bounds::aspect, q.aspectAt);
  printBounded(mesh, "area_ratio_max", q.areaRatioMax, fmt::format("< {:g}", Bounds::areaRatio),
               q.areaRatioMax < Bounds::areaRatio, q.areaRatioAt);
  printBounded(mesh, "edge_ratio_max", q.edgeRatioMax, fmt::format("< {:g}", Bounds::edgeRatio),
               q.edgeRatioMax < Bounds::edgeRatio, q.edgeRatioAt);
  printBounded(mesh, "min_angle_deg", q.minAngle, fmt::format("> {:g}", Bounds::minAngle),
               q.minAngle > Bounds::minAngle, q.minAngleAt);
  printBounded(mesh, "max_angle_deg", q.maxAngle, fmt::format("< {:g}", Bounds::maxAngle),
               q.maxAngle < Bounds::maxAngle, q.maxAngleAt);
}

/// Prints the verdict and what is wrong. True when nothing is.
bool printVerdict(std::string_view key, const std::vector<Violation>& violations) {
  fmt::print("{:<18} {}\n", key, violations.empty() ? "yes" : "no");
  for (const Violation& violation : violations)
    fmt::print("  {} at ({:.6g}, {:.6g})\n", violation.message, violation.at.x, violation.at.y);
  return violations.empty();
}

}  // namespace

ExitCode runCommand(const CheckCommand& options) {
  const Result<MeshFile> file = readMesh(options.mesh);
  if (!file.ok()) return fail(file.error());
  std::vector<std::string> notes;
  const Result<Mesh> mesh = meshFrom(*file, &notes);
  if (!mesh.ok()) {
    Error error = mesh.error();
    error.file = options.mesh;
    return fail(error);
  }
  std::vector<Violation> strays;
  if (!options.domain.empty()) {
    const Result<Domain> domain = readDomain(options.domain);
    if (!domain.ok()) return fail(domain.error());
    strays = checkAgainstDomain(*mesh, *domain);
  }
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);

  const Quality quality = measure(*mesh);
  printFigures(*mesh, quality);
  bool good = quality.withinBounds();
  good = printVerdict("valid", validate(*mesh)) && good;
  if (!options.domain.empty()) good = printVerdict("of_the_domain", strays) && good;
  return good ? ExitCode::ok : ExitCode::unmet;
}

}  // namespace triscope
