// What repair may try around a triangle that breaks a bound: single edits, proposed and carried out.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/centroid.h"
#include "core/method/stages/place.h"
#include "core/method/state.h"

namespace triscope {

enum class MeshEdit : std::uint8_t { none, move, insert, remove, split };

struct Remedy {
  MeshEdit edit = MeshEdit::none;
  Point to;
  Vertex vertex;  // to move or remove
  EdgeId edge;    // to split
};

/// Everything worth trying around the patient of a patch: the first triangle that breaks a bound, 0 in a fresh patch.
void collectRemedies(const Mesh& patch, std::vector<Remedy>& remedies);

/// Makes the edit in the mesh of the state, or in a patch of it. A point to insert is looked for from slot `start`; no
/// edge becomes shorter than `floor`.
Attempt applyRemedy(Mesh& mesh, const MeshState& state, const Remedy& remedy, Slot start, double floor, Room& room);

Slot firstLive(const Mesh& mesh);

}  // namespace triscope
