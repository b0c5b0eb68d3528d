#include "ui/model/action.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

namespace triscope {
namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL;
constexpr int kShift = GLFW_MOD_SHIFT;

struct KeyName {
  int key;
  std::string_view name;
};
constexpr auto kKeyNames = std::to_array<KeyName>({
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_KP_ENTER, "Keypad Enter"},
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
  constexpr std::string_view kEllipsis = "…";
  return label.ends_with(kEllipsis) ? label.substr(0, label.size() - kEllipsis.size()) : label;
}

}  // namespace

std::optional<Action> actionFor(int key, int mods, Scope scope) {
  constexpr int kMatter = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const KeyChord pressed{key, mods & kMatter};
  for (const ActionInfo& info : actions())
    if (info.scope == scope && std::find(info.chords.begin(), info.chords.end(), pressed) != info.chords.end())
      return info.id;
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
    case Menu::compare:
      return "Compare";
    case Menu::view:
      return "View";
    case Menu::help:
      return "Help";
  }
  return "";
}

std::string textOf(KeyChord chord) {
  if (chord == KeyChord{GLFW_KEY_SLASH, kShift}) return "?";
  if (chord == KeyChord{GLFW_KEY_EQUAL, kShift}) return "+";
  if (chord == KeyChord{GLFW_KEY_EQUAL, kCtrl | kShift}) return "Ctrl++";
  std::string text;
  if ((chord.mods & GLFW_MOD_CONTROL) != 0) text += "Ctrl+";
  if ((chord.mods & GLFW_MOD_SHIFT) != 0) text += "Shift+";
  if ((chord.mods & GLFW_MOD_ALT) != 0) text += "Alt+";
  return text + keyName(chord.key);
}

std::string keysOf(const ActionInfo& info) {
  std::string text;
  for (const KeyChord& chord : info.chords) {
    if (chord.key == 0) continue;
    if (!text.empty()) text += " or ";
    text += textOf(chord);
  }
  return text;
}

std::string keysAsMarkdown() {
  std::string text = "# Keys\n\nPrinted from the program's own table; F1 shows the same in the window.\n";
  for (const Menu menu : {Menu::file, Menu::edit, Menu::run, Menu::debug, Menu::compare, Menu::view, Menu::help}) {
    text += fmt::format("\n## {}\n\n| key | what it does |\n|---|---|\n", nameOf(menu));
    for (const ActionInfo& info : actions())
      if (info.menu == menu && info.chords[0].key != 0)
        text += fmt::format("| {} | **{}.** {} |\n", keysOf(info), withoutDots(info.label), info.help);
  }
  return text;
}

}  // namespace triscope
