#include "ui/action.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

namespace triscope {
namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL;
constexpr int kShift = GLFW_MOD_SHIFT;

constexpr std::array<ActionInfo, kActionCount> kActions{{
    {Action::open, Menu::file, "open", "Open…", "Opens a domain file or a session.", {{{GLFW_KEY_O, kCtrl}}}},
    {Action::reload,
     Menu::file,
     "reload",
     "Read again",
     "Reads the domain file again and meshes it.",
     {{{GLFW_KEY_R, kCtrl}}}},
    {Action::save_session,
     Menu::file,
     "save_session",
     "Save session",
     "Writes the domain, the parameters, breakpoints, bookmarks, notes and where you are to a session file.",
     {{{GLFW_KEY_S, kCtrl}}}},
    {Action::save_session_as,
     Menu::file,
     "save_session_as",
     "Save session as…",
     "Saves the session under another name.",
     {{{GLFW_KEY_S, kCtrl | kShift}}}},
    {Action::restore_work,
     Menu::file,
     "restore_work",
     "Restore unsaved work",
     "Opens the latest work that was not saved: when the program was killed, or something else was opened over it.",
     {}},
    {Action::export_mesh,
     Menu::file,
     "export_mesh",
     "Export…",
     "Writes the mesh or a picture of it to a file.",
     {{{GLFW_KEY_E, kCtrl}}}},
    {Action::save_picture,
     Menu::file,
     "save_picture",
     "Save picture",
     "Writes the canvas as a PNG picture.",
     {{{GLFW_KEY_F12, 0}}}},
    {Action::save_figure,
     Menu::file,
     "save_figure",
     "Save vector figure",
     "Writes the canvas as an SVG figure.",
     {{{GLFW_KEY_F12, kCtrl}}}},
    {Action::quit, Menu::file, "quit", "Quit", "Closes the window.", {{{GLFW_KEY_Q, kCtrl}}}},

    {Action::play_pause,
     Menu::run,
     "play_pause",
     "Play or pause",
     "Carries on by itself at the chosen speed, or stops.",
     {{{GLFW_KEY_SPACE, 0}}}},
    {Action::step,
     Menu::run,
     "step",
     "Next decision",
     "Makes one decision: the smallest step.",
     {{{GLFW_KEY_RIGHT, 0}}}},
    {Action::step_back,
     Menu::run,
     "step_back",
     "Previous decision",
     "Goes back by one decision.",
     {{{GLFW_KEY_LEFT, 0}}}},
    {Action::into,
     Menu::run,
     "into",
     "Into the insertion",
     "Steps through the next insertion: the candidate, the walk to its place, the cavity, the new triangles.",
     {{{GLFW_KEY_F11, 0}}}},
    {Action::into_back,
     Menu::run,
     "into_back",
     "Back in the insertion",
     "Goes back to the phase before, or to the insertion before.",
     {{{GLFW_KEY_F11, kShift}, {GLFW_KEY_F11, kCtrl}}}},
    {Action::insertion,
     Menu::run,
     "insertion",
     "Next insertion",
     "Carries on until a point has been inserted.",
     {{{GLFW_KEY_RIGHT, kShift}, {GLFW_KEY_F10, 0}}}},
    {Action::insertion_back,
     Menu::run,
     "insertion_back",
     "Previous insertion",
     "Goes back to the insertion before this one.",
     {{{GLFW_KEY_LEFT, kShift}, {GLFW_KEY_F10, kShift}}}},
    {Action::stage,
     Menu::run,
     "stage",
     "Next stage",
     "Carries on to the end of this stage.",
     {{{GLFW_KEY_RIGHT, kCtrl}, {GLFW_KEY_PAGE_DOWN, 0}}}},
    {Action::stage_back,
     Menu::run,
     "stage_back",
     "Previous stage",
     "Goes back to the start of this stage, or of the one before.",
     {{{GLFW_KEY_LEFT, kCtrl}, {GLFW_KEY_PAGE_UP, 0}}}},
    {Action::round,
     Menu::run,
     "round",
     "Next round",
     "Carries on to the end of this round of steps 2 to 5, or pass of step 6.",
     {{{GLFW_KEY_N, kShift}}}},
    {Action::restart,
     Menu::run,
     "restart",
     "Restart",
     "Goes back to before the first decision.",
     {{{GLFW_KEY_HOME, kCtrl}}}},
    {Action::to_end,
     Menu::run,
     "to_end",
     "To the end",
     "Carries on until the mesh is finished.",
     {{{GLFW_KEY_END, 0}}}},
    {Action::slower,
     Menu::run,
     "slower",
     "Slower",
     "Halves the speed of playing.",
     {{{GLFW_KEY_LEFT_BRACKET, 0}, {GLFW_KEY_COMMA, 0}}}},
    {Action::faster,
     Menu::run,
     "faster",
     "Faster",
     "Doubles the speed of playing.",
     {{{GLFW_KEY_RIGHT_BRACKET, 0}, {GLFW_KEY_PERIOD, 0}}}},
    {Action::cancel,
     Menu::run,
     "cancel",
     "Cancel",
     "Stops what is under way, closes a dialog, or drops the selection; never quits.",
     {{{GLFW_KEY_ESCAPE, 0}}}},
    {Action::undo,
     Menu::edit,
     "undo",
     "Undo",
     "Takes back the last change of a parameter or of a density constraint.",
     {{{GLFW_KEY_Z, kCtrl}}}},
    {Action::redo,
     Menu::edit,
     "redo",
     "Redo",
     "Makes the change that was taken back again.",
     {{{GLFW_KEY_Z, kCtrl | kShift}, {GLFW_KEY_Y, kCtrl}}}},

    {Action::place_density,
     Menu::edit,
     "place_density",
     "Place density constraints",
     "A click places one, a drag moves one; Alt+click places one at any time.",
     {{{GLFW_KEY_E, 0}}}},
    {Action::delete_density,
     Menu::edit,
     "delete_density",
     "Delete density constraint",
     "Deletes the density constraint that is selected.",
     {{{GLFW_KEY_DELETE, 0}}}},

    {Action::continue_forward,
     Menu::debug,
     "continue_forward",
     "Continue",
     "Carries on to the next breakpoint that stops, or to the end.",
     {{{GLFW_KEY_F5, 0}}}},
    {Action::continue_back,
     Menu::debug,
     "continue_back",
     "Continue backwards",
     "Goes back to the last breakpoint that stops.",
     {{{GLFW_KEY_F5, kShift}}}},
    {Action::breakpoint,
     Menu::debug,
     "breakpoint",
     "Break on what is selected",
     "Stops at each decision about the selected triangle, vertex or cell; again takes the breakpoint away.",
     {{{GLFW_KEY_F9, 0}}}},
    {Action::first_violation,
     Menu::debug,
     "first_violation",
     "Find the first violation",
     "Goes to the first decision of the run that breaks a bound of the paper or a rule of validity.",
     {{{GLFW_KEY_F9, kShift}}}},
    {Action::bookmark,
     Menu::debug,
     "bookmark",
     "Bookmark",
     "Marks this decision on the timeline, or takes the mark away.",
     {{{GLFW_KEY_M, 0}}}},
    {Action::previous_mark,
     Menu::debug,
     "previous_mark",
     "Previous mark",
     "Goes back to the bookmark or the breakpoint met before this decision.",
     {{{GLFW_KEY_J, kShift}}}},
    {Action::next_mark,
     Menu::debug,
     "next_mark",
     "Next mark",
     "Goes to the next bookmark, or breakpoint met before.",
     {{{GLFW_KEY_J, 0}}}},
    {Action::why,
     Menu::debug,
     "why",
     "Why is it here?",
     "Says why the selected element is there.",
     {{{GLFW_KEY_Y, 0}}}},
    {Action::breakpoints_panel,
     Menu::debug,
     "breakpoints_panel",
     "Breakpoints",
     "Shows or hides the breakpoints.",
     {{{GLFW_KEY_B, kCtrl}}}},
    {Action::plots_panel,
     Menu::debug,
     "plots_panel",
     "Plots",
     "Shows or hides the measures along the run and in the mesh.",
     {{{GLFW_KEY_P, kCtrl}}}},

    {Action::fit, Menu::view, "fit", "Fit", "Shows the whole domain.", {{{GLFW_KEY_HOME, 0}, {GLFW_KEY_F, 0}}}},
    {Action::zoom_in,
     Menu::view,
     "zoom_in",
     "Zoom in",
     "Magnifies about the middle of the canvas.",
     {{{GLFW_KEY_EQUAL, 0}, {GLFW_KEY_EQUAL, kShift}, {GLFW_KEY_KP_ADD, 0}}}},
    {Action::zoom_out,
     Menu::view,
     "zoom_out",
     "Zoom out",
     "Shows more around the middle of the canvas.",
     {{{GLFW_KEY_MINUS, 0}, {GLFW_KEY_KP_SUBTRACT, 0}}}},
    {Action::worst_aspect,
     Menu::view,
     "worst_aspect",
     "Worst aspect ratio",
     "Frames and selects the triangle with the worst aspect ratio.",
     {{{GLFW_KEY_2, 0}}}},
    {Action::worst_area,
     Menu::view,
     "worst_area",
     "Worst area ratio",
     "Frames and selects the triangle with the worst area ratio.",
     {{{GLFW_KEY_3, 0}}}},
    {Action::worst_edge,
     Menu::view,
     "worst_edge",
     "Worst edge ratio",
     "Frames and selects the triangle with the worst edge ratio.",
     {{{GLFW_KEY_4, 0}}}},
    {Action::boundary,
     Menu::view,
     "boundary",
     "Boundary",
     "Shows or hides the domain's boundary.",
     {{{GLFW_KEY_B, 0}}}},
    {Action::boundary_points,
     Menu::view,
     "boundary_points",
     "Boundary points",
     "Shows or hides the points on the boundary.",
     {{{GLFW_KEY_P, 0}}}},
    {Action::quadtree,
     Menu::view,
     "quadtree",
     "Quadtree",
     "Shows or hides the background quadtree.",
     {{{GLFW_KEY_Q, 0}}}},
    {Action::constraints,
     Menu::view,
     "constraints",
     "Density constraints",
     "Shows or hides what asks for short edges.",
     {{{GLFW_KEY_K, 0}}}},
    {Action::fronts,
     Menu::view,
     "fronts",
     "Fronts",
     "Shows or hides the points of the two fronts.",
     {{{GLFW_KEY_N, 0}}}},
    {Action::steiner,
     Menu::view,
     "steiner",
     "Inserted points",
     "Shows or hides the points of steps 1 to 5.",
     {{{GLFW_KEY_I, 0}}}},
    {Action::triangulation,
     Menu::view,
     "triangulation",
     "Triangulation",
     "Shows or hides the triangles.",
     {{{GLFW_KEY_T, 0}}}},
    {Action::obtuse, Menu::view, "obtuse", "Obtuse triangles", "Highlights the obtuse triangles.", {{{GLFW_KEY_O, 0}}}},
    {Action::worst,
     Menu::view,
     "worst",
     "Worst circles",
     "Shows or hides the circles about the three worst triangles.",
     {{{GLFW_KEY_W, 0}}}},
    {Action::decision,
     Menu::view,
     "decision",
     "Current decision",
     "Shows or hides what the last decision looked at and changed.",
     {{{GLFW_KEY_D, 0}}}},
    {Action::labels, Menu::view, "labels", "Labels", "Shows or hides the texts in the picture.", {{{GLFW_KEY_L, 0}}}},
    {Action::legend, Menu::view, "legend", "Legend", "Shows or hides the legend.", {{{GLFW_KEY_G, 0}}}},
    {Action::next_fill,
     Menu::view,
     "next_fill",
     "Next colouring",
     "Colours the triangles by the next measure.",
     {{{GLFW_KEY_C, 0}}}},
    {Action::next_theme,
     Menu::view,
     "next_theme",
     "Next theme",
     "Light, dark, high contrast.",
     {{{GLFW_KEY_T, kCtrl}}}},
    {Action::larger,
     Menu::view,
     "larger",
     "Larger",
     "Makes text and controls larger, up to 300 %.",
     {{{GLFW_KEY_EQUAL, kCtrl}, {GLFW_KEY_EQUAL, kCtrl | kShift}, {GLFW_KEY_KP_ADD, kCtrl}}}},
    {Action::smaller,
     Menu::view,
     "smaller",
     "Smaller",
     "Makes text and controls smaller, down to 75 %.",
     {{{GLFW_KEY_MINUS, kCtrl}, {GLFW_KEY_KP_SUBTRACT, kCtrl}}}},
    {Action::normal_size,
     Menu::view,
     "normal_size",
     "Monitor's size",
     "Sets text and controls to the monitor's own scale.",
     {{{GLFW_KEY_0, kCtrl}}}},

    {Action::help,
     Menu::help,
     "help",
     "Keys and mouse",
     "Shows or hides the list of keys.",
     {{{GLFW_KEY_F1, 0}, {GLFW_KEY_SLASH, kShift}}}},
    {Action::about, Menu::help, "about", "About Triscope", "Says what this program is.", {}},
}};

constexpr bool inOrder() {
  for (int i = 0; i < kActionCount; ++i)
    if (static_cast<int>(kActions[static_cast<std::size_t>(i)].id) != i) return false;
  return true;
}
static_assert(inOrder());

struct KeyName {
  int key;
  std::string_view name;
};
constexpr auto kKeyNames = std::to_array<KeyName>({
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_ESCAPE, "Esc"},
    {GLFW_KEY_DELETE, "Del"},
    {GLFW_KEY_LEFT_BRACKET, "["},
    {GLFW_KEY_RIGHT_BRACKET, "]"},
    {GLFW_KEY_COMMA, ","},
    {GLFW_KEY_PERIOD, "."},
    {GLFW_KEY_EQUAL, "="},
    {GLFW_KEY_MINUS, "-"},
    {GLFW_KEY_SLASH, "/"},
    {GLFW_KEY_KP_ADD, "Keypad +"},
    {GLFW_KEY_KP_SUBTRACT, "Keypad -"},
});

