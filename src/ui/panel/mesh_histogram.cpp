#include "ui/panel/mesh_histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/number.h"
#include "core/quality/quality.h"
#include "ui/kit/plot_frame.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

struct Spread {
  const char* name;
  double bound;
  TriangleFill fill;  // what a brushed bar marks
};
constexpr std::array<Spread, kMeasureCount> kSpreads{{
    {"aspect ratio", Bounds::aspect, TriangleFill::aspect},
    {"area ratio", Bounds::areaRatio, TriangleFill::area_ratio},
    {"edge ratio", Bounds::edgeRatio, TriangleFill::edge_ratio},
    {"smallest angle", Bounds::minAngle, TriangleFill::min_angle},
    {"largest angle", Bounds::maxAngle, TriangleFill::max_angle},
}};

/// The square root keeps a single bad triangle in sight beside thousands of good ones.
float rootPart(std::uint64_t count, std::uint32_t most) {
  return static_cast<float>(std::sqrt(static_cast<double>(count) / static_cast<double>(most)));
}

constexpr double kOpen = std::numeric_limits<double>::max();  // the end of a brush that takes in the last bar

const Spread& spreadOf(const Histogram& h) { return kSpreads[static_cast<std::size_t>(h.measure)]; }

/// Bars, both ends included.
struct BarRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

Brush brushOf(const Histogram& h, BarRange range) {
  const double high = h.low + static_cast<double>(range.last + 1) * h.width();
  return {true, spreadOf(h).fill, h.low + static_cast<double>(range.first) * h.width(),
          range.last + 1 == h.counts.size() ? kOpen : high};
}

bool marks(const Brush& brush, const Histogram& h, std::size_t bar) {
  const double middle = h.low + (static_cast<double>(bar) + 0.5) * h.width();
  return brush.on && brush.measure == spreadOf(h).fill && middle > brush.low && middle < brush.high;
}

void setBrush(const View& view, Orders& orders, const Brush& brush) {
  if (brush == view.ui.options.brush) return;
  ViewOptions options = view.ui.options;
  options.brush = brush;
  orders.emplace_back(options);
}

/// A click marks a bar, or takes away what it is part of; a drag marks the bars that it passes over. For the last item.
/// True while nothing is to be said of the bar: what has just been marked would be covered.
bool brushByMouse(const View& view, Orders& orders, const Histogram& h, std::size_t under) {
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID begun = ImGui::GetID("begun");      // the bar that was pressed
  const ImGuiID dragged = ImGui::GetID("dragged");  // another one has been reached since
  const auto start = [&] { return std::min(h.counts.size() - 1, static_cast<std::size_t>(memory.GetInt(begun))); };
  if (ImGui::IsItemActivated()) {
    memory.SetInt(begun, static_cast<int>(under));
    memory.SetBool(dragged, false);
  }
  const bool let = ImGui::IsItemDeactivated();
  if (ImGui::IsItemActive() || let) {
    if (under != start()) memory.SetBool(dragged, true);
    if (memory.GetBool(dragged))
      setBrush(view, orders, brushOf(h, {std::min(start(), under), std::max(start(), under)}));
  }
  if (let && !memory.GetBool(dragged)) {
    const bool nothing = h.counts[start()] == 0 || marks(view.ui.options.brush, h, start());
    setBrush(view, orders, nothing ? Brush{} : brushOf(h, {start(), start()}));
  }
  const ImGuiID left = ImGui::GetID("left");  // the bar that the button was let go on
  if (let) memory.SetInt(left, static_cast<int>(under));
  if (!ImGui::IsItemActive() && memory.GetInt(left, -1) != static_cast<int>(under)) memory.SetInt(left, -1);
  return ImGui::IsItemActive() || memory.GetInt(left, -1) >= 0;
}

/// "1.8 – 2.4: 312 triangles".
std::string wordsOf(const Brush& brush, std::size_t triangles) {
  const std::string range = brush.high == kOpen ? fmt::format("≥ {}", compact(brush.low, 4))
                                                : fmt::format("{} – {}", compact(brush.low, 4), compact(brush.high, 4));
  return fmt::format("{}: {}", range, counted(triangles, "triangle", "triangles"));
}

