// A small mesh that edits are tried on: each is judged by the triangles it touches, and taken back.
#pragma once

#include <vector>

#include "core/mesh/badness.h"
#include "core/mesh/mesh.h"

namespace triscope {

struct Trial {
  Mesh mesh;       // to edit; it lists the slots that are written to
  Mesh unedited;   // what it is like before each edit
  Breach whole;    // of all triangles of `unedited`
  struct Broken {  // the triangles that add to it, in the order of their slots
    Slot slot;
    Breach breach;
  };
  std::vector<Broken> broken;
  // Scratch: who is touched by the edit, and who has been asked already.
  std::vector<Slot> region;
  Per<Slot, std::uint8_t> inRegion;
};

/// Begins with `from` as it is, or with the mesh as the last edit left it.
void beginTrial(Trial& trial, const Mesh& from);
void keepEdit(Trial& trial);

/// The breach of the whole mesh after an edit, found from the slots that it wrote to and the triangles beside them; the
/// list of them is empty before each edit. `shortest` is that of the triangles looked at. The search is given up, with
/// a result that is as bad or better, once more than `most` bounds are found broken.
Breach judgeEdit(Trial& trial, int most);

/// Makes the mesh what it was before the edit.
void takeBack(Trial& trial);

}  // namespace triscope
