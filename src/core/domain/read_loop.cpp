#include "core/domain/read_loop.h"

#include <fmt/format.h>

#include <cmath>

namespace triscope {

namespace {

constexpr double kLargest = 1e30;

std::string nameFor(LoopRole role, int number) {
  switch (role) {
    case LoopRole::hole:
      return fmt::format("hole {}", number);
    case LoopRole::chain:
      return fmt::format("segment {}", number);
    case LoopRole::outer:
      break;
  }
  return "outer";
}

Result<Point> readPoint(const JsonValue& value, const std::string& loop, int index) {
  const JsonValue::List* pair = value.list();
  const double* x = pair != nullptr && pair->size() == 2 ? (*pair)[0].number() : nullptr;
  const double* y = pair != nullptr && pair->size() == 2 ? (*pair)[1].number() : nullptr;
  if (x == nullptr || y == nullptr) {
    return Error{.message = "a point must be two numbers", .hint = "write it as [x, y]", .loop = loop, .point = index};
  }
  if (!(std::fabs(*x) <= kLargest && std::fabs(*y) <= kLargest)) {
    return Error{.message = "a coordinate is too large",
                 .hint = "use coordinates of magnitude up to 1e30",
                 .loop = loop,
                 .point = index,
                 .at = Point{*x, *y}};
  }
  return Point{*x, *y};
}

Result<std::vector<Point>> readPoints(const JsonValue& value, const std::string& loop) {
  const JsonValue::List* list = value.list();
  if (list == nullptr) {
    return Error{.message = fmt::format("the points are {}, not a list", value.typeName()),
                 .hint = "write [[x, y], [x, y], …]",
                 .loop = loop};
  }
  std::vector<Point> points;
  points.reserve(list->size());
  for (const JsonValue& item : *list) {
    const auto point = readPoint(item, loop, static_cast<int>(points.size()));
    if (!point) return point.error();
    points.push_back(*point);
  }
  return points;
}

}  // namespace

Status readLoop(const JsonValue& value, LoopRole role, int number, DomainDraft& draft) {
  const std::string name = nameFor(role, number);
  auto read = readPoints(value, name);
  if (!read) return read.error();
  std::vector<Point>& points = *read;
  const bool closed = role != LoopRole::chain;
  if (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  const std::size_t fewest = closed ? 3 : 2;
  if (points.size() < fewest) {
    return Error{.message = fmt::format("{} of at least {} points needed", points.size(), fewest),
                 .hint = closed ? "a loop needs three points or more" : "a segment needs two points or more",
                 .loop = name,
                 .point = points.empty() ? -1 : 0,
                 .at = points.empty() ? std::nullopt : std::optional(points[0])};
  }
  const auto first = static_cast<std::uint32_t>(draft.domain.curves.size());
  const std::size_t edges = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = (i + 1) % points.size();
    if (points[i] == points[next]) {
      return Error{.message = fmt::format("the same as point {}", i),
                   .hint = "remove one of the two",
                   .loop = name,
                   .point = static_cast<int>(next),
                   .at = points[i]};
    }
    draft.domain.curves.push_back({.kind = CurveKind::line, .a = points[i], .b = points[next]});
    draft.sources.push_back({.first = static_cast<int>(i), .count = static_cast<int>(points.size())});
  }
  draft.domain.loops.push_back({name, role, first, static_cast<std::uint32_t>(edges)});
  return success();
}

}  // namespace triscope
