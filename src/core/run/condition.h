// The language of breakpoints: "aspect > 4 and stage == refine". docs/conditions.md lists its words.
//
//   condition = all { "or" all }          all = one { "and" one }          one = [ "not" ] ( "(" condition ")" | test )
//   test      = flag | number-word ( < <= > >= == != ) number | word ( == != ) name | in(x0, y0, x1, y1)
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/method/state.h"
#include "core/quality/running_quality.h"
#include "core/words/event.h"

namespace triscope {

/// What a condition is asked about: one event, and the state right after the decision that made it.
struct Moment {
  const MeshState& state;
  const Event& event;
  const RunningQuality& quality;
  std::uint64_t sinceInsertion = 0;  // decisions since the last one that inserted a point
  std::uint8_t broken = 0;           // bits of Validity (validity.h)
};

struct Word {
  enum class Kind : std::uint8_t { number, flag, name, id };
  std::string_view name;
  Kind kind;
  bool ofEvent;  // asks about the event, not about the mesh
  std::string_view help;
};
/// Every word of the language, for the docs, for completion and for messages.
const std::vector<Word>& conditionWords();

class Condition {
 public:
  /// Compiles a text. An error's message quotes the text with a caret under the character it is about, and says what
  /// was expected.
  static Result<Condition> compile(std::string_view text);

  [[nodiscard]] bool holds(const Moment& moment) const;
  [[nodiscard]] const std::string& text() const { return text_; }
  /// True when it asks about events. One that asks about the mesh alone is met when it becomes true, not while it is.
  [[nodiscard]] bool asksOfEvents() const { return asksOfEvents_; }

 private:
  friend class ConditionParser;
  struct Step {
    enum class Code : std::uint8_t { test, flag, name, id, inside, all, any, negate } code;
    std::uint8_t word = 0;  // index into conditionWords()
    std::uint8_t compare = 0;
    double value = 0.0;  // number, or index of a name or id
    double box[4] = {0.0, 0.0, 0.0, 0.0};
  };
  std::string text_;
  std::vector<Step> steps_;  // reverse Polish
  bool asksOfEvents_ = false;
};

}  // namespace triscope
