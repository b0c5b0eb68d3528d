// What happened to the selected element, and the way from one event about it to the next.
#include <fmt/format.h>

#include "core/base/number.h"
#include "ui/kit/linked_line.h"
#include "ui/kit/subject.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

void goTo(const View& view, Orders& orders, const char* label, const char* name,
          const std::optional<std::size_t>& event, const char* help, const char* reason) {
  ImGui::BeginDisabled(!event);
  if (ImGui::Button(label)) orders.emplace_back(command::SeekEvent{event.value_or(0)});
  ImGui::EndDisabled();
  note(view, name, event.has_value());
  tip(view, event ? fmt::format("{}: event {}.", help, grouped(*event)) : fmt::format("Not now: {}", reason));
}

}  // namespace

void drawHistory(const View& view, Orders& orders) {
  const Answers& answers = view.debug.answers;
  if (!drawSubject(view, "Click a triangle or a vertex to follow what happened to it.", "history.title")) return;
  goTo(view, orders, "Previous", "history.previous", answers.previous, "The last event about it before this one",
       "no earlier event is about it.");
  besideIfFits("Next");
  goTo(view, orders, "Next", "history.next", answers.next, "The next event about it",
       "no later event is about it, as far as the run is known.");
  besideIfFits("Birth");
  goTo(view, orders, "Birth", "history.birth", answers.birth, "The event that made it", "no decision made it.");
  heading(view, "Up to this decision");
  if (answers.history.empty()) muted(view, "Nothing has happened to it yet.");
  for (std::size_t k = 0; k < answers.history.size(); ++k) {
    ImGui::PushID(static_cast<int>(k));
    drawLine(view, orders, answers.history[k], "history");
    ImGui::Dummy({0.0f, view.px(3)});
    ImGui::PopID();
  }
}

}  // namespace triscope
