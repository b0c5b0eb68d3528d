// The window's state and what changes it: panels draw from a View and return orders, and this carries them out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/gl_renderer.h"
#include "ui/background_job.h"
#include "ui/dialogs.h"
#include "ui/layout.h"
#include "ui/panels.h"
#include "ui/state_file.h"
#include "ui/view.h"
#include "ui/window.h"

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
  void releaseGl() { renderer_.reset(); }
  void setMonitorScale(double scale) { ui_.monitorScale = scale; }

  void onKey(int key, int mods);
  void onDrop(const std::string& path);

  /// Takes over what the session has published. True when something that is shown has changed.
  bool poll();
  /// Brings fonts and colours up to date; to be called before a Dear ImGui frame begins.
  /// True when the font texture must be made anew.
  bool prepareFrame();
  /// Draws the window between NewFrame() and Render(), and carries out what was ordered.
  void frame();
  /// After the frame is on the screen.
  void finishFrame(double milliseconds);

  [[nodiscard]] bool closing() const { return closing_; }
  /// True while the picture changes by itself.
  [[nodiscard]] bool animating() const { return session_.busy(); }
  /// True once a mesh is complete and nothing is under way.
  [[nodiscard]] bool settled() const { return session_.current() != nullptr && !session_.busy(); }
  /// What shows between the regions.
  [[nodiscard]] Color surface() const { return themeOf(ui_.look.theme).surface; }

 private:
  /// A control for a parameter is held and moved.
  struct Tuning {
    Settings before;
    bool cancelled = false;
  };

  [[nodiscard]] View view();
  void drawRegions(const Layout& layout, const View& view, Orders& orders);
  void drawBottom(const Layout& layout, const View& view, Orders& orders);
  void drawSide(const char* name, Side side, const Region& region, const View& view, Orders& orders);
  void drawDialog(const View& view, Orders& orders);
  void drawPicture(const Region& region);
  void followRun();
  void resolveSelection();
  void performPressed();

  void carryOut(const Order& order);
  void perform(Action action);
  void performOnRun(Action action);
  void apply(const Command& command);
  void change(const Settings& settings);
  void changeWithoutUndo(const Settings& settings);
  void tune(const Settings& settings);
  void endTuning();
  void cancelTuning();
  void select(const Pick& pick);
  void showWorst(std::int32_t slot, std::int32_t other);
  void frameBox(const Box& box, double marginAt100);
  void fit();
  void zoomMiddle(double factor);
  void setScale(double scale);
  void toggle(Action action);
  void cancel();
  void performDebug(Action action);
  void toggleBreakpoint();
  void toggleBookmark();
  void goToMark(bool after);
  void addBreakpoint();
  void follow(Ref ref);
  void keepInRange();
  void updateAnswers();
  void openDialog(Dialog dialog);
  void exportTo(const std::string& path);
  void finishExport();
  [[nodiscard]] std::string suggestedPath(const char* extension) const;

  std::function<void()> wake_;
  Session session_;
  UiState ui_;
  Fonts fonts_;
  Scene scene_;
  std::unique_ptr<GlRenderer> renderer_;  // while there is a context
  OpenDialog openDialog_;
  ExportDialog exportDialog_;
  BackgroundJob export_;
  StateFile stateFile_;
  std::string preferencesPath_;
  Appearance savedLook_;
  std::vector<WidgetRect> widgets_;
  std::vector<Action> pressed_;  // by keys, since the last frame
  std::shared_ptr<const Domain> shownDomain_;
  SnapshotPtr shown_;
  DebugAnswers answers_;
  double styledScale_ = 0.0;
  ThemeKind styledTheme_ = ThemeKind::light;
  std::string wantedTab_;   // to be brought to the front
  std::string saidNotice_;  // of the session, in the message already
  std::string exportPath_;  // being written
  bool fitted_ = true;      // the camera shows the whole domain, and is to go on doing so
  bool legendOnCanvas_ = false;
  std::uint64_t failuresSeen_ = 0;
  bool closing_ = false;
  std::uint64_t frames_ = 0;
  std::optional<Tuning> tuning_;  // while a control for a parameter is held
};

}  // namespace triscope