std::string keyName(int key) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
    return {static_cast<char>(key)};
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  for (const KeyName& k : kKeyNames)
    if (k.key == key) return std::string(k.name);
  return fmt::format("key {}", key);
}

/// A label without the ellipsis that says a dialog follows.
std::string_view withoutDots(std::string_view label) {
  constexpr std::string_view kDots = "…";
  return label.ends_with(kDots) ? label.substr(0, label.size() - kDots.size()) : label;
}

}  // namespace

std::span<const ActionInfo> actions() { return kActions; }

std::optional<Action> actionFor(int key, int mods) {
  constexpr int kMatter = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const Chord pressed{key, mods & kMatter};
  for (const ActionInfo& info : kActions)
    if (std::find(info.chords.begin(), info.chords.end(), pressed) != info.chords.end()) return info.id;
  return std::nullopt;
}

bool isModifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

bool isFunctionKey(int key) { return key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25; }

bool withCtrl(int mods) { return (mods & kCtrl) != 0; }

std::string_view nameOf(Menu menu) {
  switch (menu) {
    case Menu::file:
      return "File";
    case Menu::edit:
      return "Edit";
    case Menu::run:
      return "Run";
    case Menu::debug:
      return "Break";
    case Menu::view:
      return "View";
    case Menu::help:
      return "Help";
  }
  return "";
}

