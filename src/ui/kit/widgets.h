// Small widgets that every panel uses: each says why it is disabled, and where it is when a test asks.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "ui/kit/icons.h"
#include "ui/model/view.h"

namespace triscope {

/// Remembers the last item's place under this name.
void note(const View& view, std::string_view name, bool enabled = true);
/// Tooltip of the last item, shown for disabled ones too; not while one works by keys.
void tip(const View& view, const std::string& text);
/// The same above the item instead of beside the mouse, where it would cover what one looks at.
void tipAbove(const View& view, const std::string& text);

/// Width of a button with an icon; buttons are narrower in a low window, where one row of them must do.
float iconButtonWidth(const View& view);
/// Whether the window is so low that what can be reached by menus makes room for the picture.
bool inLowWindow(const View& view);
/// A button for an action, with its icon, or its label where there is none; disabled with the reason as a tooltip.
void actionButton(const View& view, Orders& orders, Action action, Icon icon);
/// The same with a label of its own; tests know it as `name`.
void actionButton(const View& view, Orders& orders, Action action, const char* label, std::string_view name);
/// An entry of a menu for an action, likewise.
void actionEntry(const View& view, Orders& orders, Action action, const char* label, std::string_view name);
/// A check box for an action that is a switch.
void actionSwitch(const View& view, Orders& orders, Action action, const char* label);

/// SameLine() where a button with this label still fits beside the last item; else it goes on a line of its own.
void besideIfFits(const char* label);

/// "label        value" across the width that is left, the value at the right.
void figure(const View& view, const char* label, const std::string& value);
void figure(const View& view, const char* label, const std::string& value, Color valueColor);
void heading(const View& view, const char* text);
void muted(const View& view, const std::string& text);
/// Text in as many lines as it needs.
void wrapped(const std::string& text);
/// What a panel is about, in the large font; tests know it as `name`.
void title(const View& view, const std::string& text, std::string_view name);
/// A word in the accent colour that can be clicked.
bool link(const View& view, const std::string& text);

/// Whether a menu or the list of a combo box is open.
bool menuOpen();
void closeMenus();

/// Begins a small window over the picture: `at` is where its `pivot` (0 … 1 of its size) goes. Call endFloating() in
/// any case, and draw in it when true.
bool beginFloating(const View& view, const char* name, ImVec2 at, ImVec2 pivot, float width);
void endFloating();

/// Begins a modal dialog of this width (at 100 %), in the middle of the window. Call ImGui::EndPopup() when true.
bool beginDialog(const View& view, const char* title, double width);
/// Height of what a dialog can hold at most without a scroll bar.
float dialogRoom(const View& view);

}  // namespace triscope
