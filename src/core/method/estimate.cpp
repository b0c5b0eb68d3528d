#include "core/method/estimate.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace triscope {
namespace {

// What Mesh keeps for a triangle and for a vertex. A mesh has half as many vertices as triangles.
constexpr std::size_t kPerTriangle =
    sizeof(decltype(Mesh::triangles)::value_type) + sizeof(decltype(Mesh::ids)::value_type) +
    sizeof(decltype(Mesh::flags)::value_type) + sizeof(decltype(Mesh::tested)::value_type);
constexpr std::size_t kPerVertex =
    sizeof(decltype(Mesh::points)::value_type) + sizeof(decltype(Mesh::kinds)::value_type) +
    sizeof(decltype(Mesh::density)::value_type) + sizeof(decltype(Mesh::vertexTriangle)::value_type) +
    sizeof(decltype(Mesh::vertexEdge)::value_type);
constexpr double kCopies = 2.0;  // the mesh itself, and its vertices and triangles in the order they are written in

}  // namespace

Estimate estimateOf(const MeshState& state) {
  const double triangles = state.estimatedTriangles;
  const double mesh = triangles * (static_cast<double>(kPerTriangle) + 0.5 * static_cast<double>(kPerVertex));
  return {triangles, kCopies * mesh + static_cast<double>(state.tree.cells.size() * sizeof(Cell))};
}

std::string bytesText(double bytes) {
  constexpr std::array<std::string_view, 7> kUnits{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < kUnits.size(); ++unit) bytes /= 1000.0;
  return fmt::format("{:.{}f} {}", bytes, bytes < 9.95 && unit > 0 ? 1 : 0, kUnits[unit]);
}

std::string roughCount(double count) {
  if (count < 999'500.0) return fmt::format("{:.0f}", count);
  if (count < 999.5e6) return fmt::format("{:.3g} million", count / 1e6);
  if (count < 999.5e9) return fmt::format("{:.3g} billion", count / 1e9);
  return fmt::format("{:.2g}", count);
}

}  // namespace triscope
