#include "ui/panel/panels.h"

#include <array>

#include "core/base/stands_by_ids.h"

namespace triscope {
namespace {

constexpr auto kPanels = std::to_array<PanelInfo>({
    {Panel::stages, "Stages", Side::left, drawStages},
    {Panel::layers, "Layers", Side::left, drawLayers},
    {Panel::params, "Params", Side::left, drawParams},
    {Panel::inspect, "Inspect", Side::right, drawInspect},
    {Panel::why, "Why", Side::right, drawWhy},
    {Panel::history, "History", Side::right, drawHistory},
    {Panel::notes, "Notes", Side::right, drawNotes},
    {Panel::plots, "Plots", Side::bottom, drawPlots, Action::plots_panel},
    {Panel::breakpoints, "Breakpoints", Side::bottom, drawBreakpoints, Action::breakpoints_panel},
    {Panel::compare, "Compare", Side::bottom, drawCompare, Action::compare_panel},
    {Panel::sweep, "Sweep", Side::bottom, drawSweep, Action::sweep_panel},
});
static_assert(standsByIds(kPanels));

}  // namespace

std::span<const PanelInfo> panels() { return kPanels; }

}  // namespace triscope
