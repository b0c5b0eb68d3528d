// A sweep over ω and θ: its ranges, and the finished meshes' figures as a heat map that can be clicked to load a pair.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/study/compare.h"
#include "render/heat_map.h"
#include "render/legend_panel.h"
#include "ui/kit/imgui_canvas.h"
#include "ui/kit/imgui_pixels.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

constexpr double kControls = 310.0;  // widths in pixels at 100 %
constexpr double kNarrowControls = 270.0;
constexpr double kNarrow = 860.0;  // a panel where the legend goes below the controls
constexpr double kField = 62.0;
constexpr const char* kDegree = "\xC2\xB0";

/// With as many digits in every cell.
std::string valueText(SweepFigure figure, double value) {
  if (figure == SweepFigure::obtuse) return grouped(static_cast<std::uint64_t>(value));
  return infoOf(figure).unit == "deg" ? fmt::format("{:.2f}\xC2\xB0", value) : fmt::format("{:.3f}", value);
}

std::string pairText(double omega, double theta) {
  return fmt::format("\xCF\x89 = {}, \xCE\xB8 = {}\xC2\xB0", compact(omega, 4), compact(theta, 4));
}

/// Why what is shown is not what a sweep would give now; empty when it is.
std::string whyOutOfDate(const SweepTable& table, const Session& session) {
  if (holdsFor(table, session.domain(), session.settings())) return {};
  Settings made = table.settings;  // ω and θ apart
  made.omega = session.settings().omega;
  made.theta = session.settings().theta;
  const std::string changed = differencesText(differences(made, session.settings()), &SettingDifference::a, "was");
  return "Out of date: " +
         (changed.empty() ? "made on another domain, or with other density constraints." : changed + ".");
}

/// The fields of one range.
void range(const View& view, SweepChoice& choice, SweepRange SweepChoice::* member, const char* key) {
  const SettingInfo& info = *findSetting(key);
  const SweepRange before = choice.*member;
  SweepRange now = before;
  const char* const format = info.unit == "deg" ? "%.3g\xC2\xB0" : "%.3g";
  const auto pace = static_cast<float>((info.highest - info.lowest) / 400.0);
  const std::string help =
      fmt::format("From {} to {}; the paper takes {} to {}. Drag, or Ctrl+click to type.", compact(info.lowest),
                  compact(info.highest), compact(info.paperLow), compact(info.paperHigh));
  const auto end = [&](const char* name, double& value, const char* what) {
    ImGui::SetNextItemWidth(view.px(kField));
    ImGui::DragScalar(fmt::format("##{}", name).c_str(), ImGuiDataType_Double, &value, pace, &info.lowest,
                      &info.highest, format, ImGuiSliderFlags_AlwaysClamp);
    note(view, fmt::format("sweep.{}.{}", key, name));
    tip(view, fmt::format("{} of {}, {}.\n{}", what, info.symbol, info.label, help));
  };
  const auto word = [&view](const char* text) {
    ImGui::SameLine(0.0f, view.px(5));
    ImGui::TextUnformatted(text);
    ImGui::SameLine(0.0f, view.px(5));
  };
  ImGui::PushID(key);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(std::string(info.symbol).c_str());
  ImGui::SameLine(view.px(20));
  end("from", now.from, "The smallest value");
  word("to");
  end("to", now.to, "The largest value");
  word("in");
  ImGui::SetNextItemWidth(view.px(46));
  ImGui::DragInt("##count", &now.count, 0.1f, 1, kMostSweepValues, "%d", ImGuiSliderFlags_AlwaysClamp);
  note(view, fmt::format("sweep.{}.count", key));
  tip(view, fmt::format("How many values, both ends among them: 1 to {}.", kMostSweepValues));
  ImGui::PopID();
  if (now != before) choice.*member = kept(now, before, info);
}

void figureChoice(const View& view, SweepChoice& choice) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Show");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(view.px(180));
  const auto nameOf = [](SweepFigure figure) { return std::string(infoOf(figure).name); };
  const bool open = ImGui::BeginCombo("##figure", nameOf(choice.figure).c_str());
  if (open) {
    for (int k = 0; k < kSweepFigureCount; ++k) {
      const auto figure = static_cast<SweepFigure>(k);
      if (ImGui::Selectable(nameOf(figure).c_str(), figure == choice.figure)) choice.figure = figure;
      note(view, "sweep.figure." + nameOf(figure));
    }
    ImGui::EndCombo();
  }
  note(view, "sweep.figure");
  tip(view, "The figure of the finished meshes that the cells show; a cell's tooltip has all of them.");
}

void progress(const View& view, Orders& orders) {
  const SweepUi& sweep = view.ui.sweep;
  const std::size_t all = sweep.making->cells.size();
  const std::string text = sweep.preparing ? "steps 1 to 5" : fmt::format("{} of {}", sweep.done, all);
  const float button = ImGui::CalcTextSize("Cancel").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  ImGui::ProgressBar(static_cast<float>(sweep.done) / static_cast<float>(all),
                     {std::min(view.px(190), ImGui::GetContentRegionAvail().x - button - view.px(8)), 0.0f},
                     text.c_str());
  note(view, "sweep.progress");
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) orders.emplace_back(order::CancelSweep{});
  note(view, "sweep.cancel");
  tip(view, "Gives this sweep up and shows the one before.\nKeys: Esc");
}

