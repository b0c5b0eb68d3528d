// A small copy of the mesh around a triangle, to try edits on without touching the mesh.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

struct Patch {
  Mesh mesh;                     // its rim is constrained, so no edit reaches beyond it
  Per<Slot, Slot> slots;         // patch slot -> mesh slot
  Per<Vertex, Vertex> vertices;  // patch vertex -> mesh vertex
  Per<EdgeId, EdgeId> edges;     // patch boundary edge -> mesh boundary edge
  // Scratch of extractPatch(), from the mesh to the patch: none everywhere between calls.
  Per<Slot, Slot> localSlot;
  Per<Vertex, Vertex> localVertex;
};

/// Triangles within `depth` steps across unconstrained edges; patch slot 0 is `slot`.
void extractPatch(const Mesh& mesh, Slot slot, int depth, Patch& patch);

}  // namespace triscope
