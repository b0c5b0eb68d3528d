// The whole run in one strip: stages as bands, the worst aspect ratio, marks, and where we are.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "core/quality/quality.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/model/measured_at.h"
#include "ui/panel/panels.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr double kLabelWidth = 122.0;  // pixels at 100 %
constexpr double kNarrowestStrip = 120.0;
constexpr double kBand = 15.0;
constexpr double kHighestAspect = 40.0;  // of the strip, on a logarithmic scale from 2

struct Strip {
  ImVec2 at;
  ImVec2 size;
  TickRange range;
  [[nodiscard]] float xOf(double tick) const {
    return at.x + static_cast<float>((tick - range.from) / (range.to - range.from)) * size.x;
  }
  [[nodiscard]] double tickAt(float x) const {
    const double t = static_cast<double>((x - at.x) / size.x);
    return range.from + std::clamp(t, 0.0, 1.0) * (range.to - range.from);
  }
};

void bands(const View& view, const Strip& strip, float height) {
  const RunRecord& record = view.session.record();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont& font = *view.fonts.small;
  for (std::size_t k = 0; k < record.stages.size(); ++k) {
    const StageEntry& entry = record.stages[k];
    const std::uint64_t end = k + 1 < record.stages.size() ? record.stages[k + 1].tick : record.ticks;
    const float x0 = std::max(strip.at.x, strip.xOf(static_cast<double>(entry.tick)));
    const float x1 = std::min(strip.at.x + strip.size.x, strip.xOf(static_cast<double>(end)));
    if (x1 - x0 < 0.25f) continue;
    const Color fill = stageColor(view.theme(), entry.stage);
    list.AddRectFilled({x0, strip.at.y}, {std::max(x1, x0 + 1.0f), strip.at.y + height}, toImU32(fill));
    const std::string name(infoOf(entry.stage).name);
    const float wide = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, name.c_str()).x;
    if (wide + view.px(8) > x1 - x0) continue;
    const Color ink = contrast(fill, rgb(0x000000)) > contrast(fill, rgb(0xFFFFFF)) ? rgb(0x000000) : rgb(0xFFFFFF);
    list.AddText(&font, font.FontSize, {x0 + view.px(4), strip.at.y + 0.5f * (height - font.FontSize)}, toImU32(ink),
                 name.c_str());
  }
}

float heightOf(double aspect, float height) {
  const double t = std::log(std::max(aspect, 2.0) / 2.0) / std::log(kHighestAspect / 2.0);
  return static_cast<float>(std::clamp(t, 0.0, 1.0)) * height;
}

/// One bar per pixel: the worst of what happened there.
void worstAspect(const View& view, const Strip& strip, float top, float height) {
  const std::vector<QualitySample>& samples = view.session.record().samples;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float foot = top + height;
  const ImU32 good = toImU32(mix(view.theme().surface, view.theme().text, 0.45));
  const ImU32 bad = toImU32(view.theme().worstAspect);
  const float bound = foot - heightOf(Bounds::aspect, height);
  auto sample =
      std::lower_bound(samples.begin(), samples.end(), strip.range.from,
                       [](const QualitySample& s, double tick) { return static_cast<double>(s.tick) < tick; });
  double held = sample == samples.begin() ? 0.0 : static_cast<double>((sample - 1)->worst[0]);
  const int columns = static_cast<int>(strip.size.x);
  for (int i = 0; i < columns && (sample != samples.end() || held > 0.0); ++i) {
    const float x = strip.at.x + static_cast<float>(i);
    const double end = strip.tickAt(x + 1.0f);
    double worst = 0.0;
    for (; sample != samples.end() && static_cast<double>(sample->tick) <= end; ++sample) {
      held = static_cast<double>(sample->worst[0]);
      worst = std::max(worst, held);
    }
    if (sample == samples.end() && (samples.empty() || end > static_cast<double>(samples.back().tick) + 1.0)) break;
    worst = std::max(worst, held);
    if (worst <= 0.0) continue;
    const float h = std::max(1.0f, heightOf(worst, height));
    if (worst >= Bounds::aspect) list.AddRectFilled({x, foot - h}, {x + 1.0f, std::min(foot, bound)}, bad);
    list.AddRectFilled({x, std::max(foot - h, bound)}, {x + 1.0f, foot}, good);
  }
  list.AddLine({strip.at.x, bound}, {strip.at.x + strip.size.x, bound},
               toImU32(mix(view.theme().surface, view.theme().text, 0.6)), std::max(1.0f, view.px(0.75)));
}

