#include "ui/kit/imgui_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/stroke.h"
#include "ui/kit/imgui_pixels.h"
#include "ui/kit/style.h"

namespace triscope {
namespace {

/// Dear ImGui measures a font by its line, everything else by its em.
float lineOverEm(const ImFont& font) {
  constexpr const char* kSample = "Hamburgefonstiv";
  const float width = font.CalcTextSizeA(100.0f, 1e6f, 0.0f, kSample).x;
  return width > 0.0f ? static_cast<float>(textWidth(kSample, 100.0)) / width : 1.0f;
}

/// Part of a triangle between two parallel lines, for hatching: at most five corners.
void fillStripe(ImDrawList& list, const std::array<Pixel, 3>& corners, double from, double to, ImU32 color) {
  const auto key = [](Pixel p) { return p.x + p.y; };
  std::array<ImVec2, 8> out;
  int n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Pixel a = corners[i];
    const Pixel b = corners[(i + 1) % 3];
    const double ka = key(a);
    const double kb = key(b);
    if (ka >= from && ka <= to) out[static_cast<std::size_t>(n++)] = toImVec2(a);
    const double first = ka < kb ? from : to;
    const double second = ka < kb ? to : from;
    for (const double limit : {first, second})
      if ((ka < limit) != (kb < limit))
        out[static_cast<std::size_t>(n++)] = toImVec2(a + ((limit - ka) / (kb - ka)) * (b - a));
  }
  if (n >= 3) list.AddConvexPolyFilled(out.data(), n, color);
}

}  // namespace

void ImGuiCanvas::beginClip(Rect r) {
  list_.PushClipRect(toImVec2({r.x, r.y}), toImVec2({r.x + r.width, r.y + r.height}), true);
}

void ImGuiCanvas::endClip() { list_.PopClipRect(); }

void ImGuiCanvas::fillRects(std::span<const FilledRect> rects) {
  for (const auto& [r, fill] : rects)
    list_.AddRectFilled(toImVec2({r.x, r.y}), toImVec2({r.x + r.width, r.y + r.height}), toImU32(fill));
}

void ImGuiCanvas::fillTriangles(std::span<const Pixel> points, std::span<const Index3> triangles,
                                std::span<const Color> fills, bool hatched) {
  constexpr double kSpacing = 7.0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const ImU32 color = toImU32(fills[fills.size() == 1 ? 0 : t]);
    const std::array<Pixel, 3> p{points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
    if (!hatched) {
      list_.AddTriangleFilled(toImVec2(p[0]), toImVec2(p[1]), toImVec2(p[2]), color);
      continue;
    }
    const auto [low, high] = std::minmax({p[0].x + p[0].y, p[1].x + p[1].y, p[2].x + p[2].y});
    const auto first = static_cast<int>(std::floor(low / kSpacing));
    const auto last = static_cast<int>(std::ceil(high / kSpacing));
    for (int stripe = first; stripe < last; ++stripe)
      fillStripe(list_, p, stripe * kSpacing, (stripe + 0.35) * kSpacing, color);
  }
}

void ImGuiCanvas::stroke(const Paths& paths, const LineStyle& style) {
  const DashPattern pattern = patternOf(style.dash);
  const auto draw = [&](std::span<const Pixel> path) {
    std::vector<ImVec2> points(path.size());
    std::transform(path.begin(), path.end(), points.begin(), toImVec2);
    list_.AddPolyline(points.data(), static_cast<int>(points.size()), toImU32(style.color), ImDrawFlags_None,
                      style.width);
  };
  for (std::size_t i = 0; i < paths.starts.size(); ++i) {
    if (pattern.count == 0) {
      draw(paths.path(i));
      continue;
    }
    const Paths pieces = dashed(paths.path(i), pattern, dashUnit(style.width));
    for (std::size_t k = 0; k < pieces.starts.size(); ++k) draw(pieces.path(k));
  }
}

void ImGuiCanvas::circle(Pixel centre, double radius, const LineStyle& style) {
  Paths rim;
  rim.points = circlePolyline(centre, radius);
  rim.starts = {0};
  stroke(rim, style);
}

void ImGuiCanvas::marks(std::span<const PlacedMark> marks, Shape shape, Color fill, Color outline) {
  const std::span<const Pixel> corners = markOutline(shape);
  for (const PlacedMark& mark : marks) {
    const ImVec2 at = toImVec2(mark.at);
    const float radius = 0.5f * mark.size;
    if (shape == Shape::circle) {
      list_.AddCircleFilled(at, radius, toImU32(fill));
      if (outline.a > 0) list_.AddCircle(at, radius, toImU32(outline));
      continue;
    }
    if (shape == Shape::ring) {
      list_.AddCircle(at, radius, toImU32(fill), 0, 1.4f);
      continue;
    }
    std::vector<ImVec2> points;
    for (const Pixel& c : corners) points.push_back(toImVec2(mark.at + static_cast<double>(mark.size) * c));
    if (shape == Shape::cross) {
      list_.AddLine(points[0], points[1], toImU32(fill), 1.6f);
      list_.AddLine(points[2], points[3], toImU32(fill), 1.6f);
      continue;
    }
    list_.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), toImU32(fill));
    if (outline.a > 0)
      list_.AddPolyline(points.data(), static_cast<int>(points.size()), toImU32(outline), ImDrawFlags_Closed, 1.0f);
  }
}

void ImGuiCanvas::text(Pixel at, std::string_view text, const TextStyle& style) {
  const ImFont& font = style.weight == Weight::semibold ? *fonts_.strong : *fonts_.text;
  const float size = static_cast<float>(style.size) * lineOverEm(*fonts_.text);
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const double width = static_cast<double>(font.CalcTextSizeA(size, 1e6f, 0.0f, begin, end).x);
  const double start = style.anchor == Anchor::left ? 0.0 : style.anchor == Anchor::centre ? 0.5 * width : width;
  const ImVec2 corner{std::round(static_cast<float>(at.x - start)),
                      std::round(static_cast<float>(at.y) - font.Ascent * size / font.FontSize)};
  if (style.halo.a > 0) {
    // Two rings of copies: one alone lets lines show through between the copies.
    constexpr int kCopies = 12;
    const float reach = std::max(2.0f, size * 0.18f);
    for (int k = 0; k < 2 * kCopies; ++k) {
      const float turn = 6.2831853f * static_cast<float>(k) / static_cast<float>(kCopies);
      const float far = k < kCopies ? reach : 0.55f * reach;
      list_.AddText(&font, size, {corner.x + far * std::cos(turn), corner.y + far * std::sin(turn)},
                    toImU32(style.halo), begin, end);
    }
  }
  list_.AddText(&font, size, corner, toImU32(style.color), begin, end);
}

}  // namespace triscope
