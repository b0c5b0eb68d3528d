// Which triangle slots the last edits of a mesh wrote to, for those who follow a run closely. Off unless somebody does.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/mesh.h"

namespace triscope {

/// While one lives, slots of the mesh that get a new triangle, lose theirs, or have a corner moved are listed, possibly
/// several times. One at a time for a mesh, which outlives it; a copy that is made of the mesh meanwhile goes on with a
/// list of its own.
class ChangeLog {
 public:
  explicit ChangeLog(Mesh& mesh) : mesh_(&mesh) { mesh.touched.emplace(); }
  ~ChangeLog() {
    TRISCOPE_DCHECK(mesh_->touched, "a mesh outlives the log of its changes");
    mesh_->touched.reset();
  }
  ChangeLog(const ChangeLog&) = delete;
  ChangeLog& operator=(const ChangeLog&) = delete;

  [[nodiscard]] const std::vector<Slot>& slots() const { return *mesh_->touched; }
  void clear() { mesh_->touched->clear(); }

 private:
  Mesh* mesh_;
};

/// What an edit says of the slots it writes to.
inline void noteTouched(Mesh& mesh, Slot slot) {
  if (mesh.touched) mesh.touched->push_back(slot);
}
inline void noteTouched(Mesh& mesh, std::span<const Slot> several) {
  if (mesh.touched) mesh.touched->insert(mesh.touched->end(), several.begin(), several.end());
}

}  // namespace triscope
