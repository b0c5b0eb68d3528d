#include "core/run/event_codec.h"

#include <algorithm>
#include <bit>

#include "core/base/assert.h"

namespace triscope {
namespace {

// Members that follow the number of the pattern. What is absent has the value that Event gives it.
enum Part : std::uint16_t {
  kRemovedCount = 1,
  kSubject = 2,
  kOther = 4,
  kVertex = 8,
  kVertexExpected = 16,  // is there and as expected: nothing follows
  kCreated = 32,
  kCreatedExpected = 64,
  kCreatedCount = 128,
  kLimit = 256,
  kMeasured = 512,
  kAt = 1024,
  kFrom = 2048,
  kBack = 4096,
};

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }
bool isThere(double value) { return bitsOf(value) != 0; }
bool isThere(Point p) { return isThere(p.x) || isThere(p.y); }

/// Small for a small difference of either sign.
std::uint64_t zigzag(std::uint64_t difference) { return (difference << 1u) ^ (0 - (difference >> 63u)); }
std::uint64_t unzigzag(std::uint64_t z) { return (z >> 1u) ^ (0 - (z & 1u)); }

/// Seven bits a byte, the lowest first; the top bit says that more follow.
void putNumber(std::uint64_t value, std::vector<std::uint8_t>& bytes) {
  for (; value >= 128; value >>= 7u) bytes.push_back(static_cast<std::uint8_t>(value | 128u));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint64_t getNumber(const std::uint8_t*& bytes) {
  std::uint64_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint64_t byte = *bytes++;
    value |= (byte & 127u) << shift;
    if (byte < 128) return value;
  }
}

void putId(std::uint32_t id, std::uint32_t expected, std::vector<std::uint8_t>& bytes) {
  putNumber(zigzag(std::uint64_t{id} - expected), bytes);
}

std::uint32_t getId(std::uint32_t expected, const std::uint8_t*& bytes) {
  return static_cast<std::uint32_t>(expected + unzigzag(getNumber(bytes)));
}

// A double is told by a code of two bits, four to a byte, and the bytes that it announces: so many low ones of the
// difference to the expected one, or its place in the table of recent ones; of what is not looked up there, none for
// one just as expected. Few differences take less than six bytes.
constexpr unsigned kShort = 0;
constexpr std::array<unsigned, 4> kBytes = {0, 6, 7, 8};

using Recent = std::array<std::uint64_t, 256>;

std::size_t placeOf(std::uint64_t bits) { return static_cast<std::size_t>((bits * 0x9E3779B97F4A7C15u) >> 56u); }

class DoublesOut {
 public:
  explicit DoublesOut(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  void put(double value, double expected) {
    const std::uint64_t difference = zigzag(bitsOf(value) - bitsOf(expected));
    if (difference == 0)
      code(kShort);
    else
      putDifference(difference);
  }

  void put(double value, double expected, Recent& recent) {
    const std::uint64_t bits = bitsOf(value);
    const std::size_t place = placeOf(bits);
    if (recent[place] == bits) {
      code(kShort);
      bytes_.push_back(static_cast<std::uint8_t>(place));
    } else {
      putDifference(zigzag(bits - bitsOf(expected)));
      recent[place] = bits;
    }
  }

 private:
  void putDifference(std::uint64_t difference) {
    unsigned which = 1;
    while (which < 3 && difference >> (8 * kBytes[which]) != 0) ++which;
    code(which);
    for (unsigned k = 0; k < kBytes[which]; ++k) bytes_.push_back(static_cast<std::uint8_t>(difference >> (8 * k)));
  }

  void code(unsigned value) {
    if (count_ % 4 == 0) {
      codesAt_ = bytes_.size();
      bytes_.push_back(0);
    }
    bytes_[codesAt_] = static_cast<std::uint8_t>(bytes_[codesAt_] | (value << (2 * (count_ % 4))));
    ++count_;
  }

  std::vector<std::uint8_t>& bytes_;
  std::size_t codesAt_ = 0;
  unsigned count_ = 0;
};

class DoublesIn {
 public:
  explicit DoublesIn(const std::uint8_t*& bytes) : bytes_(bytes) {}

  double get(double expected) {
    const unsigned what = code();
    return what == kShort ? expected : difference(what, expected);
  }

  double get(double expected, Recent& recent) {
    const unsigned what = code();
    if (what == kShort) return std::bit_cast<double>(recent[*bytes_++]);
    const double value = difference(what, expected);
    recent[placeOf(bitsOf(value))] = bitsOf(value);
    return value;
  }

 private:
  double difference(unsigned which, double expected) {
    std::uint64_t difference = 0;
    for (unsigned k = 0; k < kBytes[which]; ++k) difference |= std::uint64_t{*bytes_++} << (8 * k);
    return std::bit_cast<double>(bitsOf(expected) + unzigzag(difference));
  }

  unsigned code() {
    if (count_ % 4 == 0) codes_ = *bytes_++;
    return codes_ >> (2 * (count_++ % 4)) & 3u;
  }

