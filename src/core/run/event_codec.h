// Events packed into bytes, one after the other: some 30 instead of 80 for an event of step 6, and nothing is lost.
//
// Four things make events small. Kind, stage, rule, refusal and which members say anything at all repeat: they are a
// pattern, named by its number. Ids are told as differences to those of the event before. A number that was told a
// moment ago, such as the worst aspect ratio around a vertex that is tried again, is told by its place in a table of
// recent ones; any other by the bytes in which it differs from what is expected. And where a vertex moved from is where
// an earlier event put it: only how many events ago that was is kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/words/event.h"

namespace triscope {

/// An event as it comes out again. Where `back` is not 0, Event::from is not filled in: it is where the event so many
/// events before this one put the vertex.
struct Unpacked {
  Event event;
  std::uint32_t back = 0;
};

/// Packs or unpacks one series of events in order. One object for one direction: both learn from what they have seen.
class EventCodec {
 public:
  /// Appends to the bytes. `back` as in Unpacked; 0 keeps `from` itself.
  void pack(const Event& event, std::uint32_t back, std::vector<std::uint8_t>& bytes);
  /// Reads what pack() has appended and moves on to the next event.
  Unpacked unpack(const std::uint8_t*& bytes);

 private:
  /// What events of one sort have in common: bits of `parts` say which members follow.
  struct Pattern {
    EventKind kind = EventKind::stage_begun;
    Stage stage = Stage::constraints;
    Rule rule = Rule::none;
    Refusal refusal = Refusal::none;
    std::uint16_t round = 0;
    std::uint16_t parts = 0;
    bool operator==(const Pattern&) const = default;
  };
  /// What one that has the pattern would say, if it went on as events do.
  struct Expected {
    std::uint32_t subject = 0;
    std::uint32_t other = 0;
    std::uint32_t vertex = 0;
    std::uint32_t created = 0;
    std::uint32_t back = 0;
    double limit = 0.0;
    Point at;
  };

  std::size_t numberOf(const Pattern& pattern);
  [[nodiscard]] std::uint16_t partsOf(const Event& event, std::uint32_t back) const;
  void learn(const Event& event, std::uint32_t back);

  std::vector<Pattern> patterns_;
  Expected expected_;
  std::array<std::uint64_t, 256> recent_{};  // bits of numbers told, each in the place that its hash gives
};

}  // namespace triscope
