#include "core/run/condition_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace triscope {
namespace {

constexpr int kDeepest = 32;

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string listedWords() {
  std::string list;
  for (const Word& word : conditionWords()) {
    if (!list.empty()) list += ", ";
    list += word.name;
  }
  return list + ", in(x0, y0, x1, y1)";
}

}  // namespace

bool compareNumbers(Compare compare, double left, double right) {
  switch (compare) {
    case Compare::less:
      return left < right;
    case Compare::less_equal:
      return left <= right;
    case Compare::greater:
      return left > right;
    case Compare::greater_equal:
      return left >= right;
    case Compare::equal:
      return left == right;
    case Compare::not_equal:
      return left != right;
  }
  return false;
}

ConditionParser::ConditionParser(std::string_view text) : text_(text) { condition_.text_ = std::string(text); }

Result<Condition> ConditionParser::parse() {
  any();
  skipSpaces();
  if (!failed() && at_ < text_.size()) fail("\"and\", \"or\" or the end");
  if (!failed()) return std::move(condition_);
  Error error;
  error.kind = ErrorKind::usage;
  error.message = fmt::format("in the condition, character {}:\n  {}\n  {}^\nexpected {}", failedAt_ + 1, text_,
                              std::string(failedAt_, ' '), expected_);
  error.hint = "docs/conditions.md lists the words, for example: aspect > 4 and stage == refine";
  return error;
}

void ConditionParser::fail(std::string expected) {
  if (failed()) return;
  failedAt_ = at_;
  expected_ = std::move(expected);
}

void ConditionParser::push(const Condition::Step& step) {
  condition_.steps_.push_back(step);
  const bool joins = step.code == Condition::Step::Code::all || step.code == Condition::Step::Code::any;
  if (step.code != Condition::Step::Code::negate) stack_ += joins ? -1 : 1;
  if (stack_ > kDeepest) fail("a simpler condition");
}

void ConditionParser::skipSpaces() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
}

bool ConditionParser::take(std::string_view token) {
  skipSpaces();
  if (text_.substr(at_, token.size()) != token) return false;
  const std::size_t end = at_ + token.size();
  if (letter(token.front()) && end < text_.size() && (letter(text_[end]) || digit(text_[end]))) return false;
  at_ = end;
  return true;
}

std::string_view ConditionParser::word() {
  skipSpaces();
  std::size_t end = at_;
  while (end < text_.size() && (letter(text_[end]) || (end > at_ && digit(text_[end])))) ++end;
  return text_.substr(at_, end - at_);
}

bool ConditionParser::number(double& value) {
  skipSpaces();
  const char* const first = text_.data() + at_;
  const auto [stop, problem] = std::from_chars(first, text_.data() + text_.size(), value);
  if (problem != std::errc{} || !std::isfinite(value)) return false;
  at_ += static_cast<std::size_t>(stop - first);
  return true;
}

bool ConditionParser::compare(Compare& result) {
  struct Sign {
    std::string_view text;
    Compare compare;
  };
  constexpr std::array<Sign, 7> signs = {{{"<=", Compare::less_equal},
                                          {">=", Compare::greater_equal},
                                          {"==", Compare::equal},
                                          {"!=", Compare::not_equal},
                                          {"<", Compare::less},
                                          {">", Compare::greater},
                                          {"=", Compare::equal}}};
  for (const Sign& sign : signs) {
    if (take(sign.text)) {
      result = sign.compare;
      return true;
    }
  }
  return false;
}

void ConditionParser::any() {
  all();
  while (!failed() && (take("or") || take("||"))) {
    all();
    push({.code = Condition::Step::Code::any});
  }
}

void ConditionParser::all() {
  one();
  while (!failed() && (take("and") || take("&&"))) {
    one();
    push({.code = Condition::Step::Code::all});
  }
}

void ConditionParser::one() {
  if (failed()) return;
  if (++depth_ > kDeepest) return fail("less nesting");
  if (take("not") || take("!")) {
    one();
    push({.code = Condition::Step::Code::negate});
  } else if (take("(")) {
    any();
    if (!failed() && !take(")")) fail("\")\"");
  } else if (take("in")) {
    inside();
  } else {
    test();
  }
  --depth_;
}

void ConditionParser::inside() {
  Condition::Step step{.code = Condition::Step::Code::inside};
  if (!take("(")) return fail("\"(\" and four coordinates x0, y0, x1, y1");
  for (std::size_t k = 0; k < 4; ++k) {
    if (k > 0 && !take(",")) return fail("\",\"");
    if (!number(step.box[k])) return fail("a coordinate");
  }
  if (!take(")")) return fail("\")\"");
  condition_.asksOfEvents_ = true;
  push(step);
}

void ConditionParser::test() {
  const std::string_view name = word();
  const std::vector<Word>& words = conditionWords();
  const auto found = std::find_if(words.begin(), words.end(), [&](const Word& w) { return w.name == name; });
  if (name.empty() || found == words.end()) return fail("one of: " + listedWords());
  at_ += name.size();
  Condition::Step step{.code = Condition::Step::Code::flag};
  step.word = static_cast<std::uint8_t>(found - words.begin());
  if (found->ofEvent) condition_.asksOfEvents_ = true;
  if (found->kind == Word::Kind::flag) return push(step);

  Compare sign{};
  if (!compare(sign)) return fail("<, <=, >, >=, == or !=");
  step.compare = static_cast<std::uint8_t>(sign);
  const bool equality = sign == Compare::equal || sign == Compare::not_equal;
  if (found->kind != Word::Kind::number && !equality) return fail("== or != after " + std::string(name));
  if (found->kind == Word::Kind::name) {
    step.code = Condition::Step::Code::name;
    const std::vector<std::string> names = namesOf(name);
    const std::string_view value = word();
    const auto which = std::find(names.begin(), names.end(), value);
    if (which == names.end()) return fail("one of: " + listed(names));
    at_ += value.size();
    step.value = static_cast<double>(which - names.begin());
    return push(step);
  }
  step.code = found->kind == Word::Kind::id ? Condition::Step::Code::id : Condition::Step::Code::test;
  const std::size_t before = at_;
  if (!number(step.value)) return fail("a number");
  if (found->kind == Word::Kind::id && (step.value < 0.0 || step.value != std::floor(step.value) || step.value > 4e9)) {
    at_ = before;
    return fail("a whole number");
  }
  push(step);
}

}  // namespace triscope
