#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/study/compare.h"
#include "core/words/preset.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

bool isLength(const SettingInfo& info) { return info.unit == "length"; }

/// Range for a control: lengths are bound to the domain, since theirs is open.
struct ControlRange {
  double low;
  double high;
};

ControlRange spanOf(const SettingInfo& info, const MeshState* state) {
  if (!isLength(info) || state == nullptr) return {info.lowest, std::min(info.highest, 1e9)};
  const Box& box = state->domain->bounds;
  const double extent = std::max(box.width(), box.height());
  return {extent * 1e-5, extent * 0.25};
}

/// Under the heading of step 6 its name need not be said again.
std::string labelOf(const SettingInfo& info) {
  constexpr std::string_view kStep6 = "step 6: ";
  std::string_view label = info.label;
  if (label.substr(0, kStep6.size()) == kStep6) label.remove_prefix(kStep6.size());
  return std::string(label);
}

/// The control for a number; true when the value was changed.
bool number(const SettingInfo& info, double& value, ControlRange span) {
  if (info.member.kind == SettingKind::whole) {
    auto whole = static_cast<int>(value);
    const float pace = std::max(0.3f, 0.005f * static_cast<float>(whole));  // of a large number a part of itself
    const bool changed = ImGui::DragInt("##value", &whole, pace, static_cast<int>(span.low),
                                        static_cast<int>(span.high), "%d", ImGuiSliderFlags_AlwaysClamp);
    value = whole;
    return changed;
  }
  if (isLength(info)) {
    // A hundredth of itself for each pixel: the same feel at every size of domain.
    const auto pace = static_cast<float>(std::max(value, span.low) * 0.01);
    return ImGui::DragScalar("##value", ImGuiDataType_Double, &value, pace, &span.low, &span.high, "%.4g",
                             ImGuiSliderFlags_AlwaysClamp);
  }
  return ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &span.low, &span.high, "%.3g",
                             ImGuiSliderFlags_AlwaysClamp);
}

/// The list of the values that have names; true when another was chosen.
bool choice(const SettingInfo& info, double& value) {
  bool changed = false;
  if (!ImGui::BeginCombo("##value", settingText(info, value).c_str())) return changed;
  for (const NamedValue& named : info.names) {
    if (!ImGui::Selectable(std::string(named.name).c_str(), named.value == value)) continue;
    changed = named.value != value;
    value = named.value;
  }
  ImGui::EndCombo();
  return changed;
}

std::string helpOf(const SettingInfo& info, ControlRange span) {
  std::string text(info.help);
  const double standard = settingValue(Settings{}, info);
  if (isNamed(info)) {
    text += fmt::format("\nEither {}, default {}.\nKey in files and on the command line: {}.", rangeText(info),
                        settingText(info, standard), info.key);
    return text;
  }
  text += fmt::format("\nFrom {} to {}, default {}.", compact(span.low), compact(span.high), compact(standard));
  if (info.paperLow != info.paperHigh)
    text += fmt::format(" The paper takes {} to {}.", compact(info.paperLow), compact(info.paperHigh));
  text += fmt::format("\nKey in files and on the command line: {}. Ctrl+click to type a value.", info.key);
  return text;
}