void bars(const View& view, Orders& orders, const PlotFrame& f, const Histogram& h) {
  const std::uint32_t most = *std::max_element(h.counts.begin(), h.counts.end());
  const float width = f.width() / static_cast<float>(h.counts.size());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    if (h.counts[k] == 0) continue;
    const float part = rootPart(h.counts[k], most);
    const float x = f.lo.x + static_cast<float>(k) * width;
    const bool marked = marks(view.ui.options.brush, h, k);
    const Color fill = marked ? view.theme().selection : mix(view.theme().background, accentOf(view.theme()), 0.7);
    list.AddRectFilled({x + 0.5f, f.hi.y - std::max(view.px(2), part * f.height())}, {x + width - 0.5f, f.hi.y},
                       toImU32(fill));
  }
  const double bound = spreadOf(h).bound;
  if (bound > h.low && bound < h.high) {
    const float x = f.lo.x + static_cast<float>((bound - h.low) / (h.high - h.low)) * f.width();
    dashedLine(view, {x, f.lo.y}, {x, f.hi.y}, view.theme().worstAspect);
  }
  ImGui::SetCursorScreenPos(f.lo);
  ImGui::InvisibleButton("bars", {f.width(), f.height()});
  note(view, "plots.bars");
  const float at = (ImGui::GetIO().MousePos.x - f.lo.x) / width;
  const auto bar = std::min(h.counts.size() - 1, static_cast<std::size_t>(std::max(0.0f, at)));
  if (brushByMouse(view, orders, h, bar)) return;
  const double low = h.low + static_cast<double>(bar) * h.width();
  const bool last = bar + 1 == h.counts.size();
  tipAbove(view, fmt::format("{} from {} to {}\nClick or drag to mark them in the mesh.",
                             counted(h.counts[bar], "triangle", "triangles"), compact(low, 4),
                             compact(last ? std::max(h.most, h.high) : low + h.width(), 4)));
}

/// Of `most` counted: 1, 2, 5, 10 and so on at the heights of their square roots, those that have room between 0 and
/// the highest.
std::vector<PlotTick> countTicks(const View& view, const PlotFrame& f, std::uint32_t most) {
  const float room = 1.5f * view.fonts.small->FontSize;
  std::vector<PlotTick> ticks{{f.hi.y, "0"}};
  for (std::uint64_t power = 1; power < most; power *= 10)
    for (const std::uint64_t count : {power, 2 * power, 5 * power}) {
      const float at = f.hi.y - rootPart(count, most) * f.height();
      if (count < most && ticks.back().at - at >= room && at - f.lo.y >= room) ticks.push_back({at, grouped(count)});
    }
  ticks.push_back({f.lo.y, grouped(most)});
  return ticks;
}

/// In the corner: what is marked, else what is counted.
void remark(const View& view, const PlotFrame& f, const Histogram& h) {
  const Brush& brush = view.ui.options.brush;
  const ImVec2 at{f.hi.x - view.px(5), f.lo.y + view.px(2)};
  if (!brush.on || brush.measure != spreadOf(h).fill)
    return plotText(view, at, 1.0f, "triangles, on a √ scale", view.theme().textMuted);
  const std::string words = wordsOf(brush, view.scene.brushed);
  const ImFont& font = *view.fonts.small;
  const float wide = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, words.c_str()).x;
  // Over the bars, which may be as high as the frame.
  ImGui::GetWindowDrawList()->AddRectFilled({at.x - wide - view.px(4), f.lo.y + 1.0f},
                                            {f.hi.x - 1.0f, at.y + font.FontSize + view.px(2)},
                                            toImU32(view.theme().background));
  plotText(view, at, 1.0f, words, view.theme().text);
}

/// Below: where the bars begin and end. The last bar may hold more than its width says.
void valueAxis(const View& view, const PlotFrame& f, const Histogram& h) {
  const Color muted = view.theme().textMuted;
  const float top = f.hi.y + view.px(1);
  plotText(view, {f.lo.x, top}, 0.0f, compact(h.low, 4), muted);
  const std::string end = h.most > h.high
                              ? fmt::format("last bar ≥ {}, max {}", compact(h.high - h.width(), 4), compact(h.most, 4))
                              : compact(h.high, 4);
  plotText(view, {f.hi.x, top}, 1.0f, end, muted);
}

}  // namespace

void drawMeshHistogram(const View& view, Orders& orders) {
  const DebugUi& chosen = view.ui.debug;
  int measure = static_cast<int>(chosen.histogram);
  ImGui::SetNextItemWidth(view.px(150));
  const auto nameOfSpread = [](void*, int k, const char** out) {
    *out = kSpreads[static_cast<std::size_t>(k)].name;
    return true;
  };
  if (ImGui::Combo("##spread", &measure, nameOfSpread, nullptr, kMeasureCount))
    orders.emplace_back(order::ShowPlot{static_cast<int>(chosen.plot), measure});
  note(view, "plots.spread");
  tip(view,
      "Which measure of the current mesh's triangles is counted. Heights grow with the square root of the count.");
  if (view.ui.options.brush.on) {
    ImGui::SameLine();
    if (ImGui::Button("Unmark")) {
      ViewOptions options = view.ui.options;
      options.brush = {};
      orders.emplace_back(options);
    }
    note(view, "plots.unmark");
    tip(view, "Marks no triangles any more.");
  }
  const Histogram& h = view.debug.histogram;
  const PlotFrame f = plotFrameHere(view);
  plotGround(view, f);
  if (h.counts.empty()) {
    plotText(view, {0.5f * (f.lo.x + f.hi.x), 0.5f * (f.lo.y + f.hi.y)}, 0.5f, "no triangles yet",
             view.theme().textMuted);
    return;
  }
  plotTicks(view, f, countTicks(view, f, *std::max_element(h.counts.begin(), h.counts.end())));
  bars(view, orders, f, h);
  remark(view, f, h);
  valueAxis(view, f, h);
}

}  // namespace triscope
