// What the window shows, as JSON, for tests that press real keys and buttons and look at real pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/model/view.h"

namespace triscope {

/// Everything but what changes by itself (time, frame count).
std::string describeWindow(const View& view, const std::string& caption);

class StateFile {
 public:
  explicit StateFile(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// Forgets what the frame before has noted.
  void beginFrame() {
    widgets_.clear();
    tooltip_.clear();
  }
  /// Where a frame notes its widgets and its tooltip; null when nobody asks.
  std::vector<WidgetRect>* widgets() { return wanted() ? &widgets_ : nullptr; }
  std::string* tooltip() { return wanted() ? &tooltip_ : nullptr; }
  /// Written whole, and only when it says something new; `frame` counts frames drawn.
  void update(const std::string& text, std::uint64_t frame);

 private:
  std::string path_;
  std::string last_;
  std::vector<WidgetRect> widgets_;
  std::string tooltip_;
};

}  // namespace triscope
