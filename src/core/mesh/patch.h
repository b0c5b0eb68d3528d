// A small copy of the mesh around a triangle, to try edits on without touching the mesh.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

struct Patch {
  Mesh mesh;                           // its rim is constrained, so no edit reaches beyond it
  std::vector<std::int32_t> slots;     // patch slot -> mesh slot
  std::vector<std::int32_t> vertices;  // patch vertex -> mesh vertex
  std::vector<std::int32_t> edges;     // patch boundary edge -> mesh boundary edge
  // Scratch of extractPatch(), from the mesh to the patch: -1 everywhere between calls.
  std::vector<std::int32_t> localSlot;
  std::vector<std::int32_t> localVertex;
};

/// Triangles within `depth` steps across unconstrained edges; patch slot 0 is `slot`.
void extractPatch(const Mesh& mesh, std::int32_t slot, int depth, Patch& patch);

}  // namespace triscope
