#include "ui/kit/linked_line.h"

#include <fmt/format.h>

#include <algorithm>

#include <string>

#include "ui/kit/widgets.h"

namespace triscope {
namespace {

/// Puts pieces beside each other, and on a new line where the next one does not fit.
struct Flow {
  float right;
  bool first = true;
  void place(float width, bool spaced) {
    if (first) {
      first = false;
      return;
    }
    ImGui::SameLine(0.0f, spaced ? ImGui::CalcTextSize(" ").x : 0.0f);
    if (ImGui::GetCursorPosX() + width > right) ImGui::NewLine();
  }
};

/// A sign right after a link stays with it.
float widthWithSign(const std::string& text, const Line& line, std::size_t k) {
  float width = ImGui::CalcTextSize(text.c_str()).x;
  if (k + 1 < line.size() && !line[k + 1].text.empty() && line[k + 1].text[0] != ' ')
    width += ImGui::CalcTextSize(line[k + 1].text.substr(0, 1).c_str()).x;
  return width;
}

}  // namespace

void drawLine(const View& view, Orders& orders, const Line& line, std::string_view name) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, view.px(1)});
  Flow flow{ImGui::GetContentRegionMax().x};
  bool spaced = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Span& span = line[k];
    if (span.link) {
      flow.place(widthWithSign(span.text, line, k), spaced);
      ImGui::PushID(static_cast<int>(k));
      if (link(view, span.text)) orders.emplace_back(order::FollowLink{*span.link});
      note(view, fmt::format("{}.{}", name, nameOf(*span.link)));
      ImGui::PopID();
      spaced = false;
      continue;
    }
    std::size_t from = 0;
    while (from < span.text.size()) {
      if (span.text[from] == ' ') {
        spaced = true;
        ++from;
        continue;
      }
      const std::size_t to = std::min(span.text.find(' ', from), span.text.size());
      const std::string word = span.text.substr(from, to - from);
      flow.place(ImGui::CalcTextSize(word.c_str()).x, spaced);
      ImGui::TextUnformatted(word.c_str());
      spaced = false;
      from = to;
    }
  }
  ImGui::PopStyleVar();
  ImGui::Dummy({0.0f, view.px(1)});
}

}  // namespace triscope
