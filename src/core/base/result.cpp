#include "core/base/result.h"

#include <fmt/format.h>

#include "core/base/shown_text.h"

namespace triscope {

std::string describe(const Error& error) {
  std::string where;
  if (!error.loop.empty()) where += fmt::format("loop '{}'", shown(error.loop));
  if (error.point >= 0) where += fmt::format("{}point {}", where.empty() ? "" : ", ", error.point);
  // For people: a computed place in all its digits would say no more.
  if (error.at) where += fmt::format("{}at ({:.9g}, {:.9g})", where.empty() ? "" : " ", error.at->x, error.at->y);

  std::string line;
  if (!error.file.empty()) line += shown(error.file, error.file.size()) + ": ";
  if (!where.empty()) line += where + ": ";
  line += error.message;
  if (!error.hint.empty()) line += "; " + error.hint;
  return shownLines(line);
}

}  // namespace triscope
