#include "ui/kit/wrapped_text.h"

#include <imgui.h>

#include <algorithm>

namespace triscope {
namespace {

constexpr const char* kDots = "\xE2\x80\xA6";

float wide(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// Where the character ends that begins at `at`, in UTF-8.
std::size_t endOfCharacter(const std::string& text, std::size_t at) {
  ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u) ++at;
  return at;
}

/// How much of a word fits, at least one character.
std::size_t fittingPart(const std::string& word, float width) {
  std::size_t end = endOfCharacter(word, 0);
  while (end < word.size() && wide(word.substr(0, endOfCharacter(word, end))) <= width) end = endOfCharacter(word, end);
  return end;
}

/// A line with dots behind as many of its words as leave room for them.
std::string dotted(std::string line, float width) {
  while (wide(line + kDots) > width) {
    const std::size_t space = line.find_last_of(' ');
    if (space == std::string::npos) return line.substr(0, fittingPart(line, width - wide(kDots))) + kDots;
    line.resize(space);
  }
  while (!line.empty() && (line.back() == ',' || line.back() == '.' || line.back() == ';' || line.back() == ':'))
    line.pop_back();
  return line + kDots;
}

}  // namespace

std::string inLines(const std::string& text, float width) {
  std::string lines;
  std::size_t begun = 0;  // of the line, in `lines`
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    std::string word = text.substr(at, end - at);
    const bool fits = wide(lines.substr(begun) + word) <= width;
    if (!fits && lines.size() > begun) {
      lines.back() = '\n';  // the space before the word
      begun = lines.size();
    }
    while (wide(word) > width && endOfCharacter(word, 0) < word.size()) {
      const std::size_t part = fittingPart(word, width);
      lines += word.substr(0, part) + '\n';
      begun = lines.size();
      word.erase(0, part);
    }
    lines += word;
    if (end < text.size()) lines += text[end];
    if (end < text.size() && text[end] == '\n') begun = lines.size();
    at = end + 1;
  }
  return lines;
}

std::string inLines(const std::string& text, float width, int most) {
  std::string lines = inLines(text, width);
  std::size_t begun = 0;  // of the last line shown
  std::size_t end = lines.find('\n');
  for (int k = 1; k < most && end != std::string::npos; ++k) {
    begun = end + 1;
    end = lines.find('\n', begun);
  }
  if (end == std::string::npos) return lines;
  return lines.substr(0, begun) + dotted(lines.substr(begun, end - begun), width);
}

}  // namespace triscope
