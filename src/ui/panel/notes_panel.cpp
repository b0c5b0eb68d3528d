// Notes on the run, and the names of bookmarks: what somebody writes down for later.
#include <imgui.h>
// After imgui.h, which it needs.
#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/base/number.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

constexpr double kNotesHeight = 180.0;  // pixels at 100 %

void bookmark(const View& view, Orders& orders, std::size_t index) {
  const Bookmark& mark = view.ui.debug.bookmarks[index];
  ImGui::PushID(static_cast<int>(index));
  std::string name = mark.name;
  const float button = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::InputTextWithHint("##name", "name", &name)) orders.emplace_back(order::NameBookmark{index, name});
  note(view, fmt::format("notes.bookmark.{}", index));
  ImGui::SameLine();
  if (ImGui::Button("\xE2\x9C\x95", {button, button})) orders.emplace_back(order::DropBookmark{index});
  note(view, fmt::format("notes.bookmark.{}.delete", index));
  tip(view, "Takes the bookmark away.");
  if (link(view, fmt::format("decision {}", grouped(mark.tick)))) orders.emplace_back(command::Seek{mark.tick});
  note(view, fmt::format("notes.bookmark.{}.go", index));
  ImGui::PopID();
}

}  // namespace

void drawNotes(const View& view, Orders& orders) {
  heading(view, "Notes");
  std::string text = view.ui.document.notes;
  // The field grows with its lines.
  const auto lines = static_cast<float>(std::count(text.begin(), text.end(), '\n') + 2);
  const float height = std::max(view.px(kNotesHeight), lines * ImGui::GetTextLineHeight());
  if (ImGui::InputTextMultiline("##notes", &text, {-1.0f, height})) orders.emplace_back(order::WriteNotes{text});
  note(view, "notes.text");
  muted(view, "Saved with the session (Ctrl+S).");
  heading(view, "Bookmarks");
  const std::size_t count = view.ui.debug.bookmarks.size();
  if (count == 0) muted(view, "None yet: M marks the current decision.");
  for (std::size_t k = 0; k < count; ++k) bookmark(view, orders, k);
}

}  // namespace triscope
