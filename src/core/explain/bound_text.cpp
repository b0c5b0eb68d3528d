#include "core/explain/bound_text.h"

#include <fmt/format.h>

#include "core/explain/fields.h"

namespace triscope {
namespace {

/// Degrees: in an input angle as small as this no triangle can meet the bound (0: some can). In an angle α every
/// triangle has an angle of at most α; the best is isosceles: with s = sin(α/2), its r/R is 2s(1 - s) and its edge
/// ratio 1/(2s).
double hopelessAngle(const WorstMeasure& worst) {
  if (worst.key == "min_angle") return Bounds::minAngle;
  if (worst.key == "aspect_ratio") return 15.39;
  return worst.key == "edge_ratio" ? 28.95 : 0.0;
}

}  // namespace

std::string limitText(const WorstMeasure& worst) {
  return fmt::format("{} {:g}", worst.upper ? "<" : ">", worst.bound);
}

std::string inputAngleText(const InputAngle& angle) {
  return fmt::format("at the input angle of {:.1f}° at {}", angle.degrees, placeText(angle.at));
}

std::string excuseText(const Mesh& mesh, const Quality& quality, const WorstMeasure& worst) {
  if (worst.met() || !worst.slot.exists()) return {};
  std::optional<InputAngle> angle = smallInputAngle(mesh, worst.slot);
  if (!angle && worst.key == "area_ratio") angle = smallInputAngle(mesh, quality.areaRatioOther);
  if (!angle) return {};
  return fmt::format("{}, below 60°: {}", inputAngleText(*angle),
                     angle->degrees <= hopelessAngle(worst) ? "no mesh can meet it there" : "it is not promised there");
}

std::string unmetText(const Mesh& mesh, const Quality& quality, const WorstMeasure& worst) {
  std::string where = excuseText(mesh, quality, worst);
  if (where.empty() && worst.slot.exists()) where = fmt::format("at {}", placeText(centroidOf(mesh, worst.slot)));
  return fmt::format("{} {:.4g}, not {}, {}", worst.name, worst.value, limitText(worst), where);
}

}  // namespace triscope
