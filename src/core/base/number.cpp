#include "core/base/number.h"

#include <fmt/format.h>

#include <cmath>

namespace triscope {

std::string compact(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "–" : value > 0.0 ? "∞" : "−∞";
  const double size = std::fabs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e7)) return fmt::format("{:.{}g}", value, digits);
  const int before = size < 1.0 ? 0 : static_cast<int>(std::floor(std::log10(size))) + 1;
  int after = digits - before;
  if (size > 0.0 && size < 1.0) after = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
  std::string text = fmt::format("{:.{}f}", value, after < 0 ? 0 : after);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

double roundedUp(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit - 1e-9) * unit;  // what has two digits already stays
}

}  // namespace triscope
