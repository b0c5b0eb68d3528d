#include "ui/kit/icons.h"

#include <array>
#include <numbers>

namespace triscope {
namespace {

/// Draws in a square from (-1, -1) to (1, 1), y down; `mirror` turns it left to right.
struct Pen {
  ImDrawList& list;
  ImVec2 centre;
  float half = 1.0f;
  ImU32 color = 0;
  float mirror = 1.0f;

  [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + mirror * half * x, centre.y + half * y}; }
  void triangle(float x, float width, float height) const {
    list.AddTriangleFilled(at(x, -height), at(x + width, 0.0f), at(x, height), color);
  }
  void bar(float x, float width, float height) const {
    const ImVec2 a = at(x, -height);
    const ImVec2 b = at(x + width, height);
    list.AddRectFilled({a.x < b.x ? a.x : b.x, a.y}, {a.x < b.x ? b.x : a.x, b.y}, color);
  }
  void line(ImVec2 a, ImVec2 b) const { list.AddLine(a, b, color, thickness()); }
  [[nodiscard]] float thickness() const { return 0.22f * half; }
};

void frameCorners(const Pen& pen) {
  for (const float sx : {-1.0f, 1.0f})
    for (const float sy : {-1.0f, 1.0f}) {
      const std::array<ImVec2, 3> corner{pen.at(sx * 0.9f, sy * 0.3f), pen.at(sx * 0.9f, sy * 0.9f),
                                         pen.at(sx * 0.3f, sy * 0.9f)};
      pen.list.AddPolyline(corner.data(), static_cast<int>(corner.size()), pen.color, ImDrawFlags_None,
                           pen.thickness());
    }
}

void camera(const Pen& pen) {
  pen.list.AddRect(pen.at(-0.95f, -0.5f), pen.at(0.95f, 0.75f), pen.color, 0.2f * pen.half, ImDrawFlags_None,
                   pen.thickness());
  pen.list.AddRectFilled(pen.at(-0.35f, -0.8f), pen.at(0.35f, -0.45f), pen.color);
  pen.list.AddCircle(pen.at(0.0f, 0.12f), 0.34f * pen.half, pen.color, 0, pen.thickness());
}

void folder(const Pen& pen) {
  const std::array<ImVec2, 6> outline{pen.at(-0.95f, 0.7f),  pen.at(-0.95f, -0.7f), pen.at(-0.3f, -0.7f),
                                      pen.at(-0.05f, -0.4f), pen.at(0.95f, -0.4f),  pen.at(0.95f, 0.7f)};
  pen.list.AddPolyline(outline.data(), static_cast<int>(outline.size()), pen.color, ImDrawFlags_Closed,
                       pen.thickness());
}

void turnAround(const Pen& pen) {
  constexpr float kPi = std::numbers::pi_v<float>;
  pen.list.PathArcTo(pen.centre, 0.75f * pen.half, -0.35f * kPi, 1.2f * kPi, 24);
  pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.thickness());
  pen.list.AddTriangleFilled(pen.at(0.0f, -0.95f), pen.at(0.75f, -0.85f), pen.at(0.35f, -0.25f), pen.color);
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float side, ImU32 color) {
  Pen pen{list, centre, 0.5f * side, color};
  const bool back =
      icon == Icon::step_back || icon == Icon::insertion_back || icon == Icon::stage_back || icon == Icon::restart;
  if (back) pen.mirror = -1.0f;
  switch (icon) {
    case Icon::none:
      break;
    case Icon::play:
      pen.triangle(-0.6f, 1.4f, 0.85f);
      break;
    case Icon::pause:
      pen.bar(-0.7f, 0.45f, 0.8f);
      pen.bar(0.25f, 0.45f, 0.8f);
      break;
    case Icon::step:
    case Icon::step_back:  // one arrow: one decision
      pen.triangle(-0.45f, 0.95f, 0.6f);
      break;
    case Icon::insertion:
    case Icon::insertion_back:  // an arrow to a point
      pen.triangle(-0.85f, 0.9f, 0.6f);
      list.AddCircleFilled(pen.at(0.55f, 0.0f), 0.32f * pen.half, color);
      break;
    case Icon::stage:
    case Icon::stage_back:  // two arrows
      pen.triangle(-0.9f, 0.9f, 0.65f);
      pen.triangle(0.0f, 0.9f, 0.65f);
      break;
    case Icon::to_end:
    case Icon::restart:  // to the wall
      pen.triangle(-0.75f, 1.1f, 0.7f);
      pen.bar(0.45f, 0.25f, 0.7f);
      break;
    case Icon::fit:
      frameCorners(pen);
      break;
    case Icon::camera:
      camera(pen);
      break;
    case Icon::open:
      folder(pen);
      break;
    case Icon::reload:
      turnAround(pen);
      break;
  }
}

}  // namespace triscope
