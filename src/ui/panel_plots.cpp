// Measures along the run, and how they are spread over the triangles of the current mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/quality/quality.h"
#include "render/number.h"
#include "ui/measured_at.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

/// One series; `bound` is the paper's (section 3), NaN where there is none.
struct Series {
  const char* name;
  double bound;
  bool logarithmic;
  bool upper;  // the bound is not to be passed upwards
  double (*value)(const QualitySample&);
};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
template <Measure M>
double worst(const QualitySample& s) {
  return static_cast<double>(s.worst[static_cast<std::size_t>(M)]);
}
constexpr std::array<Series, kPlotOfCount> kSeries{{
    {"worst aspect ratio", Bounds::aspect, true, true, worst<Measure::aspect>},
    {"worst area ratio", Bounds::areaRatio, true, true, worst<Measure::area_ratio>},
    {"worst edge ratio", Bounds::edgeRatio, true, true, worst<Measure::edge_ratio>},
    {"smallest angle", Bounds::minAngle, false, false, worst<Measure::min_angle>},
    {"largest angle", Bounds::maxAngle, false, true, worst<Measure::max_angle>},
    {"triangles", kNone, false, true, [](const QualitySample& s) { return static_cast<double>(s.triangles); }},
    {"obtuse triangles", kNone, false, true, [](const QualitySample& s) { return static_cast<double>(s.obtuse); }},
}};

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

struct Frame {
  ImVec2 lo;
  ImVec2 hi;
  [[nodiscard]] float width() const { return hi.x - lo.x; }
  [[nodiscard]] float height() const { return hi.y - lo.y; }
};

/// The rest of the column, less room for the scale at the left and below.
Frame frameHere(const View& view) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float line = view.fonts.small->FontSize;
  return {
      {at.x + view.px(48), at.y + view.px(4)},
      {at.x + std::max(view.px(90), room.x - view.px(6)), at.y + std::max(view.px(30), room.y - line - view.px(4))}};
}

void text(const View& view, ImVec2 at, float align, const std::string& words, Color color) {
  const ImFont& font = *view.fonts.small;
  const float wide = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, words.c_str()).x;
  ImGui::GetWindowDrawList()->AddText(&font, font.FontSize, {at.x - align * wide, at.y}, toImU32(color), words.c_str());
}

void ground(const View& view, const Frame& f) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(f.lo, f.hi, toImU32(view.theme().background));
  list.AddRect(f.lo, f.hi, ImGui::GetColorU32(ImGuiCol_Border));
}

void dashedLine(const View& view, ImVec2 a, ImVec2 b, Color color) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const float dash = view.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int dashes = static_cast<int>(std::ceil(length / (2.0f * dash)));
  for (int k = 0; k < dashes; ++k) {
    const float s = 2.0f * dash * static_cast<float>(k);
    const float e = std::min(s + dash, length);
    list.AddLine({a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length},
                 {a.x + (b.x - a.x) * e / length, a.y + (b.y - a.y) * e / length}, toImU32(color), view.px(1.5));
  }
}

constexpr double kWideRange = 30.0;  // largest over smallest value, from which on an axis is logarithmic

/// Values to heights within a frame.
struct Height {
  const Frame& frame;
  double low;
  double high;
  bool logarithmic;
  [[nodiscard]] float operator()(double value) const {
    const double t =
        logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low) : (value - low) / (high - low);
    return frame.hi.y - static_cast<float>(std::clamp(t, 0.0, 1.0)) * frame.height();
  }
};

Height heightsOf(const Frame& frame, const Series& series, const std::vector<QualitySample>& samples, TickRange range) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const QualitySample& s : samples) {
    if (s.triangles == 0 || static_cast<double>(s.tick) < range.from || static_cast<double>(s.tick) > range.to)
      continue;
    const double value = series.value(s);
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!std::isnan(series.bound)) {
    low = std::min(low, series.bound);
    high = std::max(high, series.bound);
  }
  if (!(low <= high)) return {frame, 0.0, 1.0, false};
  const bool wide = low > 0.0 && high > kWideRange * low;
  if (!series.logarithmic && !wide)
    return {frame, std::min(low, 0.0), high + std::max(1e-9, 0.05 * (high - low)), false};
  return {frame, std::max(low, 1e-9) / 1.05, std::min(high, 1e6 * std::max(low, 1e-9)) * 1.1, true};
}

/// Of a logarithmic axis: the values to write beside it, powers of ten or, where these are few, 2 and 5 times too.
std::vector<double> ticksOf(const Height& y) {
  std::vector<double> ticks;
  const bool few = y.high < 100.0 * y.low;
  for (double power = std::pow(10.0, std::floor(std::log10(y.low))); power <= y.high; power *= 10.0)
    for (const double times : {1.0, 2.0, 5.0})
      if ((few || times == 1.0) && power * times >= y.low && power * times <= y.high) ticks.push_back(power * times);
  return ticks;
}

