#include "core/words/links.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace triscope {
namespace {

constexpr std::array<std::string_view, 4> kNames{"triangle", "vertex", "cell", "event"};  // in the order of Ref::Kind

struct Noun {
  std::string_view word;
  Ref::Kind kind;
  bool plural;
};
constexpr std::array kNouns{
    Noun{"triangles", Ref::Kind::triangle, true}, Noun{"triangle", Ref::Kind::triangle, false},
    Noun{"vertices", Ref::Kind::vertex, true},    Noun{"vertex", Ref::Kind::vertex, false},
    Noun{"cells", Ref::Kind::cell, true},         Noun{"cell", Ref::Kind::cell, false},
    Noun{"events", Ref::Kind::event, true},       Noun{"event", Ref::Kind::event, false},
};
constexpr std::array<std::string_view, 3> kBetween{", ", " and ", " to "};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isLetter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// True when the text has the word at `at`, its first letter in either case.
bool hasWord(std::string_view text, std::size_t at, std::string_view word) {
  if (at > 0 && isLetter(text[at - 1])) return false;
  return text.size() - at > word.size() && lower(text[at]) == word[0] &&
         text.substr(at + 1, word.size() - 1) == word.substr(1) && text[at + word.size()] == ' ';
}

/// The number at `at`, and where it ends. Nothing for "1.5" and for what is too large to be an id.
std::optional<std::uint32_t> numberAt(std::string_view text, std::size_t at, std::size_t& end) {
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data() + at, last, value);
  if (failure != std::errc{}) return std::nullopt;
  if (last - stop >= 2 && *stop == '.' && stop[1] >= '0' && stop[1] <= '9') return std::nullopt;
  end = static_cast<std::size_t>(stop - text.data());
  return value;
}

class Cutter {
 public:
  explicit Cutter(std::string_view text) : text_(text) {}

  Line cut() {
    for (std::size_t at = 0; at < text_.size();) at = step(at);
    flush(text_.size());
    return std::move(line_);
  }

 private:
  // Looks for an element named at `at`; returns where to look next.
  std::size_t step(std::size_t at) {
    for (const Noun& noun : kNouns) {
      if (!hasWord(text_, at, noun.word)) continue;
      const std::size_t number = at + noun.word.size() + 1;
      std::size_t end = number;
      const auto id = numberAt(text_, number, end);
      if (!id) break;
      add(noun.plural ? number : at, end, {noun.kind, *id});
      return noun.plural ? others(noun.kind, end) : end;
    }
    return at + 1;
  }

  // "…, 5 and 6" after the first of several.
  std::size_t others(Ref::Kind kind, std::size_t at) {
    for (bool more = true; more;) {
      more = false;
      for (const std::string_view between : kBetween) {
        if (!text_.substr(at).starts_with(between)) continue;
        const std::size_t number = at + between.size();
        std::size_t end = number;
        const auto id = numberAt(text_, number, end);
        if (!id) continue;
        add(number, end, {kind, *id});
        at = end;
        more = true;
        break;
      }
    }
    return at;
  }

  void add(std::size_t begin, std::size_t end, Ref link) {
    flush(begin);
    line_.push_back({std::string(text_.substr(begin, end - begin)), link});
    done_ = end;
  }

  void flush(std::size_t end) {
    if (end > done_) line_.push_back({std::string(text_.substr(done_, end - done_)), std::nullopt});
    done_ = end;
  }

  std::string_view text_;
  std::size_t done_ = 0;
  Line line_;
};

}  // namespace

std::string_view nameOf(Ref::Kind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::string nameOf(Ref ref) { return fmt::format("{} {}", nameOf(ref.kind), ref.id); }

std::optional<Ref> refFrom(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    if (text.substr(0, equals) != kNames[k]) continue;
    std::size_t end = equals + 1;
    const auto id = numberAt(text, equals + 1, end);
    if (!id || end != text.size()) return std::nullopt;
    return Ref{static_cast<Ref::Kind>(k), *id};
  }
  return std::nullopt;
}

Line linked(std::string_view text) { return Cutter(text).cut(); }

std::string textOf(const Line& line) {
  std::string text;
  for (const Span& span : line) text += span.text;
  return text;
}

}  // namespace triscope
