// Why the selected element is there, and why nothing was done about it.
#include <fmt/format.h>

#include "ui/kit/linked_line.h"
#include "ui/kit/subject.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

void lines(const View& view, Orders& orders, const std::vector<Line>& all, const char* name) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    ImGui::PushID(static_cast<int>(k));
    drawLine(view, orders, all[k], name);
    ImGui::PopID();
  }
}

}  // namespace

void drawWhy(const View& view, Orders& orders) {
  const Answers& answers = view.debug.answers;
  if (!drawSubject(view, "Click a triangle or a vertex to learn which rule made it, and with which values.",
                   "why.title"))
    return;
  const bool there = answers.birth.has_value();
  ImGui::BeginDisabled(!there);
  if (ImGui::Button("Go to its birth")) orders.emplace_back(command::SeekEvent{answers.birth.value_or(0)});
  ImGui::EndDisabled();
  note(view, "why.birth", there);
  tip(view, there ? "Goes to right after the decision that made it."
                  : "Not now: no decision made it; it belongs to the input, or to the box around everything.");
  besideIfFits("Break on it");
  actionButton(view, orders, Action::breakpoint, "Break on it", "why.break");
  heading(view, "Why it is here");
  lines(view, orders, answers.why, "why");
  if (answers.why.empty()) muted(view, "No decision up to here made it.");
  if (answers.about->kind != Ref::Kind::triangle) return;
  heading(view, "Why nothing was done about it");
  lines(view, orders, answers.whyNot, "whynot");
  if (answers.whyNot.empty()) muted(view, "No rule has looked at it yet.");
}

}  // namespace triscope
