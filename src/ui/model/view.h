// What a panel may look at while it draws. Nothing here can be changed through it; a panel returns orders.
#pragma once

#include <imgui.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/explain/insertion.h"
#include "core/session/session.h"
#include "render/camera.h"
#include "render/pick.h"
#include "render/scene.h"
#include "render/view_options.h"
#include "ui/model/autosave.h"
#include "ui/model/debug_state.h"
#include "ui/model/fonts.h"
#include "ui/model/order.h"
#include "ui/model/sweep_state.h"

namespace triscope {

class PinnedRun;

enum class Dialog : std::uint8_t { none, open, save_as, export_to, error, help, about, limit };

/// Where a widget was drawn last, for tests that press real buttons.
struct WidgetRect {
  std::string name;
  ImVec2 lo;
  ImVec2 hi;
  bool enabled = true;
};

/// What undo goes back to: the parameters, and the domain with what it asks of the density.
struct Edit {
  Settings settings;
  std::shared_ptr<const Domain> domain;
  friend bool operator==(const Edit&, const Edit&) = default;
};

/// The session as a file.
struct DocumentUi {
  std::string path;  // empty: not saved yet
  std::string notes;
  bool opening = false;  // another one: what is shown is of the one before
  bool unsaved = false;
  bool saving = false;
  std::vector<KeptWork> kept;  // left behind by earlier runs, the newest first
  bool offering = false;       // to restore it
};

/// Density constraints of the domain as they are edited.
struct DensityUi {
  bool placing = false;                // a click places one
  std::optional<std::size_t> request;  // that is selected, in Domain::density; View::request() is safe to read
  bool held = false;                   // by the mouse
  std::optional<std::string> name;     // being typed
};

/// The insertion that is stepped through.
struct InsertionUi {
  std::shared_ptr<const Insertion> now;  // null: none
  InsertionPhase phase = InsertionPhase::candidate;
  std::uint64_t after = 0;                             // decisions made once it is done
  std::array<std::string, kInsertionPhases> captions;  // of the phases
};

/// The stage that what is shown belongs to: the last decision's, or the one to come where there is none.
Stage stageOf(const Snapshot& now);

/// Where the legend was last. While the window stays as it is, it may go on in this order, but not back: it would jump
/// to and fro while one steps.
enum class LegendPlace : std::uint8_t { anywhere, column, picture, folded };

/// Everything about the window that is not the run itself.
struct UiState {
  ViewOptions options;
  bool layersFollow = true;  // the stage, until one of them is switched by hand
  Camera camera;
  bool fitted = true;  // it shows the whole domain, and is to go on doing so
  Appearance look;
  double monitorScale = 1.0;
  double speed = 60.0;             // decisions per second when playing
  Pick selected;                   // in the mesh of some moment; View::selection() says where it is now
  Panel tab = Panel::stages;       // on the left
  std::optional<bool> sidePanels;  // shown; nothing: where there is room for them
  bool sidePanelsShown = true;     // last
  Dialog dialog = Dialog::none;
  std::optional<Error> error;   // shown by Dialog::error
  std::string message;          // the last thing worth telling, in the status bar
  std::optional<Point> cursor;  // world, while over the canvas
  std::vector<Edit> undo;
  std::vector<Edit> redo;
  DocumentUi document;
  DensityUi density;
  InsertionUi insertion;
  DebugUi debug;
  SweepUi sweep;
  bool pinned = false;  // a run A is shown beside this one
  bool exporting = false;
  double frameMs = 0.0;
  LegendPlace legendPlace = LegendPlace::anywhere;
  bool legendFolded = false;    // it has room neither in the right column nor over the picture: a button stands for it
  bool legendOnCanvas = false;  // over the picture
  bool legendOver = false;      // folded, but shown over the picture all the same
  bool tipsWait = false;        // a key was pressed: no tooltip until the mouse moves
  std::uint64_t keysPressed = 0;     // that have been acted on, without modifiers
  std::uint64_t buttonsPressed = 0;  // of the mouse
  std::uint64_t buttonsReleased = 0;
  [[nodiscard]] double scale() const { return look.scale > 0.0 ? look.scale : monitorScale; }
  /// How pictures are drawn: as the layers say, in the window's colours.
  [[nodiscard]] ViewOptions picture() const {
    ViewOptions all = options;
    all.theme = look.theme;
    return all;
  }
};

/// The run and the window's state, and what is often asked of the two together.
struct RunView {
  const Session& session;
  const UiState& ui;
  const PinnedRun* pinned = nullptr;  // run A; null when none is pinned
  [[nodiscard]] const Snapshot* now() const { return session.current().get(); }
  /// Where what is selected is in the mesh shown; kind none where it is not part of it, or nothing is selected.
  [[nodiscard]] Selection selection() const { return now() ? present(now()->state, ui.selected) : Selection{}; }
  /// The density constraint that is selected; null when none is.
  [[nodiscard]] const DensityRequest* request() const;
  /// Whether what is shown is the state of the insertion's phase: on the way there, it is not.
  [[nodiscard]] bool inInsertion() const;
  /// The stage that is told of: inside an insertion its own, whatever came before it. There must be a mesh.
  [[nodiscard]] Stage stage() const { return inInsertion() ? ui.insertion.now->event.stage : stageOf(*now()); }
  /// Of steps 2 to 5, or the pass of a stage that moves points, likewise.
  [[nodiscard]] int round() const { return inInsertion() ? ui.insertion.now->event.round : now()->state.round; }
};

struct View : RunView {
  const Scene& scene;
  const Fonts& fonts;
  const DebugAnswers& debug;
  unsigned canvasTexture = 0;
  bool legendOnCanvas = false;                 // the legend lies over this picture
  std::vector<WidgetRect>* widgets = nullptr;  // null when nobody asks
  std::string* tooltip = nullptr;              // that shows; null when nobody asks
  [[nodiscard]] const Theme& theme() const { return scene.theme; }
  /// Pixels for a length at 100 %.
  [[nodiscard]] float px(double at100) const { return static_cast<float>(at100 * ui.scale()); }
};

}  // namespace triscope
