#include <fmt/format.h>

#include <array>

#include "render/number.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

void part(const View& view, const std::string& text, float width) {
  const float x = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(text.c_str());
  ImGui::SameLine(x + view.px(static_cast<double>(width)));
}

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
  const Point p = view.ui.cursor.value_or(Point{});
  part(view, view.ui.cursor ? fmt::format("x {}  y {}", compact(p.x, 5), compact(p.y, 5)) : "", 190);
  const Snapshot* const now = view.now();
  if (now != nullptr) {
    part(view,
         fmt::format("{} vertices  {} triangles", grouped(now->quality.vertices), grouped(now->quality.triangles)),
         250);
    if (now->quality.triangles > 0) bounds(view, now->quality);
  }
  if (!view.ui.message.empty()) {
    ImGui::SameLine(0.0f, view.px(24));
    ImGui::TextUnformatted(view.ui.message.c_str());
    note(view, "message");
  }
  const std::string frame = fmt::format("{:.0f} ms", view.ui.frameMs);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(frame.c_str()).x);
  ImGui::TextDisabled("%s", frame.c_str());
  tip(view, "Time that the last frame took to make.");
}

}  // namespace triscope
