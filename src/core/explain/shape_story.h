// How a triangle came by its shape: what it was when it was made, and what each move of its corners has made of it.
#pragma once

#include <optional>
#include <vector>

#include "core/explain/why.h"

namespace triscope {

/// A move of a corner and the triangle's aspect ratio R/r before and after it.
struct ShapeChange {
  std::size_t event = 0;
  double before = 0.0;
  double after = 0.0;
};

struct ShapeStory {
  double atBirth = 0.0;  // aspect ratio R/r
  std::vector<ShapeChange> moves;
};

/// Of a triangle made by event `birth`, up to its death or the last of the events. Read off the places that the events
/// name. Nothing when the corners are not known, or no event placed one of them (the box around everything).
std::optional<ShapeStory> shapeStoryOf(Events events, std::size_t birth, const TriangleFacts& facts);

}  // namespace triscope
