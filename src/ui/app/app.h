// The window's state and what changes it: panels draw from a View and return orders, and this carries them out.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/file_identity.h"
#include "render/gl_renderer.h"
#include "ui/app/state_file.h"
#include "ui/app/window.h"
#include "ui/dialog/dialogs.h"
#include "ui/model/background_job.h"
#include "ui/model/pinned_run.h"
#include "ui/model/sweep_job.h"
#include "ui/model/view.h"
#include "ui/panel/panels.h"
#include "ui/region/layout.h"
#include "ui/region/regions.h"

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
  void releaseGl() {
    pinned_.reset();
    renderer_.reset();
  }
  void setMonitorScale(double scale) { ui_.monitorScale = scale; }

  /// False while a dialog is on its way to the screen: what is typed then is meant for it.
  [[nodiscard]] bool takesKeys() const;
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

  /// What is done for an action, whatever asks for it.
  struct Deed {
    Action id;
    std::string (*whyNot)(const View&);  // empty when it can be done
    void (*perform)(App&);
  };
  static const Deed& deedOf(Action action);

  [[nodiscard]] bool closing() const { return closing_; }
  /// True while the picture changes by itself.
  [[nodiscard]] bool animating() const { return session_.busy() || (pinned_ && pinned_->session().busy()); }
  /// True while a dialog has not come to its place, where nothing that a person does may have opened it.
  [[nodiscard]] bool opensDialog() const;
  /// True once a mesh is complete and nothing is under way.
  [[nodiscard]] bool settled() const { return session_.current() != nullptr && !session_.busy(); }
  [[nodiscard]] std::string title() const;
  /// Seconds until poll() is to be called although nothing happens; nothing when it need not be.
  [[nodiscard]] std::optional<double> due() const { return autosave_.due(Autosave::Clock::now()); }
  /// What shows between the regions.
  [[nodiscard]] Color surface() const { return themeOf(ui_.look.theme).surface; }

 private:
  /// A control for a parameter is held and moved.
  struct Tuning {
    Edit before;
    bool cancelled = false;
  };
  /// On the way to an insertion that is to be stepped through: first to the state after it, then to the one before.
  struct Entering {
    enum class Step : std::uint8_t { none, after, before } step = Step::none;
    InsertionPhase phase = InsertionPhase::candidate;  // to be shown then
    std::size_t vertices = 0;                          // when it began
    std::uint64_t events = 0;                          // of the state after
  };
  /// The camera has gone near an insertion that is stepped through.
  struct Near {
    Camera before;
    bool fitted = false;  // it showed the whole domain then
    Camera camera;        // where it went
    /// Whether `now` is still there: the window's size may have changed.
    [[nodiscard]] bool isAt(const Camera& now) const {
      return now.centre == camera.centre && now.scale == camera.scale;
    }
  };
  /// What decides how much room there is for the legend.
  struct LegendRoom {
    ImVec2 window{0.0f, 0.0f};
    double scale = 0.0;
    Appearance look;
    std::optional<Panel> bottom;
    std::optional<bool> sidePanels;
    bool pinned = false;
    friend bool operator==(const LegendRoom& a, const LegendRoom& b) {
      return a.window.x == b.window.x && a.window.y == b.window.y && a.scale == b.scale && a.look == b.look &&
             a.bottom == b.bottom && a.sidePanels == b.sidePanels && a.pinned == b.pinned;
    }
  };
  /// A session on its way from the file to the window.
  struct Opening {
    std::shared_ptr<const Domain> domain;
    SessionFile file;
    std::string path;              // of the session that it is saved as; empty: none
    std::optional<KeptWork> kept;  // where it was kept, for work that was not saved
  };

  [[nodiscard]] View view();
  void drawRegions(const Layout& layout, const View& view, Orders& orders);
  void drawBottom(const Layout& layout, const View& view, Orders& orders);
  void drawSide(const char* name, std::optional<Side> side, const Region& region, const View& view, Orders& orders);
  void drawDialog(const View& view, Orders& orders);
  void forgetLegendPlace();
  void placeLegend(const Layout& layout);
  void drawPicture(const Region& region);
  void followRun();
  void followStage();
  void performPressed();

  void carryOut(const Order& order);
  void perform(Action action);
  void apply(const Command& command);
  void change(const Settings& settings);
  [[nodiscard]] Edit inForce() const { return {session_.settings(), session_.domain()}; }
  void remember(const Edit& before);
  void bring(const Edit& edit);
  void tune(const Edit& edit);
  void endTuning();
  void cancelTuning();
  void select(const Pick& pick);
  void showWorst(std::int32_t slot, std::int32_t other);
  void frameBox(const Box& box, double marginAt100);
  void fit();
  void zoomMiddle(double factor);
  void setScale(double scale);
  void toggleQuadtree();
  void toggleBottom(Panel panel);
  void undo();
  void redo();
  void askWhereToSave();
  void askWhereToExport(const char* extension);
  void cancel();
  void search(const Command& command);
  void showFound();
  void toggleBreakpoint();
  void toggleBookmark();
  void goToMark(bool after);
  void addBreakpoint();
  void togglePinned();
  void unpin();
  void followPinned();
  void runSweep();
  [[nodiscard]] bool heatMapShown() const;
  [[nodiscard]] std::optional<Action> heatMapAction(int key, int mods) const;
  void moveCell(Action action);
  void takeCell();
  bool followSweep();
  void finishSweep(const Status& outcome);
  void follow(Ref ref);
  void keepInRange();
  void updateAnswers();
  void editDensity(std::vector<DensityRequest> density, bool held);
  void nameRequest(const order::NameRequest& typed);
  void placeRequest(Point at);
  void moveRequest(Point to);
  void deleteRequest();
  void selectRequest(std::optional<std::size_t> index);
  void togglePlacing();
  void run(const Command& command);
  void stepInto();
  void stepBackOut();
  void enterInsertion(InsertionPhase phase);
  void takeApartHere();
  void showPhase(InsertionPhase phase);
  void followInsertion();
  void goNear(const Insertion& insertion);
  void leaveInsertion();
  void openDialog(Dialog dialog);
  void openFile(const std::string& path);
  void openSession(SessionFile file, const std::string& path, std::optional<KeptWork> kept);
  void complain(const Error& error);
  /// Whether a domain is the document's, now or before an edit of its density; another document's is not.
  [[nodiscard]] bool isVersion(const std::shared_ptr<const Domain>& domain) const;
  void beginDocument();
  [[nodiscard]] Draft draft() const;
  void followDocument();
  void closeDocument();
  /// The file that no export and no session may overwrite.
  [[nodiscard]] NamedFile openDomain() const;
  void saveTo(const std::string& path);
  void finishSave();
  void restore();
  void discardKept();
  void exportTo(const std::string& path);
  void finishExport();
  void askAboutLimit();
  [[nodiscard]] std::string freePath(const char* extension) const;
  [[nodiscard]] std::string suggestedPath(const char* extension) const;

  std::function<void()> wake_;
  Session session_;
  UiState ui_;
  Fonts fonts_;
  Scene scene_;
  std::unique_ptr<GlRenderer> renderer_;  // while there is a context
  std::unique_ptr<PinnedRun> pinned_;     // run A
  OpenDialog openDialog_;
  ExportDialog exportDialog_;
  SaveDialog saveDialog_;
  LimitDialog limitDialog_;
  std::optional<Edit> asked_;  // about its limit of triangles already
  SweepJob sweep_;
  std::chrono::steady_clock::time_point sweepSince_{};
  BackgroundJob export_;
  BackgroundJob save_;
  std::atomic<bool> saveStops_{false};  // the window closes: hashes that are missing are left out
  Autosave autosave_;
  std::optional<Draft> draft_;      // as it is now; nothing until there is a mesh
  std::optional<Draft> base_;       // as it was opened or saved; nothing for work that was restored
  bool baseWanted_ = false;         // draft_ is to become base_ once it is complete
  std::optional<Draft> saving_;     // being written
  std::string savePath_;            // to here
  std::optional<Opening> opening_;  // while it is made
  Entering entering_;
  std::optional<Near> near_;
  StateFile stateFile_;
  std::string preferencesPath_;
  Appearance savedLook_;
  std::vector<WidgetRect> widgets_;
  std::string tooltip_;
  struct Pressed {
    Action action;
    bool types;  // means something else while text is typed
  };
  std::vector<Pressed> pressed_;  // by keys, since the last frame
  std::shared_ptr<const Domain> shownDomain_;
  std::vector<std::weak_ptr<const Domain>> versions_;  // of the document: as it was opened, and after each edit
  SnapshotPtr shown_;
  DebugAnswers answers_;
  double styledScale_ = 0.0;
  ThemeKind styledTheme_ = ThemeKind::light;
  std::optional<Panel> wantedTab_;  // to be brought to the front
  std::string saidNotice_;          // of the session, in the message already
  std::string exportPath_;          // being written
  bool fitted_ = true;              // the camera shows the whole domain, and is to go on doing so
  bool legendOnCanvas_ = false;
  LegendRoom legendRoom_;
  std::uint64_t failuresSeen_ = 0;
  bool closing_ = false;
  std::uint64_t frames_ = 0;
  bool searching_ = false;             // a breakpoint or a violation: what is found is to be seen
  std::uint64_t typingEnds_ = 0;       // by this frame a key has ended the typing, if it does
  Dialog dialogDrawn_ = Dialog::none;  // last
  std::uint64_t dialogFrame_ = 0;      // since when
  ImVec2 windowSize_{0.0f, 0.0f};
  std::optional<Tuning> tuning_;  // while a control for a parameter is held
};

}  // namespace triscope