void controls(const View& view, Orders& orders) {
  SweepChoice choice = view.ui.sweep.choice;
  range(view, choice, &SweepChoice::omega, "omega");
  range(view, choice, &SweepChoice::theta, "theta");
  if (view.ui.sweep.making) {
    progress(view, orders);
  } else {
    actionButton(view, orders, Action::run_sweep, Icon::none);
    ImGui::SameLine();
    actionButton(view, orders, Action::save_sweep, Icon::none);
  }
  figureChoice(view, choice);
  if (choice != view.ui.sweep.choice) orders.emplace_back(choice);
}

/// Whether all meshes made so far break a bound of the paper: then it is said once, and not marked in every cell.
bool allBreakBounds(const SweepTable& table) {
  const std::vector<SweepRow> rows = rowsOf(table);
  return std::none_of(rows.begin(), rows.end(), [](const SweepRow& row) { return row.quality.withinBounds(); });
}

/// What there is to say about the map.
void remarks(const View& view, const std::string& outOfDate) {
  if (!outOfDate.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, toImU32(view.theme().worstAspect));
    wrapped(outOfDate);
    ImGui::PopStyleColor();
    note(view, "sweep.stale");
    return;
  }
  const Settings& settings = view.session.settings();
  if (refines(settings) && !settings.laplacian) muted(view, "The Laplacian filter is off: \xCF\x89 changes nothing.");
  if (refines(settings) && !settings.reduceObtuse)
    muted(view, "The reduction of obtuse angles is off: \xCE\xB8 changes nothing.");
  const std::optional<SweepTable>& table = view.ui.sweep.shown();
  if (table && !view.ui.sweep.making && allBreakBounds(*table)) muted(view, "Every mesh breaks a bound of the paper.");
}

std::vector<std::string> labelsOf(const std::vector<double>& values, const char* unit) {
  std::vector<std::string> labels;
  labels.reserve(values.size());
  for (const double value : values) labels.push_back(compact(value) + unit);
  return labels;
}

HeatMap mapOf(const View& view, const SweepTable& table, bool outOfDate) {
  const SweepFigure figure = view.ui.sweep.choice.figure;
  HeatMap map;
  map.across = {"\xCF\x89", labelsOf(table.omegas, "")};
  map.up = {"\xCE\xB8", labelsOf(table.thetas, kDegree)};
  const SweepSpan span = spanOf(table, figure).value_or(SweepSpan{0.0, 0.0});
  map.low = span.low;
  map.high = span.high;
  map.faded = outOfDate;
  map.best = outOfDate || view.ui.sweep.making ? std::nullopt : bestOf(table, figure);
  map.cells.reserve(table.cells.size());
  const bool allBreak = allBreakBounds(table);
  for (const std::optional<SweepRow>& row : table.cells) {
    HeatCell& cell = map.cells.emplace_back();
    if (!row) continue;
    cell.value = infoOf(figure).value(row->quality);
    cell.text = valueText(figure, *cell.value);
    cell.crossed = !allBreak && !row->quality.withinBounds();
  }
  const Settings& settings = view.session.settings();
  const std::optional<double> x = placeAmong(table.omegas, settings.omega);
  const std::optional<double> y = placeAmong(table.thetas, settings.theta);
  if (x && y) map.here = glm::dvec2(*x, *y);
  map.chosen = view.ui.sweep.chosen;
  return map;
}

void legend(const View& view, const HeatMap& map) {
  const SweepFigure figure = view.ui.sweep.choice.figure;
  const SweepFigureInfo& info = infoOf(figure);
  const HeatLegend words{std::string(info.name),
                         valueText(figure, map.low),
                         valueText(figure, map.high),
                         info.largeIsBetter ? "best: the largest" : "best: the smallest",
                         "\xCF\x89 and \xCE\xB8 of the run shown",
                         "breaks a bound of the paper",
                         "chosen by the arrow keys"};
  const std::vector<LegendItem> items = legendOf(map, words, view.ui.options.scale, view.theme());
  const LegendSize size = legendSize(items, view.ui.scale());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({static_cast<float>(size.width), static_cast<float>(size.height)});
  note(view, "sweep.legend");
  tip(view,
      "Of cells that are equal, the best is the one with fewer obtuse triangles, then with the smaller aspect ratio.");
  ImGuiCanvas canvas(*ImGui::GetWindowDrawList(), view.fonts);
  drawLegend(items, {static_cast<double>(at.x), static_cast<double>(at.y)}, view.ui.scale(), view.theme(), canvas);
}

