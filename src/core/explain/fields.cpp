#include "core/explain/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/capitalised.h"
#include "core/base/counted.h"
#include "core/method/estimate.h"
#include "core/method/pipeline.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// " off vertex 12" where an id is named, or else nothing.
std::string with(std::string_view before, std::uint32_t id) {
  return id == kNoId ? std::string() : fmt::format("{}{}", before, id);
}

std::string triangle(const Event& e) { return e.subject == kNoId ? "the boundary" : with("triangle ", e.subject); }

/// "its circumradius R = 2.31 is not below its shortest edge e = 1.98"
std::string reason(const Event& e) {
  const RuleWords& words = wordsOf(e.rule);
  return filled(words.reason.empty() ? words.description : words.reason, e);
}

/// What the decision did to the triangulation: " 4 triangles gave way to 6."
std::string effect(const Event& e) {
  if (e.createdCount == 0) return {};
  if (e.removedCount == 0) return fmt::format(" It made {}.", counted(e.createdCount, "triangle", "triangles"));
  return fmt::format(" {} gave way to {}.", capitalised(counted(e.removedCount, "triangle", "triangles")),
                     grouped(e.createdCount));
}

/// Why not, with the figures where it was a comparison.
std::string refusal(const Event& e) {
  const RefusalWords& words = wordsOf(e.refusal);
  return std::string(words.description) + filled(words.figures, e);
}

/// Worse in aspect ratio, or else in one of the measures that the event does not name.
std::string star(const Event& e) {
  return e.measured > e.limit ? fmt::format(" (aspect ratio {:.4g}, now {:.4g})", e.measured, e.limit)
                              : " (in obtuse angles, area ratio or edge ratio)";
}

/// Refinement measures the triangles around a vertex before and after.
std::string around(const Event& e) {
  if (!refinesMesh(e.stage) || !(e.limit > 0.0)) return {};
  return fmt::format(" The worst aspect ratio around it went from {:.4g} to {:.4g}.", e.limit, e.measured);
}

std::string outcome(const Event& e) {
  if (e.subject > 0) return " after " + counted(e.subject, "change", "changes");
  return e.stage >= Stage::step1 ? ": it had nothing to change" : "";
}

struct Field {
  std::string_view name;
  std::string (*text)(const Event&);
};

constexpr std::array kFields = std::to_array<Field>({
    {"stage", [](const Event& e) { return capitalised(infoOf(e.stage).name); }},
    {"does", [](const Event& e) { return std::string(infoOf(e.stage).does); }},
    {"in_round", [](const Event& e) { return turnBehind(e.stage, e.round); }},
    {"outcome", outcome},
    {"rule", [](const Event& e) { return capitalised(name(e.rule)); }},
    {"why", [](const Event& e) { return std::string(describe(e.rule)); }},
    {"reason", reason},
    {"subject", [](const Event& e) { return fmt::to_string(e.subject); }},
    {"other", [](const Event& e) { return fmt::to_string(e.other); }},
    {"vertex", [](const Event& e) { return fmt::to_string(e.vertex); }},
    {"triangle", triangle},
    {"neighbour", [](const Event& e) { return with(", triangle ", e.other); }},
    {"off", [](const Event& e) { return otherOf(e) == Names::vertex ? with(" off vertex ", e.other) : std::string(); }},
    {"beside",
     [](const Event& e) { return otherOf(e) == Names::cell ? with(" beside cell ", e.other) : std::string(); }},
    {"instead",
     [](const Event& e) {
       return e.limit > 0.0 && e.limit != e.measured ? " instead of " + shortNumber(e.limit) : std::string();
     }},
    {"place", [](const Event& e) { return shortPlace(e.at); }},
    {"by", [](const Event& e) { return shortNumber(distance(e.from, e.at)); }},
    {"measured", [](const Event& e) { return shortNumber(e.measured); }},
    {"limit", [](const Event& e) { return shortNumber(e.limit); }},
    {"rough", [](const Event& e) { return roughCount(e.measured); }},
    {"whole_limit", [](const Event& e) { return fmt::format("{:.0f}", e.limit); }},
    {"effect", effect},
    {"around", around},
    {"star", star},
    {"refusal", refusal},
    {"refused", [](const Event& e) { return std::string(describe(e.refusal)); }},
    {"because", [](const Event& e) { return e.refusal == Refusal::none ? std::string() : ": " + refusal(e); }},
});

const Field* fieldOf(std::string_view name) {
  const auto* const field = std::ranges::find(kFields, name, &Field::name);
  return field == kFields.end() ? nullptr : field;
}

}  // namespace

bool isField(std::string_view name) { return fieldOf(name) != nullptr; }

std::string filled(std::string_view text, const Event& event) {
  std::string out;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    out += text.substr(0, open);
    text.remove_prefix(open);
    const std::size_t close = text.find('}');
    if (close == std::string_view::npos) return out.append(text);
    const Field* const field = fieldOf(text.substr(1, close - 1));
    out += field != nullptr ? field->text(event) : std::string(text.substr(0, close + 1));
    text.remove_prefix(close + 1);
  }
  return out;
}

std::string shortNumber(double value) { return fmt::format("{:.4g}", value); }

std::string shortPlace(Point p) { return fmt::format("({:.4g}, {:.4g})", p.x, p.y); }
std::string placeText(Point p) { return fmt::format("({:.6g}, {:.6g})", p.x, p.y); }

}  // namespace triscope
