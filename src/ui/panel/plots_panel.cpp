// Measures along the run, and how they are spread over the triangles of the current mesh.
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
#include "ui/model/measured_at.h"
#include "ui/panel/mesh_histogram.h"
#include "ui/panel/panels.h"

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

constexpr double kWideRange = 30.0;  // largest over smallest value, from which on an axis is logarithmic

/// Values to heights within a frame.
struct Height {
  const PlotFrame& frame;
  double low;
  double high;
  bool logarithmic;
  [[nodiscard]] float operator()(double value) const {
    const double t =
        logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low) : (value - low) / (high - low);
    return frame.hi.y - static_cast<float>(std::clamp(t, 0.0, 1.0)) * frame.height();
  }
};

Height heightsOf(const PlotFrame& frame, const Series& series, const std::vector<QualitySample>& samples,
                 TickRange range) {
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
void scale(const View& view, const PlotFrame& f, const Height& y) {
  std::vector<PlotTick> ticks;
  if (y.logarithmic)
    for (const double tick : ticksOf(y))
      ticks.push_back({y(tick), tick < 1e4 ? compact(tick) : fmt::format("{:.0e}", tick)});
  else
    ticks = {{f.hi.y, compact(y.low)}, {f.lo.y, compact(y.high)}};
  plotTicks(view, f, ticks);
}

void curve(const View& view, const PlotFrame& f, const Series& series, const Height& y, TickRange range) {
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
  const PlotFrame f = plotFrameHere(view);
  const TickRange range = shownRange(chosen, record);
  const Height y = heightsOf(f, series, record.samples, range);
  plotGround(view, f);
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
    plotText(view, {f.hi.x - view.px(5), y(series.bound) + (above ? -small - view.px(1) : view.px(1))}, 1.0f,
             fmt::format("bound {}", compact(series.bound)), view.theme().worstAspect);
  }
  plotText(view, {f.lo.x, f.hi.y + view.px(1)}, 0.0f, grouped(static_cast<std::uint64_t>(range.from)), muted);
  plotText(view, {f.hi.x, f.hi.y + view.px(1)}, 1.0f,
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
    tipAbove(view, fmt::format("Decision {}{}\nClick to go there.", grouped(tick), figures));
  }
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
    drawMeshHistogram(view, orders);
  ImGui::EndChild();
}

}  // namespace triscope
