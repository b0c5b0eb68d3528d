#include "core/run/event_log.h"

#include <algorithm>
#include <bit>

#include "core/base/assert.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

constexpr std::size_t kBoxVertices = 4;  // corners of the box around everything: no event makes them

bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool sameBits(Point a, Point b) { return sameBits(a.x, b.x) && sameBits(a.y, b.y); }

bool tellsFrom(const Event& e) { return wordsOf(e.kind).from; }

}  // namespace

bool sameContent(const Event& a, const Event& b) {
  return a.kind == b.kind && a.stage == b.stage && a.rule == b.rule && a.refusal == b.refusal && a.round == b.round &&
         a.removedCount == b.removedCount && a.subject == b.subject && a.other == b.other && a.vertex == b.vertex &&
         a.created == b.created && a.createdCount == b.createdCount && sameBits(a.measured, b.measured) &&
         sameBits(a.limit, b.limit) && sameBits(a.at, b.at) && sameBits(a.from, b.from);
}

void IdRange::add(std::uint32_t id, std::uint32_t count) {
  if (id == kNoId || count == 0) return;
  low = std::min(low, id);
  high = std::max(high, static_cast<std::uint32_t>(std::min<std::uint64_t>(std::uint64_t{id} + count - 1, kNoId)));
}

void EventLog::append(std::span<const Event> events) {
  for (const Event& event : events) add(event);
}

void EventLog::add(const Event& event) {
  const std::size_t index = size();
  const std::uint32_t last = event.vertex < placed_.size() ? placed_[event.vertex] : kNowhere;
  const bool known = tellsFrom(event) && last != kNowhere;
  tail_.push_back({event, known ? static_cast<std::uint32_t>(index - last) : 0});
  // Some event made each vertex: a number beyond theirs is of none that was made here.
  if (placesVertex(event) && event.vertex <= index + kBoxVertices) {
    if (event.vertex >= placed_.size()) placed_.resize(event.vertex + std::size_t{1}, kNowhere);
    placed_[event.vertex] = static_cast<std::uint32_t>(index);
  }
  if (tail_.size() == kBlock) packTail();
}

void EventLog::packTail() {
  EventCodec codec;
  std::vector<std::uint8_t> bytes;
  Mentioned mentioned;
  for (const Unpacked& unpacked : tail_) {
    const Event& e = unpacked.event;
    codec.pack(e, unpacked.back, bytes);
    mentioned.subject.add(e.subject);
    mentioned.other.add(e.other);
    mentioned.vertex.add(e.vertex);
    mentioned.created.add(e.created, e.createdCount);
    mentioned.kinds |= 1u << static_cast<unsigned>(e.kind);
  }
  mentioned_.push_back(mentioned);
  bytes.shrink_to_fit();
  blocks_.push_back(std::move(bytes));
  tail_.clear();
}

void EventLog::truncate(std::size_t count) {
  TRISCOPE_CHECK(count <= size(), "no more events are kept than there are");
  for (std::size_t k = size(); k-- > count;) {
    const Unpacked& dropped = unpacked(k);
    const Event& e = dropped.event;
    if (!placesVertex(e) || e.vertex >= placed_.size() || placed_[e.vertex] != k) continue;
    placed_[e.vertex] = dropped.back > 0 ? static_cast<std::uint32_t>(k - dropped.back) : kNowhere;
  }
  if (count >= packedSize()) {
    tail_.resize(std::min(tail_.size(), count - packedSize()));
    return;
  }
  const std::size_t block = count / kBlock;
  std::vector<Unpacked> tail;
  for (std::size_t k = block * kBlock; k < count; ++k) tail.push_back({(*this)[k], unpacked(k).back});
  tail_ = std::move(tail);
  blocks_.resize(block);
  mentioned_.resize(block);
  for (OpenBlock& open : open_)
    if (open.block >= block) open = {};
}

const EventLog::OpenBlock& EventLog::open(std::size_t block) const {
  if (open_[latest_].block == block) return open_[latest_];
  const auto found = std::find_if(open_.begin(), open_.end(), [&](const OpenBlock& o) { return o.block == block; });
  const auto oldest = std::min_element(open_.begin(), open_.end(),
                                       [](const OpenBlock& a, const OpenBlock& b) { return a.lastUse < b.lastUse; });
  OpenBlock& open = found != open_.end() ? *found : *oldest;
  latest_ = static_cast<std::size_t>(&open - open_.data());
  open.lastUse = ++uses_;
  if (found != open_.end()) return open;
  open.block = block;
  open.events.clear();
  EventCodec codec;
  const std::uint8_t* bytes = blocks_[block].data();
  for (std::size_t k = 0; k < kBlock; ++k) open.events.push_back(codec.unpack(bytes));
  TRISCOPE_CHECK(bytes == blocks_[block].data() + blocks_[block].size(), "a block of events is read to its end");
  return open;
}

const Unpacked& EventLog::unpacked(std::size_t index) const {
  TRISCOPE_CHECK(index < size(), "an event that is read has been made");
  const std::size_t block = index / kBlock;
  return block == blocks_.size() ? tail_[index - packedSize()] : open(block).events[index % kBlock];
}

Event EventLog::operator[](std::size_t index) const {
  const Unpacked& there = unpacked(index);
  Event event = there.event;
  TRISCOPE_CHECK(there.back <= index, "a vertex was put where it is by an event before");
  if (there.back > 0) event.from = peek(index - there.back).at;
  return event;
}

std::size_t EventLog::bytes() const {
  std::size_t sum = tail_.capacity() * sizeof(Unpacked) + placed_.capacity() * sizeof(std::uint32_t) +
                    blocks_.capacity() * sizeof(std::vector<std::uint8_t>) + mentioned_.capacity() * sizeof(Mentioned);
  for (const auto& block : blocks_) sum += block.capacity();
  return sum;
}

std::size_t commonLength(const EventLog& a, const EventLog& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  const std::size_t packed = std::min(a.blocks_.size(), b.blocks_.size());
  std::size_t block = 0;
  while (block < packed && a.blocks_[block] == b.blocks_[block]) ++block;
  std::size_t k = block * EventLog::kBlock;
  while (k < shorter && sameContent(a[k], b[k])) ++k;
  return k;
}

}  // namespace triscope
