#include <array>

#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

template <class Enum, std::size_t N>
void choose(const View& view, const char* label, Enum& value,
            const std::array<std::pair<Enum, const char*>, N>& choices, const char* help) {
  const char* now = "";
  for (const auto& [choice, name] : choices)
    if (choice == value) now = name;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.55f);
  if (ImGui::BeginCombo(label, now)) {
    for (const auto& [choice, name] : choices) {
      if (ImGui::Selectable(name, choice == value)) value = choice;
      note(view, std::string(label) + "." + name);
    }
    ImGui::EndCombo();
  } else {
    note(view, label);
    tip(view, help);
  }
}

}  // namespace

void drawLayers(const View& view, Orders& orders) {
  ViewOptions options = view.ui.options;

  heading(view, "Domain");
  actionSwitch(view, orders, Action::boundary, "boundary");
  actionSwitch(view, orders, Action::boundary_points, "boundary points");

  heading(view, "Density");
  actionSwitch(view, orders, Action::constraints, "constraints");
  actionSwitch(view, orders, Action::quadtree, "quadtree");
  ImGui::Indent();
  choose(view, "cells by", options.cells,
         std::array{std::pair{CellColoring::rank, "density rank"}, std::pair{CellColoring::type, "type"},
                    std::pair{CellColoring::none, "outline only"}},
         "What the colour of a quadtree cell says.");
  ImGui::Checkbox("outside the domain too", &options.outsideCells);
  note(view, "outside cells");
  ImGui::Unindent();
  bool follow = view.ui.layersFollow;
  if (ImGui::Checkbox("shown while they are made", &follow)) orders.emplace_back(order::LayersFollow{follow});
  note(view, "layers follow");
  tip(view,
      "Constraints and quadtree are shown up to the end of the density stage, as in the figures, and hidden after it. "
      "Switching one by hand ends that.");

  heading(view, "Mesh");
  actionSwitch(view, orders, Action::triangulation, "triangulation");
  ImGui::Indent();
  std::array<std::pair<TriangleFill, const char*>, kTriangleFillCount> fills{};
  for (int i = 0; i < kTriangleFillCount; ++i) {
    const auto fill = static_cast<TriangleFill>(i);
    fills[static_cast<std::size_t>(i)] = {fill, name(fill).data()};
  }
  choose(view, "filled by", options.fill, fills, "What the colour of a triangle says.");
  ImGui::Checkbox("outside the domain too##mesh", &options.helpers);
  note(view, "helpers");
  tip(view, "Triangles between the boundary and the box around everything, before they are carved away.");
  ImGui::Unindent();
  actionSwitch(view, orders, Action::obtuse, "obtuse triangles");
  actionSwitch(view, orders, Action::fronts, "fronts \xE2\x97\x8F \xE2\x97\x86");
  actionSwitch(view, orders, Action::steiner, "inserted points \xE2\x96\xB2");
  actionSwitch(view, orders, Action::degrees, "few \xE2\x96\xB2 and many \xE2\x96\xA0 triangles");

  heading(view, "Over it");
  actionSwitch(view, orders, Action::worst, "three worst circles");
  actionSwitch(view, orders, Action::decision, "current decision");
  actionSwitch(view, orders, Action::labels, "labels");
  actionSwitch(view, orders, Action::legend, "legend");

  heading(view, "Colours");
  choose(view, "scale", options.scale,
         std::array{std::pair{Scale::cividis, "Cividis"}, std::pair{Scale::viridis, "Viridis"}},
         "Both read without telling red from green, and in grey.");
  Appearance look = view.ui.look;
  choose(view, "theme", look.theme,
         std::array{std::pair{ThemeKind::light, "Light"}, std::pair{ThemeKind::dark, "Dark"},
                    std::pair{ThemeKind::high_contrast, "High contrast"}},
         "Light suits projectors and print.");
  if (look != view.ui.look) orders.emplace_back(look);
  if (options != view.ui.options) orders.emplace_back(options);
}

}  // namespace triscope
