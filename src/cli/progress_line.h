// One line on the terminal that says where a run is. Nothing is shown when stderr is no terminal.
#pragma once

#include <chrono>
#include <string>

#include "cli/notices.h"
#include "core/method/state.h"

namespace triscope {

class ProgressLine {
 public:
  explicit ProgressLine(Notices notices);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Redraws the line, at most ten times a second.
  void show(const MeshState& state);
  void show(const std::string& line);
  /// Wipes the line, so that messages can follow.
  void clear();

 private:
  bool due();
  bool shown_ = false;
  bool terminal_ = false;
  bool color_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace triscope
