// The question of a run that would make more triangles than Settings::maxTriangles allows.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/number.h"
#include "core/method/estimate.h"
#include "core/method/triangle_limit.h"
#include "core/run/run.h"
#include "ui/dialog/dialogs.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

constexpr double kSpare = 1.1;  // a tree that grows further is estimated anew, and may come to a little more

const SettingInfo& limitInfo() { return *findSetting("max_triangles"); }

}  // namespace

void LimitDialog::prepare(const MeshState& stopped) {
  const Estimate estimate = estimateOf(stopped);
  const Asker asker = askerOf(stopped);
  question_ = fmt::format("This would make about {} triangles and take {} of memory, and its history up to {} more.",
                          roughCount(estimate.triangles), bytesText(estimate.bytes),
                          bytesText(historyBytesAtMost(estimate.triangles)));
  reason_ = fmt::format("The limit is {}. Most are asked for by {}, for edges of length {}.",
                        counted(static_cast<std::uint64_t>(stopped.settings.maxTriangles), "triangle", "triangles"),
                        asker.name, compact(asker.length));
  const std::optional<double> minEdge = minEdgeBelowLimit(stopped, asker);
  hint_ = adviceFor(asker, asker.source == Rule::user_request ? lengthBelowLimit(stopped, asker) : minEdge);
  minEdge_ = minEdge.value_or(2.0 * std::max(stopped.minEdge, asker.length));
  most_ = roundedUp(kSpare * estimate.triangles);
}

void LimitDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, "A large mesh", 560)) return;
  ImGui::PushFont(view.fonts.strong);
  wrapped(question_);
  ImGui::PopFont();
  note(view, "limit.question");
  wrapped(reason_);
  muted(view, "What to do: " + hint_ + ".");
  ImGui::Dummy({0, view.px(4)});

  Settings settings = view.session.settings();
  muted(view, "Smallest edge length");
  ImGui::SetNextItemWidth(-1.0f);
  const double least = 1e-12;
  const double most = 1e12;
  ImGui::DragScalar("##minEdge", ImGuiDataType_Double, &minEdge_, static_cast<float>(0.01 * minEdge_), &least, &most,
                    "%.4g", ImGuiSliderFlags_AlwaysClamp);
  note(view, "limit.min_edge");
  tip(view, "Suggested is one that the limit should hold for. Drag, or Ctrl+click to type.");

  const auto button = [&](const std::string& label, const char* name, const std::string& reason, const char* help) {
    ImGui::BeginDisabled(!reason.empty());
    const bool pressed = ImGui::Button(label.c_str());
    ImGui::EndDisabled();
    note(view, name, reason.empty());
    tip(view, reason.empty() ? help : reason);
    return pressed;
  };
  const auto with = [&](const Settings& changed) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(command::Change{changed});
  };
  const std::string coarser = fmt::format("Mesh with \xCE\x94x = {}", compact(minEdge_, 4));
  if (button(coarser, "limit.coarser", "", "Meshes with this smallest edge length instead; Ctrl+Z takes it back.")) {
    settings.minEdge = minEdge_;
    with(settings);
  }
  besideIfFits("Mesh anyway");
  const bool possible = most_ <= limitInfo().highest;
  if (button("Mesh anyway", "limit.anyway",
             possible ? "" : "So many triangles cannot be counted: at most " + roughCount(limitInfo().highest) + ".",
             "Raises the limit, max_triangles in Params, and goes on.")) {
    settings.maxTriangles = static_cast<int>(most_);
    with(settings);
  }
  besideIfFits("Stop here");
  if (button("Stop here", "limit.stop", "", "Leaves the run where it is, to be looked at. Keys: Esc"))
    orders.emplace_back(order::CloseDialog{});
  ImGui::EndPopup();
}

}  // namespace triscope
