#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/method/estimate.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

/// Parts from left to right, as long as there is room before `end`.
struct StatusRow {
  float end;
  float gap;
  bool first = true;
  /// True when a part of this width can be drawn; it then goes at the cursor.
  bool room(float width) {
    if (!first) ImGui::SameLine(0.0f, gap);
    const bool fits = ImGui::GetCursorPosX() + width <= end;
    if (!fits) end = 0.0f;
    first = false;
    return fits;
  }
  /// As much of it as there is room for.
  void cut(const std::string& text) {
    first = false;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(1.0f, end - ImGui::GetCursorPosX());
    ImGui::PushClipRect(at, {at.x + width, at.y + ImGui::GetTextLineHeight()}, true);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopClipRect();
  }
  bool text(const std::string& text, float atLeast = 0.0f) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (!room(std::max(width, atLeast))) return false;
    const float x = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(text.c_str());
    if (atLeast > width) {
      ImGui::SameLine(x + atLeast, 0.0f);
      ImGui::Dummy({0, 0});
    }
    return true;
  }
};

void bounds(const View& view, const Quality& q) {
  struct Bound {
    const char* name;
    bool met;
  };
  const std::array<Bound, 4> all{{{"aspect", q.aspectMax < Bounds::aspect},
                                  {"area", q.areaRatioMax < Bounds::areaRatio},
                                  {"edge", q.edgeRatioMax < Bounds::edgeRatio},
                                  {"angles", q.minAngle > Bounds::minAngle && q.maxAngle < Bounds::maxAngle}}};
  ImGui::TextDisabled("bounds:");
  for (const Bound& bound : all) {
    ImGui::SameLine(0.0f, view.px(7));
    ImGui::TextUnformatted(bound.name);
    ImGui::SameLine(0.0f, view.px(3));
    ImGui::TextColored(toImVec4(bound.met ? view.theme().front1 : view.theme().worstAspect), "%s",
                       bound.met ? "\xE2\x9C\x93" : "\xE2\x9C\x97");
  }
}

}  // namespace

void drawStatusBar(const View& view, Orders&) {
  const std::string frame = fmt::format("{:.0f} ms", view.ui.frameMs);
  const float frameAt = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(frame.c_str()).x;
  StatusRow row{frameAt - view.px(12), view.px(20)};
  const Snapshot* const now = view.now();
  if (view.ui.message.empty() && view.ui.density.placing) {
    ImGui::PushStyleColor(ImGuiCol_Text, toImU32(accentOf(view.theme())));
    row.cut("Click: place a density constraint. Drag one: move it. Del: delete it. Esc: done.");
    ImGui::PopStyleColor();
    note(view, "placing");
  } else if (!view.ui.message.empty()) {
    // What was just said matters most.
    row.cut(view.ui.message);
    note(view, "message");
    tip(view, view.ui.message);
  }
  if (now != nullptr) {
    if (now->quality.triangles > 0 && row.room(view.px(300))) bounds(view, now->quality);
    if (now->quality.triangles > 0 || now->state.estimatedTriangles <= 0.0) {
      row.text(counted(now->quality.vertices, "vertex", "vertices") + "   " +
               counted(now->quality.triangles, "triangle", "triangles"));
    } else {
      const Estimate estimate = estimateOf(now->state);
      row.text(fmt::format("about {} triangles, {}", roughCount(estimate.triangles), bytesText(estimate.bytes)));
      note(view, "estimate");
      tip(view, "What the mesh will come to by Table 1 of the paper, and the memory that it takes.");
    }
  }
  if (view.ui.cursor)
    row.text(fmt::format("x {}   y {}", compact(view.ui.cursor->x, 5), compact(view.ui.cursor->y, 5)));
  ImGui::SameLine(frameAt);
  ImGui::TextDisabled("%s", frame.c_str());
  tip(view, "Time that the last frame took to make.");
}

}  // namespace triscope
