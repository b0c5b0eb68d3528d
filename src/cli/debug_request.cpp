#include "cli/debug_request.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/method/pipeline.h"

namespace triscope {
namespace {

std::optional<std::uint64_t> wholeNumber(std::string_view text) {
  std::uint64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), last, value);
  if (failure != std::errc{} || stop != last) return std::nullopt;
  return value;
}

Error wrong(std::string message, std::string hint) {
  return Error{.kind = ErrorKind::usage, .message = std::move(message), .hint = std::move(hint)};
}

Result<Stage> stageByKey(std::string_view key) {
  std::string keys;
  for (const StageInfo& info : stages()) {
    if (info.id == Stage::finished) continue;
    if (info.key == key) return info.id;
    keys += fmt::format("{}{}", keys.empty() ? "" : ", ", info.key);
  }
  return wrong(fmt::format("there is no stage '{}'", key), fmt::format("the stages are {}", keys));
}

struct Question {
  std::string_view word;
  Print::What what;
};
constexpr std::array kQuestions{Question{"why", Print::What::why}, Question{"whynot", Print::What::whynot},
                                Question{"history", Print::What::history}};

Error unknownPrint(const std::string& text) {
  return wrong(
      fmt::format("--print does not know '{}'", text),
      "give state, quality, worst, events:FROM-TO, why:ELEMENT, whynot:triangle=ID, history:ELEMENT, or ELEMENT, "
      "which is triangle=ID, vertex=ID, cell=ID or event=N");
}

}  // namespace

Result<Goto> gotoFrom(const std::string& text) {
  const std::string_view all = text;
  if (all == "start") return Goto{Goto::Kind::start, 0, {}};
  if (all == "end") return Goto{Goto::Kind::end, 0, {}};
  if (all.starts_with("stage=")) {
    const Result<Stage> stage = stageByKey(all.substr(6));
    if (!stage.ok()) return stage.error();
    return Goto{Goto::Kind::stage, 0, *stage};
  }
  for (const auto& [word, kind] : {std::pair{std::string_view("tick="), Goto::Kind::tick},
                                   std::pair{std::string_view("event="), Goto::Kind::event}}) {
    if (!all.starts_with(word)) continue;
    if (const auto number = wholeNumber(all.substr(word.size()))) return Goto{kind, *number, {}};
  }
  return wrong(fmt::format("--goto does not know '{}'", text), "give start, end, tick=N, event=N or stage=S");
}

Result<Print> printFrom(const std::string& text) {
  Print print;
  print.text = text;
  const std::string_view all = text;
  if (all == "state" || all == "quality" || all == "worst") {
    print.what = all == "state" ? Print::What::state : all == "quality" ? Print::What::quality : Print::What::worst;
    return print;
  }
  const std::size_t colon = all.find(':');
  if (colon == std::string_view::npos) {
    const std::optional<Ref> ref = refFrom(all);
    if (!ref) return unknownPrint(text);
    print.what = Print::What::figures;
    print.ref = *ref;
    return print;
  }
  const std::string_view word = all.substr(0, colon);
  const std::string_view rest = all.substr(colon + 1);
  if (word == "events") {
    const std::size_t dash = rest.find('-');
    const auto from = wholeNumber(rest.substr(0, dash));
    const auto to = dash == std::string_view::npos ? from : wholeNumber(rest.substr(dash + 1));
    if (!from || !to || *to < *from)
      return wrong(fmt::format("'{}' is no range of events", rest), "give events:FROM-TO");
    print.what = Print::What::events;
    print.from = *from;
    print.to = *to;
    return print;
  }
  for (const Question& question : kQuestions) {
    if (word != question.word) continue;
    const std::optional<Ref> ref = refFrom(rest);
    if (!ref || (question.what == Print::What::whynot && ref->kind != Ref::Kind::triangle)) return unknownPrint(text);
    print.what = question.what;
    print.ref = *ref;
    return print;
  }
  return unknownPrint(text);
}

}  // namespace triscope
