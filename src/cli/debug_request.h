// What --goto and --print of `triscope debug` ask for, read from their texts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/words/links.h"
#include "core/words/stage.h"

namespace triscope {

/// --goto start | end | tick=N | event=N | stage=S
struct Goto {
  enum class Kind : std::uint8_t { start, end, tick, event, stage } kind = Kind::start;
  std::uint64_t number = 0;
  Stage stage = Stage::constraints;
};
Result<Goto> gotoFrom(const std::string& text);

/// --print state | quality | worst | events:FROM-TO | why:ELEMENT | whynot:triangle=ID | history:ELEMENT | ELEMENT
struct Print {
  enum class What : std::uint8_t { state, quality, worst, events, why, whynot, history, figures } what = What::state;
  Ref ref;
  std::uint64_t from = 0;  // events, both included
  std::uint64_t to = 0;
  std::string text;  // as given
};
Result<Print> printFrom(const std::string& text);

}  // namespace triscope
