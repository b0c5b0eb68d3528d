// triscope check: judges any mesh file by the paper's bounds and the rules of validity.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/base/index_text.h"
#include "core/domain/read.h"
#include "core/explain/bound_text.h"
#include "core/explain/fields.h"
#include "core/io/against_domain.h"
#include "core/io/mesh_from.h"
#include "core/io/read_mesh.h"
#include "core/mesh/validate.h"
#include "core/quality/quality.h"

namespace triscope {
namespace {

void printCount(std::string_view key, std::size_t value) { answer("{:<18} {}\n", key, value); }

/// One bounded figure, with the bound, the verdict, where the worst triangle is and what excuses it.
void printBounded(const Mesh& mesh, const Quality& quality, const WorstMeasure& worst) {
  const std::string key = fmt::format("{}_{}", worst.key, worst.key.ends_with("angle") ? "deg" : "max");
  answer("{:<18} {:<12.7g} {:<7} {:<8}", key, worst.value, limitText(worst), worst.met() ? "met" : "not met");
  if (worst.slot.exists())
    answer(" triangle {} at {}", idOf(mesh, worst.slot), placeText(centroidOf(mesh, worst.slot)));
  const std::string excuse = excuseText(mesh, quality, worst);
  answer("{}{}\n", excuse.empty() ? "" : ", ", excuse);
}

void printFigures(const Mesh& mesh, const Quality& q) {
  printCount("vertices", q.vertices);
  printCount("triangles", q.triangles);
  printCount("boundary_vertices", q.boundaryVertices);
  printCount("obtuse", q.obtuse);
  answer("{:<18} {:.10g}\n", "area", q.area);
  answer("{:<18} {:.7g}\n", "min_edge_length", q.minEdge);
  for (const WorstMeasure& worst : worstOf(q)) printBounded(mesh, q, worst);
}

/// Prints the verdict and what is wrong. True when nothing is.
bool printVerdict(std::string_view key, const std::vector<Violation>& violations) {
  answer("{:<18} {}\n", key, violations.empty() ? "yes" : "no");
  for (const Violation& violation : violations) {
    const std::string place = violation.at ? fmt::format("at {}: ", placeText(*violation.at)) : "";
    answer("  {}{}\n", place, violation.message);
  }
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
  for (const std::string& note : notes) say("note: {}\n", note);

  const Quality quality = measure(*mesh);
  printFigures(*mesh, quality);
  bool good = quality.withinBounds();
  good = printVerdict("valid", validate(*mesh)) && good;
  if (!options.domain.empty()) good = printVerdict("of_the_domain", strays) && good;
  return good ? ExitCode::ok : ExitCode::unmet;
}

}  // namespace triscope
