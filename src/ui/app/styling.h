// How the window looks: fonts and colours, and what of it is kept between runs.
#pragma once

#include <string>

#include "ui/app/desk.h"
#include "ui/app/window.h"
#include "ui/model/fonts.h"

namespace triscope {

class Styling {
 public:
  /// Reads what was kept.
  Styling(Desk& desk, const WindowOptions& options);
  /// Keeps what has changed.
  ~Styling();
  Styling(const Styling&) = delete;
  Styling& operator=(const Styling&) = delete;

  /// Brings fonts and colours up to date; to be called before a Dear ImGui frame begins. True when the font texture
  /// must be made anew.
  bool prepareFrame();
  [[nodiscard]] const Fonts& fonts() const { return fonts_; }

 private:
  Desk& desk_;
  std::string path_;  // of the preferences; empty: none are kept
  Appearance saved_;
  Fonts fonts_;
  double scale_ = 0.0;
  ThemeKind theme_ = ThemeKind::light;
};

}  // namespace triscope
