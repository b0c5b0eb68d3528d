// Recursive descent over the text of a condition. Used by condition.cpp alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/run/condition.h"

namespace triscope {

enum class Compare : std::uint8_t { less, less_equal, greater, greater_equal, equal, not_equal };
bool compareNumbers(Compare compare, double left, double right);

/// The names that a word of kind `name` may be compared with, in the order of its enumeration.
std::vector<std::string> namesOf(std::string_view word);

class ConditionParser {
 public:
  explicit ConditionParser(std::string_view text);
  Result<Condition> parse();

 private:
  void any();
  void all();
  void one();
  void test();
  void inside();
  void push(const Condition::Step& step);
  void skipSpaces();
  bool take(std::string_view token);
  std::string_view word();
  bool number(double& value);
  bool compare(Compare& result);
  void fail(std::string expected);
  [[nodiscard]] bool failed() const { return !expected_.empty(); }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t failedAt_ = 0;
  std::string expected_;
  int depth_ = 0;  // of nesting
  int stack_ = 0;  // values that evaluation holds at once
  Condition condition_;
};

}  // namespace triscope