std::string tooltipOf(const SweepTable& table, std::size_t cell, bool outOfDate) {
  std::string text = pairText(table.omegas[cell / table.thetas.size()], table.thetas[cell % table.thetas.size()]);
  const std::optional<SweepRow>& row = table.cells[cell];
  if (outOfDate) {
    text += "\nRun the sweep again for its figures.";
  } else if (!row) {
    text += "\nNot run yet.";
  } else {
    const Quality& q = row->quality;
    const auto value = [&q](SweepFigure figure) { return valueText(figure, infoOf(figure).value(q)); };
    text += fmt::format("\nobtuse triangles: {} of {}\nworst aspect {}, area {}, edge {}\nangles: {} to {}",
                        value(SweepFigure::obtuse), grouped(q.triangles), value(SweepFigure::aspect),
                        value(SweepFigure::area_ratio), value(SweepFigure::edge_ratio), value(SweepFigure::min_angle),
                        value(SweepFigure::max_angle));
    text += fmt::format("\nmean aspect ratio: {:.3f}", q.aspectMean);
    text += fmt::format("\nmoves made: {}, refused: {}\n{}", grouped(row->moved), grouped(row->refused),
                        q.withinBounds() ? "within all bounds of the paper" : "breaks a bound of the paper");
  }
  return text + "\nClick to take this \xCF\x89 and \xCE\xB8.";
}

/// What the cell that the keys are on has, and what can be done.
void chosenCell(const View& view, const SweepTable& table, std::size_t cell, bool outOfDate) {
  const SweepFigure figure = view.ui.sweep.choice.figure;
  const std::optional<SweepRow>& row = table.cells[cell];
  std::string text = pairText(table.omegas[cell / table.thetas.size()], table.thetas[cell % table.thetas.size()]);
  if (row && !outOfDate)
    text += fmt::format(": {} {}", infoOf(figure).name, valueText(figure, infoOf(figure).value(row->quality)));
  muted(view, text + ". Enter takes it, Esc leaves the map.");
  note(view, "sweep.chosen");
}

/// The map with the mouse on it.
void heatMap(const View& view, Orders& orders, const SweepTable& table, HeatMap& map, bool outOfDate) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Rect whole{static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(room.x),
                   static_cast<double>(room.y)};
  const HeatGrid grid = heatGrid(map, whole, view.ui.scale());
  ImGui::SetCursorScreenPos({static_cast<float>(grid.cells.x), static_cast<float>(grid.cells.y)});
  const bool pressed =
      ImGui::InvisibleButton("map", {static_cast<float>(grid.cells.width), static_cast<float>(grid.cells.height)});
  note(view, "sweep.map");
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemHovered()) map.under = cellAt(grid, toPixels(mouse));
  ImGuiCanvas canvas(*ImGui::GetWindowDrawList(), view.fonts);
  drawHeatMap(map, grid, view.ui.options.scale, view.ui.scale(), view.theme(), canvas);
  if (outOfDate)
    canvas.text({grid.cells.x + 0.5 * grid.cells.width, grid.cells.y + 0.35 * grid.cells.height}, "out of date",
                {15.0 * view.ui.scale(), Weight::semibold, view.theme().text, view.theme().surface, Anchor::centre});
  if (!map.under) {
    if (map.chosen && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) orders.emplace_back(order::ChooseCell{});
    return;
  }
  tip(view, tooltipOf(table, *map.under, outOfDate));
  if (!pressed) return;
  orders.emplace_back(order::ChooseCell{map.under});
  orders.emplace_back(Action::take_cell);
}

}  // namespace

void drawSweep(const View& view, Orders& orders) {
  const std::optional<SweepTable>& table = view.ui.sweep.shown();
  const std::string outOfDate = table ? whyOutOfDate(*table, view.session) : std::string();
  HeatMap map = table ? mapOf(view, *table, !outOfDate.empty()) : HeatMap{};
  const bool some =
      std::any_of(map.cells.begin(), map.cells.end(), [](const HeatCell& c) { return c.value.has_value(); });
  const bool explains = some && outOfDate.empty();
  const bool narrow = ImGui::GetContentRegionAvail().x < view.px(kNarrow);
  const float gap = view.px(16);
  if (ImGui::BeginChild("controls", {view.px(narrow ? kNarrowControls : kControls), 0.0f})) {
    controls(view, orders);
    remarks(view, outOfDate);
    if (map.chosen) chosenCell(view, *table, *map.chosen, !outOfDate.empty());
    if (narrow && explains) legend(view, map);
  }
  ImGui::EndChild();
  ImGui::SameLine(0.0f, gap);
  const float beside = narrow ? 0.0f : view.px(210) + gap;
  constexpr ImGuiWindowFlags kStill = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  if (ImGui::BeginChild("heat map", {-beside, 0.0f}, false, kStill)) {
    if (table)
      heatMap(view, orders, *table, map, !outOfDate.empty());
    else
      muted(
          view,
          "Step 6 runs for every pair of \xCF\x89 and \xCE\xB8; what comes of each is shown here as a cell. Steps 1 to "
          "5 are those of the run at hand, which stays as it is. A click on a cell takes its pair.");
  }
  ImGui::EndChild();
  if (narrow) return;
  ImGui::SameLine(0.0f, gap);
  if (ImGui::BeginChild("legend", {0.0f, 0.0f}, false, kStill) && explains) legend(view, map);
  ImGui::EndChild();
}

}  // namespace triscope
