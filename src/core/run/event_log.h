// Every event of a run, kept packed: a debugger holds millions of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/run/event_codec.h"
#include "core/words/event.h"

namespace triscope {

/// Ids that some events mention, as the range that they lie in; none at all when `low` is above `high`.
struct IdRange {
  std::uint32_t low = kNoId;
  std::uint32_t high = 0;
  void add(std::uint32_t id, std::uint32_t count = 1);
  [[nodiscard]] bool has(std::uint32_t id) const { return low <= id && id <= high; }
};

/// What the events of a block mention: enough to pass most blocks by when looking for those of one element.
struct Mentioned {
  IdRange subject;
  IdRange other;
  IdRange vertex;
  IdRange created;
  std::uint32_t kinds = 0;  // bit k: one of EventKind k
  [[nodiscard]] bool has(EventKind kind) const { return (kinds >> static_cast<unsigned>(kind) & 1u) != 0; }
};

/// Events by number, oldest first, in packed blocks. Reading unpacks the block that the event is in and keeps a few
/// blocks unpacked; so two threads may not read one log at the same time, and reading in order is cheap (some 20 ns an
/// event), here and there less so (some 5 µs).
class EventLog {
 public:
  EventLog() = default;
  explicit EventLog(std::span<const Event> events) { append(events); }

  [[nodiscard]] std::size_t size() const { return packedSize() + tail_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }

  /// What vertices move from, or stay at, must be where the last event that placed them says, when there is one here:
  /// so it is in every run, and it is not kept a second time.
  void append(std::span<const Event> events);
  /// Keeps the first `count`; no more than there are.
  void truncate(std::size_t count);

  /// A whole event. `index` below size(), as in the next.
  [[nodiscard]] Event operator[](std::size_t index) const;
  /// The event without Event::from, which may take another block to find out: for looking through many. Valid until
  /// the log is next read or changed.
  [[nodiscard]] const Event& peek(std::size_t index) const { return unpacked(index).event; }

  /// The first event at or after `index` in a block for which `may(const Mentioned&)` holds, or in the last one, which
  /// is not packed yet; size() when there is none. Begun in the middle of a block, that one is not asked about.
  template <class May>
  [[nodiscard]] std::size_t next(std::size_t index, const May& may) const {
    while (index % kBlock == 0 && index < packedSize() && !may(mentioned_[index / kBlock])) index += kBlock;
    return index;
  }

  /// The first event that differs in these two, or the size of the shorter one when it is the beginning of the longer.
  /// Compares packed blocks, so that what is alike costs next to nothing.
  friend std::size_t commonLength(const EventLog& a, const EventLog& b);

  /// Bytes that the events take, with what is needed to pack more, and without the blocks kept unpacked.
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::size_t kBlock = 256;  // events
  static constexpr std::size_t kOpenBlocks = 16;
  static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

  struct OpenBlock {
    std::size_t block = ~std::size_t{0};
    std::uint64_t lastUse = 0;
    std::vector<Unpacked> events;
  };

  [[nodiscard]] const Unpacked& unpacked(std::size_t index) const;
  [[nodiscard]] const OpenBlock& open(std::size_t block) const;
  [[nodiscard]] std::size_t packedSize() const { return blocks_.size() * kBlock; }
  void add(const Event& event);
  void packTail();

  std::vector<std::vector<std::uint8_t>> blocks_;  // full ones
  std::vector<Mentioned> mentioned_;               // by block
  std::vector<Unpacked> tail_;                     // what is after them; `from` is filled in here
  std::vector<std::uint32_t> placed_;              // by vertex: the last event that put it somewhere
  mutable std::array<OpenBlock, kOpenBlocks> open_;
  mutable std::size_t latest_ = 0;  // of these
  mutable std::uint64_t uses_ = 0;
};

std::size_t commonLength(const EventLog& a, const EventLog& b);

/// True when two events say the same, bit by bit: what is not a number equals itself.
bool sameContent(const Event& a, const Event& b);

}  // namespace triscope