/// The scale at the left: the ends of a linear axis, the ticks of a logarithmic one with lines across.
void scale(const View& view, const Frame& f, const Height& y) {
  const float small = view.fonts.small->FontSize;
  const Color muted = view.theme().textMuted;
  const float x = f.lo.x - view.px(5);
  if (!y.logarithmic) {
    text(view, {x, f.lo.y}, 1.0f, compact(y.high), muted);
    text(view, {x, f.hi.y - small}, 1.0f, compact(y.low), muted);
    return;
  }
  float above = f.hi.y + small;  // what is written already
  for (const double tick : ticksOf(y)) {
    const float at = std::round(y(tick));
    ImGui::GetWindowDrawList()->AddLine({f.lo.x, at}, {f.hi.x, at}, ImGui::GetColorU32(ImGuiCol_Border));
    const float top = std::clamp(at - 0.5f * small, f.lo.y, f.hi.y - small);
    if (top + small > above) continue;
    text(view, {x, top}, 1.0f, tick < 1e4 ? compact(tick) : fmt::format("{:.0e}", tick), muted);
    above = top;
  }
}

void curve(const View& view, const Frame& f, const Series& series, const Height& y, TickRange range) {
  const std::vector<QualitySample>& samples = view.session.record().samples;
  std::vector<ImVec2> points;
  for (const QualitySample& s : samples) {
    const auto tick = static_cast<double>(s.tick);
    if (s.triangles == 0 || tick < range.from || tick > range.to) continue;
    const float x = f.lo.x + static_cast<float>((tick - range.from) / (range.to - range.from)) * f.width();
    const float height = y(series.value(s));
    // Of the samples on one pixel the extremes are enough.
    if (points.size() >= 2 && x - points[points.size() - 2].x < 0.5f) {
      points[points.size() - 2].y = std::min(points[points.size() - 2].y, height);
      points.back().y = std::max(points.back().y, height);
      continue;
    }
    points.push_back({x, height});
    points.push_back({x, height});
  }
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                          toImU32(accentOf(view.theme())), ImDrawFlags_None, view.px(1.5));
}

void alongRun(const View& view, Orders& orders) {
  DebugUi chosen = view.ui.debug;
  int plot = static_cast<int>(chosen.plot);
  ImGui::SetNextItemWidth(view.px(190));
  const auto nameOfSeries = [](void*, int k, const char** out) {
    *out = kSeries[static_cast<std::size_t>(k)].name;
    return true;
  };
  if (ImGui::Combo("##series", &plot, nameOfSeries, nullptr, kPlotOfCount))
    orders.emplace_back(order::ShowPlot{plot, static_cast<int>(chosen.histogram)});
  note(view, "plots.series");
  tip(view, "What is drawn against the decisions of the run.");
  const RunRecord& record = view.session.record();
  const Series& series = kSeries[static_cast<std::size_t>(chosen.plot)];
  if (view.now() != nullptr && view.now()->quality.triangles > 0) {
    const QualitySample here = sampleOf(view.now()->state.tick, view.now()->quality);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("here %s", compact(series.value(here), 4).c_str());
    note(view, "plots.here");
  }
  const Frame f = frameHere(view);
  const TickRange range = shownRange(chosen, record);
  const Height y = heightsOf(f, series, record.samples, range);
  ground(view, f);
  scale(view, f, y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(f.lo, f.hi, true);
  if (!std::isnan(series.bound))
    dashedLine(view, {f.lo.x, y(series.bound)}, {f.hi.x, y(series.bound)}, view.theme().worstAspect);
  curve(view, f, series, y, range);
  if (view.now() != nullptr) {
    const double t = (static_cast<double>(view.now()->state.tick) - range.from) / (range.to - range.from);
    const float x = f.lo.x + static_cast<float>(t) * f.width();
    list.AddLine({x, f.lo.y}, {x, f.hi.y}, toImU32(view.theme().text), view.px(1.5));
  }
  list.PopClipRect();
  const float small = view.fonts.small->FontSize;
  const Color muted = view.theme().textMuted;
  if (!std::isnan(series.bound)) {
    const bool above = y(series.bound) - small - view.px(2) > f.lo.y;
    text(view, {f.hi.x - view.px(5), y(series.bound) + (above ? -small - view.px(1) : view.px(1))}, 1.0f,
         fmt::format("bound {}", compact(series.bound)), view.theme().worstAspect);
  }
  text(view, {f.lo.x, f.hi.y + view.px(1)}, 0.0f, grouped(static_cast<std::uint64_t>(range.from)), muted);
  text(view, {f.hi.x, f.hi.y + view.px(1)}, 1.0f,
       fmt::format("decision {}", grouped(static_cast<std::uint64_t>(range.to))), muted);
  ImGui::SetCursorScreenPos(f.lo);
  ImGui::InvisibleButton("plot", {f.width(), f.height()});
  note(view, "plots.run");
  const double t = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - f.lo.x) / f.width()), 0.0, 1.0);
  const auto tick = static_cast<std::uint64_t>(std::round(range.from + t * (range.to - range.from)));
  if (ImGui::IsItemActive() && view.now() != nullptr && !view.session.stale() && !view.session.busy() &&
      tick != view.now()->state.tick)
    orders.emplace_back(command::Seek{tick});
  if (!ImGui::IsItemActive()) {
    const std::optional<QualitySample> sample = measuredAt(view, tick);
    std::string figures;
    if (sample && sample->triangles > 0)
      figures = fmt::format(": {} {}{}", series.name, compact(series.value(*sample), 4), sampledBefore(*sample, tick));
    tip(view, fmt::format("Decision {}{}\nClick to go there.", grouped(tick), figures));
  }
}

