// Which triangles of a mesh lie inside of the box around everything, as all do once it is gone.
#pragma once

#include <algorithm>

#include "core/mesh/mesh.h"

namespace triscope {

/// Looks for the box once, for many questions about a mesh that stays as it is.
class InsideBox {
 public:
  explicit InsideBox(const Mesh& mesh)
      : mesh_(mesh), boxed_(std::find(mesh.kinds.begin(), mesh.kinds.end(), VertexKind::helper) != mesh.kinds.end()) {}

  /// Whether the slot holds a triangle, and one without a corner of the box.
  [[nodiscard]] bool has(Slot slot) const { return mesh_.alive(slot) && !(boxed_ && touchesHelper(mesh_, slot)); }
  /// Whether the box is there.
  [[nodiscard]] bool boxed() const { return boxed_; }

 private:
  const Mesh& mesh_;
  bool boxed_;
};

}  // namespace triscope
