// The small values that a domain file is made of, read with errors that say where.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_value.h"
#include "core/base/result.h"

namespace triscope {

inline constexpr double kLargestCoordinate = 1e30;
inline constexpr double kSmallestCoordinate = 1e-40;  // 0 itself is fine

/// What is being read: the loop and the piece of it (-1: none), or an entry of another list ("density entry 2").
struct ReadPlace {
  std::string loop{};
  int piece = -1;
  std::string entry{};
};

/// An error at a place; a piece or an entry is named in the message.
Error complaint(const ReadPlace& place, std::string message, std::string hint);

/// Refuses keys that are not in `known`, and suggests the one that was meant.
Status checkKeys(const JsonValue::Object& object, std::span<const std::string_view> known, const ReadPlace& place);
/// Nearest of the known keys when `key` looks like a slip of the finger for it, else empty.
std::string_view nearestKey(std::string_view key, std::span<const std::string_view> known);

/// The member, or an error when it is missing.
Result<const JsonValue*> require(const JsonValue::Object& object, std::string_view key, const ReadPlace& place);
/// The text of a member, or `otherwise` when it is missing.
Result<std::string> readText(const JsonValue::Object& object, std::string_view key, const ReadPlace& place,
                             std::string otherwise);
/// A number in (0, kLargestCoordinate].
Result<double> readPositive(const JsonValue& value, std::string_view key, const ReadPlace& place);
/// A point [x, y] of representable size. `what` names it ("a point", "\"centre\""), index is its number or -1.
Result<Point> readPoint(const JsonValue& value, std::string_view what, const ReadPlace& place, int index);
/// A list of points.
Result<std::vector<Point>> readPoints(const JsonValue& value, const ReadPlace& place);

}  // namespace triscope
