// The window's life, frame by frame: what has happened is taken over, the parts draw themselves, and what was ordered
// meanwhile is carried out.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/app/parts.h"

namespace triscope {

class App {
 public:
  /// `wake` makes the event loop run once more; it is called from other threads.
  App(const WindowOptions& options, std::function<void()> wake);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Needs a current OpenGL context and Dear ImGui. Returns what went wrong, empty when ready.
  std::string start(double monitorScale);
  /// Frees everything that OpenGL holds; the last call before the context goes.
  void releaseGl();
  void setMonitorScale(double scale) { parts_.desk.ui.monitorScale = scale; }

  /// False while a dialog is on its way to the screen: what is typed then is meant for it.
  [[nodiscard]] bool takesKeys() const { return parts_.keyboard.ready() && !parts_.dialogs.opening(); }
  void onKey(int key, int mods);
  void onDrop(const std::string& path);

  /// Takes over what has come from other threads. True when something that is shown has changed.
  bool poll();
  /// Brings fonts and colours up to date; to be called before a Dear ImGui frame begins.
  /// True when the font texture must be made anew.
  bool prepareFrame() { return parts_.styling.prepareFrame(); }
  /// Draws the window between NewFrame() and Render(), and carries out what was ordered.
  void frame();
  /// After the frame is on the screen.
  void finishFrame(double milliseconds);

  [[nodiscard]] bool closing() const { return parts_.closing; }
  /// True while the picture changes by itself.
  [[nodiscard]] bool animating() const { return parts_.desk.session.busy() || parts_.comparison.busy(); }
  /// True while a dialog has not come to its place, where nothing that a person does may have opened it.
  [[nodiscard]] bool opensDialog() const { return parts_.dialogs.opening(); }
  /// True once a mesh is complete and nothing is under way.
  [[nodiscard]] bool settled() const;
  [[nodiscard]] std::string title() const { return parts_.document.title(); }
  /// Seconds until poll() is to be called although nothing happens; nothing when it need not be.
  [[nodiscard]] std::optional<double> due() const { return parts_.document.due(); }
  /// What shows between the regions.
  [[nodiscard]] Color surface() const { return themeOf(parts_.desk.ui.look.theme).surface; }

 private:
  void performPressed();

  Parts parts_;
  std::uint64_t frames_ = 0;
  ImVec2 windowSize_{0.0f, 0.0f};
};

}  // namespace triscope
