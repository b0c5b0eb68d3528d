#include "core/base/version.h"

#include <fmt/format.h>

#include "core/base/shown_text.h"

namespace triscope {

MadeBy thisVersion() { return {TRISCOPE_VERSION, kMethodVersion}; }

std::string versionNote(const MadeBy& file) {
  const MadeBy now = thisVersion();
  if (file.program.empty() || file.method == 0)
    return "saved by a version that did not say which it was; meshes and decisions may differ";
  if (file.method != now.method)
    return fmt::format(
        "saved by triscope {} with version {} of the method; this is {} with version {}, so that meshes and decisions "
        "may differ",
        shown(file.program), file.method, now.program, now.method);
  if (file.program != now.program)
    return fmt::format("saved by triscope {}; this is {}, with the same method", shown(file.program), now.program);
  return "";
}

}  // namespace triscope
