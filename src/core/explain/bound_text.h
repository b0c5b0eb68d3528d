// How the commands speak of a bound: "< 4.31", where its worst triangle is, and what excuses it.
#pragma once

#include <string>

#include "core/explain/element.h"
#include "core/quality/input_angle.h"

namespace triscope {

/// "< 4.31"
std::string limitText(const WorstMeasure& worst);

/// "at the input angle of 14.9° at (0, 0)"
std::string inputAngleText(const InputAngle& angle);

/// "at the input angle of 14.9° at (0, 0), below 60°: no mesh can meet it there" when the triangle that breaks the
/// bound lies in such an angle (of an area ratio: either of the two), else "".
std::string excuseText(const Mesh& mesh, const Quality& quality, const WorstMeasure& worst);

/// "smallest angle 14.9, not > 30, at (0.1, 0.02)", with the excuse in place of the place.
std::string unmetText(const Mesh& mesh, const Quality& quality, const WorstMeasure& worst);

}  // namespace triscope
