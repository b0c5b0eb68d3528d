// Vertices of the boundary that may move along it: those between two edges of one curve.
#pragma once

#include <optional>

#include "core/mesh/edit_log.h"

namespace triscope {

/// A vertex on a curve: parameter t, between two boundary edges.
struct OnCurve {
  EdgeId before;  // ends at the vertex: runs from t0 to t
  EdgeId after;   // begins at it
  std::uint32_t curve = 0;
  double t = 0.0;
};

/// Where a boundary vertex may slide; nothing for those that the input fixes, or where chains meet.
std::optional<OnCurve> onCurve(const Mesh& mesh, Vertex vertex);

/// Moves such a vertex to parameter t of its curve, strictly between its neighbours', which is at `at`.
void slideVertex(Mesh& mesh, Vertex vertex, const OnCurve& from, double t, Point at, EditLog& log);

/// Makes one of the two boundary edges of such a vertex; the vertex is in no edge then, and the other edge is gone.
void mergeBoundaryEdges(Mesh& mesh, Vertex vertex, EditLog& log);

}  // namespace triscope
