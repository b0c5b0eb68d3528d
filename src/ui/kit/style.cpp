#include "ui/kit/style.h"

#include <algorithm>
#include <cmath>

namespace triscope {

Color accentOf(const Theme& theme) { return theme.dark ? okabe::sky : okabe::blue; }

Color onAccent(const Theme& theme) { return theme.dark ? rgb(0x101418) : rgb(0xFFFFFF); }

void applyStyle(const Theme& theme, float scale) {
  ImGuiStyle style;
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowRounding = 0;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 1;
  style.FrameBorderSize = 1;
  style.TabBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.DisabledAlpha = 0.5f;

  // Surfaces in steps from the panel toward the text, so that one rule serves light, dark and high contrast.
  const auto step = [&theme](double t) { return toImVec4(mix(theme.surface, theme.text, t)); };
  const Color accent = accentOf(theme);
  const auto tint = [&](double t) { return toImVec4(mix(theme.surface, accent, t)); };
  // Controls must be seen at 3:1 where their border is all there is to see.
  double edge = 0.15;
  while (edge < 1.0 && contrast(mix(theme.surface, theme.text, edge), theme.surface) < 1.9) edge += 0.02;

  ImVec4* const c = style.Colors;
  c[ImGuiCol_Text] = toImVec4(theme.text);
  c[ImGuiCol_TextDisabled] = toImVec4(theme.textMuted);
  c[ImGuiCol_WindowBg] = toImVec4(theme.surface);
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = toImVec4(theme.surface);
  c[ImGuiCol_Border] = step(edge);
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_FrameBg] = toImVec4(theme.background);
  c[ImGuiCol_FrameBgHovered] = tint(0.15);
  c[ImGuiCol_FrameBgActive] = tint(0.25);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = step(0.06);
  c[ImGuiCol_MenuBarBg] = step(0.03);
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = step(0.25);
  c[ImGuiCol_ScrollbarGrabHovered] = step(0.4);
  c[ImGuiCol_ScrollbarGrabActive] = step(0.5);
  c[ImGuiCol_CheckMark] = toImVec4(accent);
  c[ImGuiCol_SliderGrab] = tint(0.4);  // the value is written over it
  c[ImGuiCol_SliderGrabActive] = tint(0.55);
  c[ImGuiCol_Button] = step(0.04);
  c[ImGuiCol_ButtonHovered] = tint(0.2);
  c[ImGuiCol_ButtonActive] = tint(0.4);
  c[ImGuiCol_Header] = tint(0.22);
  c[ImGuiCol_HeaderHovered] = tint(0.15);
  c[ImGuiCol_HeaderActive] = tint(0.32);
  c[ImGuiCol_Separator] = step(0.15);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = toImVec4(accent);
  c[ImGuiCol_ResizeGrip] = c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = step(0.2);
  c[ImGuiCol_Tab] = step(0.05);
  c[ImGuiCol_TabHovered] = step(0.14);  // not as the active one
  c[ImGuiCol_TabActive] = tint(0.25);
  c[ImGuiCol_TabUnfocused] = c[ImGuiCol_Tab];
  c[ImGuiCol_TabUnfocusedActive] = c[ImGuiCol_TabActive];
  c[ImGuiCol_PlotHistogram] = toImVec4(accent);
  c[ImGuiCol_TableHeaderBg] = step(0.06);
  c[ImGuiCol_TableBorderStrong] = step(0.2);
  c[ImGuiCol_TableBorderLight] = step(0.1);
  c[ImGuiCol_TableRowBg] = {0, 0, 0, 0};
  c[ImGuiCol_TableRowBgAlt] = step(0.025);
  c[ImGuiCol_TextSelectedBg] = tint(0.4);
  c[ImGuiCol_NavHighlight] = toImVec4(accent);
  c[ImGuiCol_ModalWindowDimBg] = toImVec4(faded(rgb(0x000000), 0.35));

  style.ScaleAllSizes(scale);
  // Borders grow in whole pixels.
  style.FrameBorderSize = style.WindowBorderSize = std::max(1.0f, std::floor(scale));
  ImGui::GetStyle() = style;
}

}  // namespace triscope
