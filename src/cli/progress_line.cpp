#include "cli/progress_line.h"
#include "cli/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/stop.h"
#include "core/method/estimate.h"
#include "core/method/pipeline.h"

namespace triscope {
namespace {

constexpr int kBarWidth = 24;
constexpr auto kInterval = std::chrono::milliseconds(100);

bool isSet(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

ProgressLine::ProgressLine(Notices notices) {
  const char* const kind = std::getenv("TERM");
  terminal_ =
      notices == Notices::shown && isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
  color_ = !isSet("NO_COLOR");
}

bool ProgressLine::due() {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - last_ < kInterval) return false;
  last_ = now;
  shown_ = true;
  noteProgressShown(true);
  return true;
}

void ProgressLine::show(const std::string& line) {
  if (!due()) return;
  sayText(fmt::format("\r{}\x1b[K", line));
  std::fflush(stderr);
}

void ProgressLine::show(const MeshState& state) {
  if (!due()) return;
  const std::size_t triangles = state.mesh.liveCount();
  std::string line{infoOf(state.stage).name};
  if (state.search.part != ConstraintSearch::Part::over)
    line += fmt::format(", {:.0f} %", 100.0 * fractionOf(state.search, *state.domain));
  line += turnBehind(state.stage, state.round);
  if (state.estimatedTriangles > 0.0 && !makesDensity(state.stage)) {
    const double part = std::min(1.0, static_cast<double>(triangles) / state.estimatedTriangles);
    const int filled = static_cast<int>(part * kBarWidth);
    line = fmt::format("{}{:#>{}}{:->{}}{} {:>9} of about {} triangles ({})  {}", color_ ? "\x1b[36m" : "", "", filled,
                       "", kBarWidth - filled, color_ ? "\x1b[0m" : "", triangles, roughCount(state.estimatedTriangles),
                       bytesText(estimateOf(state).bytes), line);
  }
  sayText(fmt::format("\r{}\x1b[K", line));
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (!shown_) return;
  shown_ = false;
  noteProgressShown(false);
  sayText("\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace triscope
