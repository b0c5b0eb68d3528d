// What edits wrote to, so that they can be taken back at the cost of what they touched.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// Each thing as it was before it was written to, in the order of change and perhaps several times: undone backwards.
/// Who edits a mesh that may have to be given back saves first; what is added needs no saving.
struct EditLog {
  struct SavedSlot {
    Slot slot;
    Triangle triangle;
    TriangleId id;
    std::uint8_t flags;
    std::uint8_t tested;
  };
  struct SavedVertex {
    Vertex vertex;
    Slot triangle;
    EdgeId edge;
    VertexKind kind;
    Point at;
  };
  struct SavedEdge {
    EdgeId edge;
    BoundaryEdge was;
  };
  std::vector<SavedSlot> slots;
  std::vector<SavedVertex> vertices;
  std::vector<SavedEdge> edges;
  std::vector<Slot> free;  // taken from the free slots; none: one was freed
};

/// A moment of a mesh and of its log.
struct EditMark {
  std::size_t slots = 0;  // saved
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t free = 0;
  std::size_t allSlots = 0;  // of the mesh
  std::size_t allVertices = 0;
  std::size_t allEdges = 0;
  TriangleId nextId;
};

/// Empties the log: what is written from now on can be taken back.
void beginEdits(EditLog& log);
EditMark markOf(const Mesh& mesh, const EditLog& log);
/// Gives back the mesh of the mark, ids included, and forgets what was saved since.
void undoEdits(Mesh& mesh, EditLog& log, const EditMark& mark);

void save(const Mesh& mesh, Slot slot, EditLog& log);
void save(const Mesh& mesh, Vertex vertex, EditLog& log);
void save(const Mesh& mesh, EdgeId edge, EditLog& log);
/// All that a flip of the edge writes to.
void saveFlip(const Mesh& mesh, Half half, EditLog& log);

/// The edits of edit.h and flip.h, saved first.
void link(Mesh& mesh, Half half, Half other, EditLog& log);
Half flipEdge(Mesh& mesh, Half half, EditLog& log);
Slot addTriangle(Mesh& mesh, Vertex a, Vertex b, Vertex c, EditLog& log);
void killTriangle(Mesh& mesh, Slot slot, EditLog& log);
/// Moves a vertex wherever it may be; the triangles around it are the caller's to look after.
void movePoint(Mesh& mesh, Vertex vertex, Point to, EditLog& log);

}  // namespace triscope