  const std::uint8_t*& bytes_;
  unsigned codes_ = 0;
  unsigned count_ = 0;
};

}  // namespace

std::size_t EventCodec::numberOf(const Pattern& pattern) {
  return static_cast<std::size_t>(std::find(patterns_.begin(), patterns_.end(), pattern) - patterns_.begin());
}

std::uint16_t EventCodec::partsOf(const Event& e, std::uint32_t back) const {
  unsigned parts = 0;
  if (e.removedCount != 0) parts |= kRemovedCount;
  if (e.subject != kNoId) parts |= kSubject;
  if (e.other != kNoId) parts |= kOther;
  if (e.vertex != kNoId) parts |= e.vertex == expected_.vertex ? kVertexExpected : kVertex;
  if (e.created != kNoId) parts |= e.created == expected_.created ? kCreatedExpected : kCreated;
  if (e.createdCount != 0) parts |= kCreatedCount;
  if (isThere(e.limit)) parts |= kLimit;
  if (isThere(e.measured)) parts |= kMeasured;
  if (isThere(e.at)) parts |= kAt;
  if (back > 0)
    parts |= kBack;
  else if (isThere(e.from))
    parts |= kFrom;
  return static_cast<std::uint16_t>(parts);
}

void EventCodec::learn(const Event& e, std::uint32_t back) {
  if (e.subject != kNoId) expected_.subject = e.subject;
  if (e.other != kNoId) expected_.other = e.other;
  if (e.vertex != kNoId) expected_.vertex = e.vertex + 1;  // passes go through the vertices in order
  if (e.created != kNoId) expected_.created = e.created + e.createdCount;
  if (back > 0) expected_.back = back;
  if (isThere(e.limit)) expected_.limit = e.limit;
  if (isThere(e.at)) expected_.at = e.at;
}

void EventCodec::pack(const Event& e, std::uint32_t back, std::vector<std::uint8_t>& bytes) {
  const Pattern pattern{e.kind, e.stage, e.rule, e.refusal, e.round, partsOf(e, back)};
  const std::size_t number = numberOf(pattern);
  putNumber(number, bytes);
  if (number == patterns_.size()) {
    patterns_.push_back(pattern);
    for (const unsigned value :
         {static_cast<unsigned>(e.kind), static_cast<unsigned>(e.stage), static_cast<unsigned>(e.rule),
          static_cast<unsigned>(e.refusal), static_cast<unsigned>(e.round), static_cast<unsigned>(pattern.parts)})
      putNumber(value, bytes);
  }
  const unsigned parts = pattern.parts;
  if ((parts & kRemovedCount) != 0) putNumber(e.removedCount, bytes);
  if ((parts & kSubject) != 0) putId(e.subject, expected_.subject, bytes);
  if ((parts & kOther) != 0) putId(e.other, expected_.other, bytes);
  if ((parts & kVertex) != 0) putId(e.vertex, expected_.vertex, bytes);
  if ((parts & kCreated) != 0) putId(e.created, expected_.created, bytes);
  if ((parts & kCreatedCount) != 0) putNumber(e.createdCount, bytes);
  if ((parts & kBack) != 0) putId(back, expected_.back, bytes);
  DoublesOut doubles(bytes);
  if ((parts & kLimit) != 0) doubles.put(e.limit, expected_.limit, recent_);
  if ((parts & kMeasured) != 0) doubles.put(e.measured, e.limit, recent_);
  if ((parts & kAt) != 0) {
    doubles.put(e.at.x, expected_.at.x);
    doubles.put(e.at.y, expected_.at.y);
  }
  if ((parts & kFrom) != 0) {
    doubles.put(e.from.x, e.at.x);
    doubles.put(e.from.y, e.at.y);
  }
  learn(e, back);
}

Unpacked EventCodec::unpack(const std::uint8_t*& bytes) {
  const auto number = static_cast<std::size_t>(getNumber(bytes));
  if (number == patterns_.size()) {
    Pattern pattern;
    pattern.kind = static_cast<EventKind>(getNumber(bytes));
    pattern.stage = static_cast<Stage>(getNumber(bytes));
    pattern.rule = static_cast<Rule>(getNumber(bytes));
    pattern.refusal = static_cast<Refusal>(getNumber(bytes));
    pattern.round = static_cast<std::uint16_t>(getNumber(bytes));
    pattern.parts = static_cast<std::uint16_t>(getNumber(bytes));
    patterns_.push_back(pattern);
  }
  TRISCOPE_CHECK(number < patterns_.size(), "the pattern of an event has been told");
  const Pattern& pattern = patterns_[number];
  const unsigned parts = pattern.parts;
  Unpacked unpacked;
  Event& e = unpacked.event;
  e.kind = pattern.kind;
  e.stage = pattern.stage;
  e.rule = pattern.rule;
  e.refusal = pattern.refusal;
  e.round = pattern.round;
  if ((parts & kRemovedCount) != 0) e.removedCount = static_cast<std::uint16_t>(getNumber(bytes));
  if ((parts & kSubject) != 0) e.subject = getId(expected_.subject, bytes);
  if ((parts & kOther) != 0) e.other = getId(expected_.other, bytes);
  if ((parts & kVertex) != 0) e.vertex = getId(expected_.vertex, bytes);
  if ((parts & kVertexExpected) != 0) e.vertex = expected_.vertex;
  if ((parts & kCreated) != 0) e.created = getId(expected_.created, bytes);
  if ((parts & kCreatedExpected) != 0) e.created = expected_.created;
  if ((parts & kCreatedCount) != 0) e.createdCount = static_cast<std::uint32_t>(getNumber(bytes));
  if ((parts & kBack) != 0) unpacked.back = getId(expected_.back, bytes);
  DoublesIn doubles(bytes);
  if ((parts & kLimit) != 0) e.limit = doubles.get(expected_.limit, recent_);
  if ((parts & kMeasured) != 0) e.measured = doubles.get(e.limit, recent_);
  if ((parts & kAt) != 0) {
    e.at.x = doubles.get(expected_.at.x);
    e.at.y = doubles.get(expected_.at.y);
  }
  if ((parts & kFrom) != 0) {
    e.from.x = doubles.get(e.at.x);
    e.from.y = doubles.get(e.at.y);
  }
  learn(e, unpacked.back);
  return unpacked;
}

}  // namespace triscope
