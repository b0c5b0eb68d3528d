// Dialogs that only say something: an error, the keys, what this program is.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/capitalised.h"
#include "core/base/version.h"
#include "core/explain/fields.h"
#include "ui/dialog/dialogs.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

void closeButton(const View& view, Orders& orders, const char* label) {
  ImGui::Dummy({0, view.px(2)});
  if (ImGui::Button(label, {view.px(110), 0.0f})) orders.emplace_back(order::CloseDialog{});
  note(view, "dialog.close");
}

/// "file, loop 'name', point 3, at (x, y)".
std::string placeOf(const Error& error) {
  std::string text = error.file;
  const auto add = [&text](const std::string& part) { text += text.empty() ? part : ", " + part; };
  if (!error.loop.empty()) add(fmt::format("loop '{}'", error.loop));
  if (error.point >= 0) add(fmt::format("point {}", error.point));
  if (error.at) add(fmt::format("at {}", placeText(*error.at)));
  return text;
}

struct MouseHint {
  const char* gesture;
  const char* what;
};
constexpr std::array<MouseHint, 9> kMouse{{
    {"wheel", "zooms to the cursor"},
    {"drag", "moves the picture"},
    {"click", "picks a vertex, an edge or a triangle"},
    {"Ctrl+click", "picks the quadtree cell"},
    {"Alt+click", "places a density constraint"},
    {"Shift+drag", "shows what the box holds"},
    {"double click", "centres"},
    {"right click", "more about the place"},
    {"drop a file", "opens it"},
}};

void keyTable(const View& view, Menu menu) {
  heading(view, std::string(nameOf(menu)).c_str());
  ImGui::PushID(static_cast<int>(menu));
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const ActionInfo& info : actions()) {
      if (info.menu != menu || info.chords[0].key == 0) continue;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", keysOf(info).c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(std::string(info.label).c_str());
    }
    ImGui::EndTable();
  }
  ImGui::PopID();
}

void mouseTable(const View& view) {
  heading(view, "Mouse");
  if (!ImGui::BeginTable("mouse", 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const MouseHint& hint : kMouse) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", hint.gesture);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(hint.what);
  }
  ImGui::EndTable();
}

}  // namespace

void drawErrorDialog(const View& view, Orders& orders) {
  if (!view.ui.error || !beginDialog(view, "This did not work", 520)) return;
  const Error& error = *view.ui.error;
  ImGui::PushFont(view.fonts.strong);
  wrapped(capitalised(error.message) + ".");
  ImGui::PopFont();
  if (const std::string place = placeOf(error); !place.empty()) muted(view, "Where: " + place);
  if (!error.hint.empty()) wrapped("What to do: " + error.hint + ".");
  if (view.now() != nullptr) muted(view, "The mesh from before is still there.");
  closeButton(view, orders, "OK");
  ImGui::EndPopup();
}

void drawHelpDialog(const View& view, Orders& orders) {
  if (!beginDialog(view, "Keys and mouse", 900)) return;
  const float below = view.px(2) + ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().ItemSpacing.y;  // the button
  const float height = std::clamp(dialogRoom(view) - below, view.px(40), view.px(590));
  if (ImGui::BeginChild("help", {0.0f, height})) {
    const bool wide = ImGui::GetContentRegionAvail().x >= view.px(800);
    if (ImGui::BeginTable("columns", wide ? 2 : 1)) {
      ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {view.px(6), view.px(1)});
      ImGui::TableNextColumn();
      keyTable(view, Menu::run);
      keyTable(view, Menu::file);
      keyTable(view, Menu::edit);
      keyTable(view, Menu::debug);
      keyTable(view, Menu::compare);
      ImGui::TableNextColumn();
      keyTable(view, Menu::view);
      keyTable(view, Menu::help);
      mouseTable(view);
      ImGui::PopStyleVar();
      ImGui::EndTable();
    }
  }
  ImGui::EndChild();
  closeButton(view, orders, "Close");
  ImGui::EndPopup();
}

void drawAboutDialog(const View& view, Orders& orders) {
  if (!beginDialog(view, "About Triscope", 460)) return;
  ImGui::PushFont(view.fonts.title);
  ImGui::TextUnformatted(("Triscope " + thisVersion().program).c_str());
  ImGui::PopFont();
  wrapped(
      "Shows, step by step, how an unstructured triangle mesh comes about: density from a background quadtree, "
      "two fronts of points along the boundary, Steiner points at circumcentres until every bound holds, and local "
      "refinements.");
  muted(view, "MIT licence. The letters are Inter and DejaVu Sans Mono, under licences of their own.");
  closeButton(view, orders, "Close");
  ImGui::EndPopup();
}

}  // namespace triscope
