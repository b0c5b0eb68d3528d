#include "core/domain/read_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/shown_text.h"

namespace triscope {

namespace {

/// Letters to insert, delete, change or swap with the next one to make one text the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const bool same = a[i - 1] == b[j - 1];
      const std::size_t changed = cost[i - 1][j - 1] + (same ? 0 : 1);
      cost[i][j] = std::min({changed, cost[i - 1][j] + 1, cost[i][j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

bool representable(double coordinate) {
  const double size = std::fabs(coordinate);
  return size == 0.0 || (size >= kSmallestCoordinate && size <= kLargestCoordinate);
}

}  // namespace

Error complaint(const ReadPlace& place, std::string message, std::string hint) {
  if (!place.entry.empty()) message = fmt::format("{}: {}", place.entry, message);
  if (place.piece >= 0) message = fmt::format("piece {}: {}", place.piece, message);
  return Error{.message = std::move(message), .hint = std::move(hint), .loop = place.loop};
}

std::string_view nearestKey(std::string_view key, std::span<const std::string_view> known) {
  if (key.size() > 64) return {};
  for (const std::string_view candidate : known) {
    const std::size_t slips = candidate.size() >= 8 ? 2 : 1;
    if (candidate.size() >= 4 && editDistance(key, candidate) <= slips) return candidate;
  }
  return {};
}

Status checkKeys(const JsonValue::Object& object, std::span<const std::string_view> known, const ReadPlace& place) {
  for (const JsonMember& member : object) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    const std::string_view meant = nearestKey(member.key, known);
    return complaint(place, fmt::format("unknown key \"{}\"", shown(member.key)),
                     meant.empty() ? fmt::format("known here: {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean \"{}\"?", meant));
  }
  return success();
}

Result<const JsonValue*> require(const JsonValue::Object& object, std::string_view key, const ReadPlace& place) {
  const JsonValue* value = find(object, key);
  if (value != nullptr) return value;
  return complaint(place, fmt::format("\"{}\" is missing", key), "add it");
}

Result<std::string> readText(const JsonValue::Object& object, std::string_view key, const ReadPlace& place,
                             std::string otherwise) {
  const JsonValue* value = find(object, key);
  if (value == nullptr) return otherwise;
  if (value->text() != nullptr) return *value->text();
  return complaint(place, fmt::format("\"{}\" is {}, not a text", key, value->typeName()),
                   fmt::format("write \"{}\": \"…\"", key));
}

Result<double> readPositive(const JsonValue& value, std::string_view key, const ReadPlace& place) {
  const double* number = value.number();
  if (number == nullptr) {
    return complaint(place, fmt::format("\"{}\" is {}, not a number", key, value.typeName()),
                     fmt::format("write \"{}\": 1.5 or the like", key));
  }
  if (*number > 0.0 && representable(*number)) return *number;
  return complaint(place, fmt::format("\"{}\" is {}", key, *number),
                   fmt::format("it must be positive, {} to {}", kSmallestCoordinate, kLargestCoordinate));
}

Result<Point> readPoint(const JsonValue& value, std::string_view what, const ReadPlace& place, int index) {
  const JsonValue::List* pair = value.list();
  const bool isPair = pair != nullptr && pair->size() == 2;
  const double* x = isPair ? (*pair)[0].number() : nullptr;
  const double* y = isPair ? (*pair)[1].number() : nullptr;
  Error error;
  if (x == nullptr || y == nullptr) {
    const std::string found = pair == nullptr ? std::string(value.typeName())
                              : !isPair       ? fmt::format("a list of {}", pair->size())
                                              : fmt::format("[{}, {}]", (*pair)[0].typeName(), (*pair)[1].typeName());
    error = complaint(place, fmt::format("{} must be two numbers, not {}", what, found), "write it as [x, y]");
  } else if (!representable(*x) || !representable(*y)) {
    const bool large = std::fabs(*x) > kLargestCoordinate || std::fabs(*y) > kLargestCoordinate;
    error = complaint(place, fmt::format("a coordinate is too {}", large ? "large" : "small"),
                      large ? fmt::format("use magnitudes up to {}", kLargestCoordinate)
                            : fmt::format("use 0, or magnitudes from {}", kSmallestCoordinate));
    error.at = Point{*x, *y};
  } else {
    return Point{*x, *y};
  }
  error.point = index;
  return error;
}

Result<std::vector<Point>> readPoints(const JsonValue& value, const ReadPlace& place) {
  const JsonValue::List* list = value.list();
  if (list == nullptr) {
    return complaint(place, fmt::format("the points are {}, not a list", value.typeName()),
                     "write [[x, y], [x, y], …]");
  }
  std::vector<Point> points;
  points.reserve(list->size());
  for (const JsonValue& item : *list) {
    const auto point = readPoint(item, "a point", place, static_cast<int>(points.size()));
    if (!point) return point.error();
    points.push_back(*point);
  }
  return points;
}

}  // namespace triscope