void row(const View& view, Orders& orders, const SettingInfo& info) {
  const MeshState* const state = view.now() != nullptr ? &view.now()->state : nullptr;
  Settings settings = view.session.settings();
  const double before = settingValue(settings, info);
  const double standard = settingValue(Settings{}, info);
  const std::string name = "param." + std::string(info.key);
  ImGui::PushID(info.key.data());
  bool changed = false;
  bool held = false;  // by the control for numbers, which says when it is let go
  bool letGo = false;
  double value = before;
  const ControlRange span = spanOf(info, state);

  if (info.member.kind == SettingKind::on_off) {
    bool on = before != 0.0;
    changed = ImGui::Checkbox(labelOf(info).c_str(), &on);
    value = on ? 1.0 : 0.0;
    note(view, name);
    tip(view, helpOf(info, span));
  } else {
    const std::string label = info.symbol.empty() ? labelOf(info) : fmt::format("{}  {}", info.symbol, labelOf(info));
    muted(view, label);
    const bool automatic = before == 0.0 && (isLength(info) || info.inForce != nullptr);
    if (automatic && info.inForce != nullptr) value = info.inForce(settings);
    if (automatic && isLength(info) && state != nullptr) value = state->minEdge;
    const bool possible = state != nullptr || !isLength(info);
    ImGui::SetNextItemWidth(std::max(view.px(60), ImGui::GetContentRegionAvail().x - view.px(102)));
    ImGui::BeginDisabled(!possible);
    changed = isNamed(info) ? choice(info, value) : number(info, value, span);
    held = changed && !isNamed(info);
    letGo = !isNamed(info) && ImGui::IsItemDeactivated();
    ImGui::EndDisabled();
    note(view, name, possible);
    tip(view, possible ? helpOf(info, span) : "Not now: a length belongs to a domain, and there is none yet.");
    const std::string unit = automatic ? "auto" : std::string(info.unit);
    if (!unit.empty()) {
      ImGui::SameLine();
      ImGui::TextUnformatted(unit.c_str());
    }
  }
  if (before != standard) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - view.px(26));
    if (ImGui::SmallButton("\xE2\x86\xBA")) {
      changed = true;
      held = false;
      value = standard;
    }
    note(view, name + ".reset");
    tip(view, "Back to the default.");
  }
  if (outsidePaper(info, before)) {
    ImGui::PushStyleColor(ImGuiCol_Text, toImU32(view.theme().worstAspect));
    wrapped(fmt::format("outside the paper's range, {} to {}", compact(info.paperLow), compact(info.paperHigh)));
    ImGui::PopStyleColor();
  }
  if (changed && value != before && setSetting(settings, info, value)) {
    if (held)
      orders.emplace_back(order::Tune{settings});
    else
      orders.emplace_back(command::Change{settings});
  }
  if (letGo) orders.emplace_back(order::EndTuning{});
  ImGui::PopID();
}

void presetButtons(const View& view, Orders& orders) {
  const Preset* const inForce = presetOf(view.session.settings());
  muted(view, "Preset");
  for (const Preset& preset : presets()) {
    if (&preset != presets().data()) ImGui::SameLine();
    const bool on = &preset == inForce;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(std::string(preset.label).c_str()) && !on) {
      Settings settings = view.session.settings();
      applyPreset(settings, preset);
      orders.emplace_back(command::Change{settings});
    }
    if (on) ImGui::PopStyleColor();
    note(view, "preset." + std::string(preset.key));
    tip(view, fmt::format("{}\nKey on the command line: --preset {}.", preset.help, preset.key));
  }
}

/// A part of the panel: the settings whose first stage is one of it.
struct Section {
  const char* heading;
  bool (*has)(Stage);
};
// First what runs again in an instant, and is tuned most.
constexpr std::array kSections{
    Section{"Step 6: local refinements", refinesMesh},
    Section{"Density and insertion", [](Stage stage) { return !isPastRounds(stage); }},
    Section{"Optimise", optimisesMesh},
};

/// The run as it could be repeated without a window.
std::string commandLine(const View& view) {
  const Domain& domain = *view.now()->state.domain;
  std::string text =
      fmt::format("triscope mesh '{}' -o mesh.msh", domain.file.empty() ? domain.name + ".json" : domain.file);
  for (const SettingDifference& d : differences(Settings{}, view.session.settings()))
    text += fmt::format(" --set {}={}", d.setting->key, valueText(*d.setting, d.b));
  return text;
}

}  // namespace

void drawParams(const View& view, Orders& orders) {
  if (view.now() != nullptr) {
    const MeshState& state = view.now()->state;
    muted(view, fmt::format("\xCE\x94x in force is {}, {}.", compact(state.minEdge, 4),
                            state.minEdgeDerived                  ? "derived from the geometry"
                            : view.session.settings().minEdge > 0 ? "as set here"
                                                                  : "as the domain says"));
  }
  presetButtons(view, orders);
  for (const Section& section : kSections) {
    heading(view, section.heading);
    for (const SettingInfo& info : settingTable())
      if (section.has(info.firstStage)) row(view, orders, info);
  }
  ImGui::Dummy({0, view.px(4)});
  const Settings standard;
  const bool same = view.session.settings() == standard;
  ImGui::BeginDisabled(same);
  if (ImGui::Button("Reset all")) orders.emplace_back(command::Change{standard});
  ImGui::EndDisabled();
  note(view, "param.reset all", !same);
  tip(view, same ? "Every parameter has its default already." : "Every parameter back to its default.");
  ImGui::SameLine();
  const bool ready = view.now() != nullptr;
  ImGui::BeginDisabled(!ready);
  if (ImGui::Button("Copy as command")) ImGui::SetClipboardText(commandLine(view).c_str());
  ImGui::EndDisabled();
  note(view, "param.copy", ready);
  tip(view, ready ? commandLine(view) : "No domain is open.");
}

}  // namespace triscope