void sign(const View& view, ImVec2 foot, const char* glyph, Color color) {
  const ImFont& font = *view.fonts.text;
  const ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, glyph);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at{foot.x - 0.5f * size.x, foot.y - size.y};
  const ImU32 halo = toImU32(view.theme().surface);
  for (const ImVec2 d : {ImVec2{-1, 0}, ImVec2{1, 0}, ImVec2{0, -1}, ImVec2{0, 1}})
    list.AddText(&font, font.FontSize, {at.x + view.px(1) * d.x, at.y + view.px(1) * d.y}, halo, glyph);
  list.AddText(&font, font.FontSize, at, toImU32(color), glyph);
}

void marks(const View& view, const Strip& strip) {
  const float foot = strip.at.y + strip.size.y + view.px(2);
  float last = -1e9f;  // marks that would cover each other are one
  for (const PassedHit& hit : view.session.hits()) {
    const float x = strip.xOf(static_cast<double>(hit.tick));
    if (x < strip.at.x || x > strip.at.x + strip.size.x || x < last + view.px(3)) continue;
    last = x;
    const bool stops = hit.action == Breakpoint::Action::stop;
    sign(view, {x, foot}, stops ? "\xE2\x96\xB2" : "\xE2\x96\xB3", accentOf(view.theme()));
  }
  for (const Bookmark& mark : view.ui.debug.bookmarks) {
    const float x = strip.xOf(static_cast<double>(mark.tick));
    if (x >= strip.at.x && x <= strip.at.x + strip.size.x)
      sign(view, {x, foot}, "\xE2\x98\x85", view.theme().worstArea);
  }
}

void position(const View& view, const Strip& strip) {
  if (view.now() == nullptr) return;
  const float x = strip.xOf(static_cast<double>(view.now()->state.tick));
  if (x < strip.at.x - 1.0f || x > strip.at.x + strip.size.x + 1.0f) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = strip.at.y - view.px(2);
  const float foot = strip.at.y + strip.size.y;
  list.AddLine({x, top}, {x, foot}, toImU32(view.theme().surface), view.px(4));
  list.AddLine({x, top}, {x, foot}, toImU32(view.theme().text), view.px(2));
  list.AddTriangleFilled({x - view.px(5), top}, {x + view.px(5), top}, {x, top + view.px(7)},
                         toImU32(view.theme().text));
}

void hint(const View& view, const Strip& strip) {
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
  const auto tick = static_cast<std::uint64_t>(std::round(strip.tickAt(ImGui::GetIO().MousePos.x)));
  const RunRecord& record = view.session.record();
  std::string text = fmt::format("Decision {}", grouped(tick));
  if (const StageEntry* const entry = entryOfDecision(record, tick)) {
    text += fmt::format(", {}", infoOf(entry->stage).name);
    text += turnBehind(entry->stage, entry->round);
  }
  const std::optional<QualitySample> sample = measuredAt(view, tick);
  if (sample && sample->triangles > 0)
    text += fmt::format("\n{}, worst aspect ratio {:.3f}{}", counted(sample->triangles, "triangle", "triangles"),
                        static_cast<double>(sample->worst[0]), sampledBefore(*sample, tick));
  tip(view, text + "\nDrag to go there, wheel to zoom, double click for the whole run.");
}

/// The wheel zooms about the cursor; a double click shows everything.
void zoom(const View& view, Orders& orders, const Strip& strip) {
  if (!ImGui::IsItemHovered()) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) orders.emplace_back(order::ShowRange{});
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0.0f) return;
  const auto end = static_cast<double>(view.session.record().ticks);
  const double at = strip.tickAt(ImGui::GetIO().MousePos.x);
  const double factor = std::pow(0.8, static_cast<double>(wheel));
  const double width = std::max((strip.range.to - strip.range.from) * factor, 20.0);
  if (width >= end) {
    orders.emplace_back(order::ShowRange{});
    return;
  }
  const double part = (at - strip.range.from) / (strip.range.to - strip.range.from);
  const double from = std::clamp(at - part * width, 0.0, end - width);
  orders.emplace_back(order::ShowRange{from, from + width});
}

void scrub(const View& view, Orders& orders, const Strip& strip) {
  if (!ImGui::IsItemActive() || view.now() == nullptr || view.session.stale()) return;
  const auto tick = static_cast<std::uint64_t>(std::round(strip.tickAt(ImGui::GetIO().MousePos.x)));
  // One at a time: a place that takes long to come to is shown before the next one is asked for.
  if (tick != view.now()->state.tick && !view.session.busy()) orders.emplace_back(command::Seek{tick});
}