void brush(const View& view, Orders& orders, const Histogram& h, std::size_t bar) {
  ViewOptions options = view.ui.options;
  const double low = h.low + static_cast<double>(bar) * h.width();
  const bool last = bar + 1 == h.counts.size();
  const Brush wanted{true, kSpreads[static_cast<std::size_t>(h.measure)].fill, low,
                     last ? std::numeric_limits<double>::max() : low + h.width()};
  options.brush = options.brush == wanted ? Brush{} : wanted;
  orders.emplace_back(options);
}

void bars(const View& view, Orders& orders, const Frame& f, const Histogram& h) {
  const std::uint32_t most = *std::max_element(h.counts.begin(), h.counts.end());
  const float width = f.width() / static_cast<float>(h.counts.size());
  const Brush& brushed = view.ui.options.brush;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    if (h.counts[k] == 0) continue;
    // The square root keeps a single bad triangle in sight beside thousands of good ones.
    const auto part = static_cast<float>(std::sqrt(static_cast<double>(h.counts[k]) / static_cast<double>(most)));
    const float x = f.lo.x + static_cast<float>(k) * width;
    const double low = h.low + static_cast<double>(k) * h.width();
    const bool marked = brushed.on && brushed.measure == kSpreads[static_cast<std::size_t>(h.measure)].fill &&
                        std::fabs(brushed.low - low) < 1e-9 * (1.0 + std::fabs(low));
    const Color fill = marked ? view.theme().selection : mix(view.theme().background, accentOf(view.theme()), 0.7);
    list.AddRectFilled({x + 0.5f, f.hi.y - std::max(view.px(2), part * f.height())}, {x + width - 0.5f, f.hi.y},
                       toImU32(fill));
  }
  const double bound = kSpreads[static_cast<std::size_t>(h.measure)].bound;
  if (bound > h.low && bound < h.high) {
    const float x = f.lo.x + static_cast<float>((bound - h.low) / (h.high - h.low)) * f.width();
    dashedLine(view, {x, f.lo.y}, {x, f.hi.y}, view.theme().worstAspect);
  }
  ImGui::SetCursorScreenPos(f.lo);
  const bool pressed = ImGui::InvisibleButton("bars", {f.width(), f.height()});
  note(view, "plots.bars");
  if (!ImGui::IsItemHovered()) return;
  const float at = (ImGui::GetIO().MousePos.x - f.lo.x) / width;
  const auto bar = std::min(h.counts.size() - 1, static_cast<std::size_t>(std::max(0.0f, at)));
  if (pressed) brush(view, orders, h, bar);
  const double low = h.low + static_cast<double>(bar) * h.width();
  const bool last = bar + 1 == h.counts.size();
  tip(view, fmt::format("{} triangles from {}{}\nClick to mark them in the mesh, again to unmark.",
                        grouped(h.counts[bar]), compact(low, 4), last ? " up" : " to " + compact(low + h.width(), 4)));
}

void inMesh(const View& view, Orders& orders) {
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
  const Frame f = frameHere(view);
  ground(view, f);
  if (h.counts.empty()) {
    text(view, {0.5f * (f.lo.x + f.hi.x), 0.5f * (f.lo.y + f.hi.y)}, 0.5f, "no triangles yet", view.theme().textMuted);
    return;
  }
  bars(view, orders, f, h);
  const Color muted = view.theme().textMuted;
  text(view, {f.lo.x - view.px(5), f.lo.y}, 1.0f, grouped(*std::max_element(h.counts.begin(), h.counts.end())), muted);
  text(view, {f.lo.x - view.px(5), f.hi.y - view.fonts.small->FontSize}, 1.0f, "0", muted);
  text(view, {f.lo.x, f.hi.y + view.px(1)}, 0.0f, compact(h.low, 4), muted);
  text(view, {f.hi.x, f.hi.y + view.px(1)}, 1.0f, compact(h.high, 4), muted);
}

}  // namespace

void drawPlots(const View& view, Orders& orders) {
  const float gap = view.px(14);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float wide = std::floor(0.62f * (room.x - gap));
  if (ImGui::BeginChild("run", {wide, 0.0f}, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse))
    alongRun(view, orders);
  ImGui::EndChild();
  ImGui::SameLine(0.0f, gap);
  if (ImGui::BeginChild("mesh", {0.0f, 0.0f}, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse))
    inMesh(view, orders);
  ImGui::EndChild();
}

}  // namespace triscope
