// Places and ways in a picture, in pixels: origin top left, y down. A Point is of the world; what is between the two
// is the camera's.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace triscope {

using Pixel = glm::dvec2;

/// z component of the cross product: twice the area spanned by a and b, signed.
inline double cross(Pixel a, Pixel b) { return a.x * b.y - a.y * b.x; }
/// a turned by +90 degrees in a picture whose y goes up.
inline Pixel perpendicular(Pixel a) { return {-a.y, a.x}; }

}  // namespace triscope