std::string textOf(Chord chord) {
  if (chord == Chord{GLFW_KEY_SLASH, kShift}) return "?";
  if (chord == Chord{GLFW_KEY_EQUAL, kShift}) return "+";
  if (chord == Chord{GLFW_KEY_EQUAL, kCtrl | kShift}) return "Ctrl++";
  std::string text;
  if ((chord.mods & GLFW_MOD_CONTROL) != 0) text += "Ctrl+";
  if ((chord.mods & GLFW_MOD_SHIFT) != 0) text += "Shift+";
  if ((chord.mods & GLFW_MOD_ALT) != 0) text += "Alt+";
  return text + keyName(chord.key);
}

std::string keysOf(const ActionInfo& info) {
  std::string text;
  for (const Chord& chord : info.chords) {
    if (chord.key == 0) continue;
    if (!text.empty()) text += ", ";
    text += textOf(chord);
  }
  return text;
}

std::string keysAsMarkdown() {
  std::string text = "# Keys\n\nPrinted from the program's own table; F1 shows the same in the window.\n";
  for (const Menu menu : {Menu::file, Menu::edit, Menu::run, Menu::debug, Menu::view, Menu::help}) {
    text += fmt::format("\n## {}\n\n| key | what it does |\n|---|---|\n", nameOf(menu));
    for (const ActionInfo& info : kActions)
      if (info.menu == menu && info.chords[0].key != 0)
        text += fmt::format("| {} | **{}.** {} |\n", keysOf(info), withoutDots(info.label), info.help);
  }
  return text;
}

}  // namespace triscope
