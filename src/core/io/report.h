// What a run came to, as JSON. docs/measures.md defines every figure.
#pragma once

#include <array>
#include <string>

#include "core/method/state.h"
#include "core/quality/quality.h"

namespace triscope {

/// Seconds spent in each stage, by Stage.
using StageSeconds = std::array<double, kStageCount>;

/// Keys: program_version, method_version, domain, vertices, triangles, boundary_vertices, estimated_triangles,
/// aspect_ratio_max, area_ratio_max, edge_ratio_max, min_angle_deg, max_angle_deg, obtuse, min_edge_length,
/// edge_over_h_mean, edge_over_h_within, min_edge, min_edge_derived, area, aspect_ratio_mean, worst (id of the triangle
/// that has each maximum), bounds (limit and whether met), bounds_met, rounds (of steps 2-5), passes (of step 6),
/// failed, stages (list of key, name, seconds, decisions, inserted, refused, moved, removed).
std::string reportOf(const MeshState& state, const Quality& quality, const StageSeconds& seconds);

/// The keys that a mesh by itself has an answer to.
std::string reportOf(const Mesh& mesh, const Quality& quality);

}  // namespace triscope
