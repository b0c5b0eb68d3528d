// The runs A and B in figures: what they were told, what came of it, and where they part.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/base/number.h"
#include "core/explain/caption.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/model/pinned_run.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

/// A table with its titles; the values' columns are as wide as a long value, the first takes the rest.
bool beginTable(const View& view, const char* id, std::initializer_list<const char*> titles) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {view.px(5), view.px(1)});
  const bool open = ImGui::BeginTable(id, static_cast<int>(titles.size()), kFlags);
  ImGui::PopStyleVar();
  if (!open) return false;
  const float wide = ImGui::CalcTextSize("\xE2\x9C\x93 88.88\xC2\xB0").x;
  for (const char* const title : titles) {
    const bool names = title == *titles.begin();
    ImGui::TableSetupColumn(title, names ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed,
                            names ? 1.0f : wide);
  }
  ImGui::PushFont(view.fonts.strong);
  ImGui::TableNextRow();
  for (const char* const title : titles) {
    ImGui::TableNextColumn();
    const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(title).x;
    if (title != *titles.begin()) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
    ImGui::TextUnformatted(title);
  }
  ImGui::PopFont();
  return true;
}

void nameCell(const std::string& text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

/// At the right; with a mark of its own beside the colour when it is the better one.
void valueCell(const View& view, const std::string& text, bool better = false) {
  ImGui::TableNextColumn();
  const std::string shown = better ? "\xE2\x9C\x93 " + text : text;
  const float spare = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(shown.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, spare));
  ImGui::TextColored(toImVec4(better ? view.theme().front1 : view.theme().text), "%s", shown.c_str());
}

void figures(const View& view, const Quality& a, const Quality& b) {
  if (a.triangles == 0 || b.triangles == 0) return muted(view, "The figures show once both runs have triangles.");
  if (!beginTable(view, "figures", {"meshes shown", "A", "B", "B \xE2\x88\x92 A"})) return;
  for (const FigurePair& pair : figurePairs(a, b)) {
    const bool whole = pair.a == std::floor(pair.a) && pair.b == std::floor(pair.b);
    const char* const unit = pair.unit == "deg" ? "\xC2\xB0" : "";
    const auto text = [&](double v) { return (whole ? grouped(static_cast<std::uint64_t>(v)) : compact(v, 4)) + unit; };
    nameCell(std::string(pair.name));
    valueCell(view, text(pair.a), pair.better == 'a');
    valueCell(view, text(pair.b), pair.better == 'b');
    const double more = std::fabs(pair.b - pair.a);
    valueCell(view, more == 0.0 ? "=" : (pair.b > pair.a ? "+" : "\xE2\x88\x92") + compact(more) + unit);
  }
  ImGui::EndTable();
  note(view, "compare.figures");
}

void settings(const View& view) {
  const std::vector<SettingDifference> list = differences(view.pinned->session().settings(), view.session.settings());
  if (list.empty()) {
    heading(view, "Same parameters");
    muted(view, "Change or drag one in Params: B follows, A stays.");
    return;
  }
  if (!beginTable(view, "settings", {"parameters", "A", "B"})) return;
  for (const SettingDifference& d : list) {
    nameCell(std::string(settingName(*d.setting)));
    for (const double value : {d.a, d.b}) valueCell(view, settingText(*d.setting, value));
  }
  ImGui::EndTable();
  note(view, "compare.settings");
}

void parting(const View& view, Orders& orders) {
  heading(view, "First event that differs");
  const std::optional<std::size_t>& first = view.pinned->firstDifference();
  const bool making = view.pinned->session().busy();
  const bool differ = !making && first;
  if (making) {
    muted(view, "Run A is being made.");
  } else if (!differ) {
    muted(view, "None: both runs tell the same.");
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("event %s", grouped(*first).c_str());
    besideIfFits(std::string(infoOf(Action::first_difference).label).c_str());
  }
  actionButton(view, orders, Action::first_difference, Icon::none);
  if (!differ) return;
  const auto tell = [first](const char* run, const EventLog& events) {
    const std::string what = *first < events.size() ? captionOf(events[*first]) : "The run is over.";
    wrapped(fmt::format("{}: {}", run, what));
  };
  tell("A", view.pinned->session().runEvents());
  tell("B", view.session.runEvents());
}

}  // namespace

void drawCompare(const View& view, Orders& orders) {
  if (view.pinned == nullptr) {
    muted(view, "Pin the present run as A; then change a parameter, and B, the run that goes on, is shown beside it.");
    actionButton(view, orders, Action::pin_run, Icon::none);
    return;
  }
  const Snapshot* const a = view.pinned->session().current().get();
  const bool narrow = ImGui::GetContentRegionAvail().x < view.px(800);  // then the parting goes below the parameters
  const float gap = view.px(14);
  const float room = ImGui::GetContentRegionAvail().x - (narrow ? 1.0f : 2.0f) * gap;
  const auto letGo = [&] { actionButton(view, orders, Action::pin_run, "Let A go", "compare.unpin"); };
  if (ImGui::BeginChild("settings", {std::floor((narrow ? 0.42f : 0.25f) * room), 0.0f})) {
    settings(view);
    letGo();
    if (narrow) parting(view, orders);
  }
  ImGui::EndChild();
  ImGui::SameLine(0.0f, gap);
  if (ImGui::BeginChild("figures", {narrow ? 0.0f : std::floor(0.42f * room), 0.0f}) && a != nullptr &&
      view.now() != nullptr)
    figures(view, a->quality, view.now()->quality);
  ImGui::EndChild();
  if (narrow) return;
  ImGui::SameLine(0.0f, gap);
  if (ImGui::BeginChild("parting", {0.0f, 0.0f})) parting(view, orders);
  ImGui::EndChild();
}

}  // namespace triscope