void label(const View& view) {
  const std::uint64_t ticks = view.session.record().ticks;
  const std::string count =
      view.now() == nullptr ? "–" : fmt::format("{} / {}", grouped(view.now()->state.tick), grouped(ticks));
  ImGui::TextUnformatted(count.c_str());
  note(view, "timeline.count");
  tip(view, view.session.record().complete ? "Decisions made up to here, and in the whole run."
                                           : "Decisions made up to here, and known of the run so far.");
}

constexpr double kBetweenToggles = 6.0;

float togglesWidth(const View& view) {
  float width = -view.px(kBetweenToggles);
  for (const PanelInfo& panel : panels())
    if (panel.opens)
      width += ImGui::CalcTextSize(panel.name).x + 2.0f * ImGui::GetStyle().FramePadding.x + view.px(kBetweenToggles);
  return width;
}

constexpr const char* kMenu = "Panels";

float menuWidth() { return ImGui::CalcTextSize(kMenu).x + 2.0f * ImGui::GetStyle().FramePadding.x; }

/// The same in a menu, where the window is narrow beside its letters.
void menu(const View& view, Orders& orders) {
  if (ImGui::Button(kMenu)) ImGui::OpenPopup("panels");
  note(view, "timeline.panels");
  tip(view, "Panels above the timeline: plots, breakpoints, two runs compared, a sweep.");
  if (!ImGui::BeginPopup("panels")) return;
  for (const PanelInfo& panel : panels())
    if (panel.opens) actionEntry(view, orders, *panel.opens, panel.name, fmt::format("tab.{}", panel.name));
  ImGui::EndPopup();
}

/// Buttons that open and close the panels above the strip.
void toggles(const View& view, Orders& orders) {
  bool first = true;
  for (const PanelInfo& panel : panels()) {
    if (!panel.opens) continue;
    if (!first) ImGui::SameLine(0.0f, view.px(kBetweenToggles));
    first = false;
    const bool open = view.ui.debug.bottom == panel.id;
    if (open) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_TabActive));
    actionButton(view, orders, *panel.opens, panel.name, fmt::format("tab.{}", panel.name));
    if (open) ImGui::PopStyleColor();
  }
}

}  // namespace

void drawTimeline(const View& view, Orders& orders) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = view.px(12);
  const std::string most = grouped(std::max<std::uint64_t>(view.session.record().ticks, 888'888));
  const float left = std::max(view.px(kLabelWidth), ImGui::CalcTextSize((most + " / " + most).c_str()).x) + gap;
  const bool narrow = room.x - left - togglesWidth(view) - gap < view.px(kNarrowestStrip);
  const float right = narrow ? menuWidth() : togglesWidth(view);
  const float width = std::max(view.px(60), room.x - left - right - gap);
  ImGui::SetCursorScreenPos({corner.x, corner.y + std::max(0.0f, 0.5f * (room.y - ImGui::GetTextLineHeight()))});
  label(view);

  const Strip strip{{corner.x + left, corner.y + view.px(2)},
                    {width, std::max(1.0f, room.y - view.px(4))},
                    shownRange(view.ui.debug, view.session.record())};
  const bool measures = strip.size.y - view.px(kBand) > view.px(8);
  const float band = measures ? view.px(kBand) : strip.size.y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(strip.at, {strip.at.x + strip.size.x, strip.at.y + strip.size.y},
                     toImU32(view.theme().background));
  list.PushClipRect(strip.at, {strip.at.x + strip.size.x, strip.at.y + strip.size.y}, true);
  bands(view, strip, band);
  if (measures) worstAspect(view, strip, strip.at.y + band + view.px(1), strip.size.y - band - view.px(1));
  list.PopClipRect();
  marks(view, strip);
  position(view, strip);
  ImGui::SetCursorScreenPos({strip.at.x, corner.y});
  ImGui::InvisibleButton("strip", {strip.size.x, room.y});
  note(view, "timeline");
  hint(view, strip);
  zoom(view, orders, strip);
  scrub(view, orders, strip);

  ImGui::SetCursorScreenPos(
      {corner.x + room.x - right, corner.y + std::max(0.0f, 0.5f * (room.y - ImGui::GetFrameHeight()))});
  narrow ? menu(view, orders) : toggles(view, orders);
}

}  // namespace triscope
