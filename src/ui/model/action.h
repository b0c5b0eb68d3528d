// Everything that a key, a menu entry or a toolbar button can ask for: one table for all of them, for the help
// overlay and for docs/keys.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace triscope {

enum class Action : std::uint8_t {
  // File
  open,
  reload,
  save_session,
  save_session_as,
  restore_work,
  export_mesh,
  save_picture,
  save_figure,
  quit,
  // Run
  play_pause,
  step,
  step_back,
  into,
  into_back,
  insertion,
  insertion_back,
  stage,
  stage_back,
  round,
  restart,
  to_end,
  slower,
  faster,
  cancel,
  undo,
  redo,
  place_density,
  delete_density,
  // Break
  continue_forward,
  continue_back,
  breakpoint,
  first_violation,
  bookmark,
  previous_mark,
  next_mark,
  why,
  breakpoints_panel,
  plots_panel,
  // Compare
  pin_run,
  first_difference,
  compare_panel,
  sweep_panel,
  run_sweep,
  save_sweep,
  cell_left,
  cell_right,
  cell_down,
  cell_up,
  take_cell,
  // View
  fit,
  zoom_in,
  zoom_out,
  worst_aspect,
  worst_area,
  worst_edge,
  boundary,
  boundary_points,
  quadtree,
  constraints,
  fronts,
  steiner,
  degrees,
  triangulation,
  obtuse,
  worst,
  decision,
  labels,
  legend,
  next_fill,
  side_panels,
  next_theme,
  larger,
  smaller,
  normal_size,
  // Help
  help,
  about,
};
inline constexpr int kActionCount = static_cast<int>(Action::about) + 1;

enum class Menu : std::uint8_t { file, edit, run, debug, compare, view, help };

/// A key with its modifiers, as GLFW numbers them; key 0: none.
struct KeyChord {
  int key = 0;
  int mods = 0;
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// Where the keys of an action mean it.
enum class Scope : std::uint8_t { window, heat_map };

struct Parts;
struct RunView;
struct UiState;

/// What a key, an entry or a button asks for: what it is called, when it can be done, and who does it.
struct ActionInfo {
  Action id;
  Menu menu;
  std::string_view key;    // for files and tests: "step_back"
  std::string_view label;  // on menus: "Step back"
  std::string_view help;   // one sentence
  std::array<KeyChord, 3> chords;
  std::string (*whyNot)(const RunView&);  // why it cannot be done right now, a sentence; empty when it can
  void (*perform)(Parts&);
  bool (*isOn)(const UiState&) = nullptr;  // of switches
  Scope scope = Scope::window;
};

/// One entry per Action, in order.
std::span<const ActionInfo> actions();
inline const ActionInfo& infoOf(Action action) { return actions()[static_cast<std::size_t>(action)]; }

/// Whether a switch is on; false for actions that are no switches.
inline bool isOn(Action action, const UiState& ui) {
  const ActionInfo& info = infoOf(action);
  return info.isOn != nullptr && info.isOn(ui);
}

/// The action that a key press asks for there; lock keys are ignored.
std::optional<Action> actionFor(int key, int mods, Scope scope = Scope::window);

/// Whether GLFW's modifiers contain Ctrl.
bool withCtrl(int mods);
/// Whether a key is Shift, Ctrl, Alt or Super.
bool isModifier(int key);
/// F1 … F25.
bool isFunctionKey(int key);

std::string_view nameOf(Menu menu);
/// "Ctrl+Shift+F11".
std::string textOf(KeyChord chord);
/// "Shift+Right or F10"; empty when the action has no key.
std::string keysOf(const ActionInfo& info);
/// docs/keys.md.
std::string keysAsMarkdown();

}  // namespace triscope
