// Runs stop where the mesh would have more triangles than Settings::maxTriangles, and what is said of one that did.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

/// The method fails if so many are more than Settings::maxTriangles.
void holdToLimit(MeshState& state, double triangles, Journal& journal);

inline constexpr std::size_t kTrianglesOfBox = 64;  // around the domain: enough for the smallest limits

/// Whether a mesh that is being made has outgrown the limit, although Table 1 promised fewer triangles: kept edges can
/// force more. Before it is carved, a part of the triangles lies outside the domain.
inline bool outgrows(const MeshState& state) {
  const std::size_t most = static_cast<std::size_t>(state.settings.maxTriangles);
  return state.mesh.liveCount() > (isCarved(state.stage) ? most : 2 * most + kTrianglesOfBox);
}

/// Whether that is why the run stopped.
bool overLimit(const MeshState& state);

/// The wish or setting that takes the most triangles.
struct Asker {
  Rule source = Rule::none;     // none: the setting max_rank
  std::uint32_t curve = kNoId;  // as in Constraint
  double length = 0.0;          // edge length asked for
  Point at;
  std::string name;  // "density entry 'wake'", "the curvature of loop 'hole 1'", "the setting max_rank"
};
Asker askerOf(const MeshState& state);

/// A Δx, of two digits, with which the same input stays below the limit; nothing where none was found. Tries some
/// densities, so that it may take as long as the largest that is allowed.
std::optional<double> minEdgeBelowLimit(const MeshState& stopped, const Asker& asker);
/// The same for the length that the asker asks for: that of a density request, or else Δx.
std::optional<double> lengthBelowLimit(const MeshState& stopped, const Asker& asker);
/// What to change, in words; `length` is lengthBelowLimit().
std::string adviceFor(const Asker& asker, std::optional<double> length);

/// How many triangles and bytes it would take, what asks for them, and what to change.
Error tooManyTriangles(const MeshState& state);

}  // namespace triscope
