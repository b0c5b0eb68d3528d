#include "core/domain/read_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/shown_text.h"
#include "core/domain/add_curves.h"
#include "core/domain/arc.h"
#include "core/domain/read_values.h"
#include "core/geometry/trig.h"

namespace triscope {

namespace {

using Object = JsonValue::Object;

/// One loop, segment or piece on its way into the draft.
struct Reading {
  const Object& object;
  ReadPlace place;
  bool closed;
  DomainDraft& draft;
};

std::string defaultName(LoopRole role, int number) {
  if (role == LoopRole::outer) return "outer";
  return fmt::format("{} {}", role == LoopRole::hole ? "hole" : "segment", number);
}

/// The points of a run; a closed one may repeat its first point at the end.
Result<PointRun> readRun(const JsonValue& value, bool closed, const ReadPlace& place) {
  auto points = readPoints(value, place);
  if (!points) return points.error();
  if (closed && points->size() > 1 && points->front() == points->back()) points->pop_back();
  return PointRun{std::move(*points), closed, place};
}

Result<PointRun> readRun(const Reading& reading) {
  const auto value = require(reading.object, "points", reading.place);
  if (!value) return value.error();
  return readRun(**value, reading.closed, reading.place);
}

Status addPolygon(const PointRun& run, DomainDraft& draft) {
  const auto status = run.closed ? checkRun(run, 3, "a loop") : checkRun(run, 2, "a segment");
  if (status) addLines(run, draft);
  return status;
}

Status readPolygon(const Reading& reading) {
  const auto run = readRun(reading);
  return run ? addPolygon(*run, reading.draft) : Status(run.error());
}

/// Marks the points listed under "corners".
Status markListed(const JsonValue& value, const PointRun& run, std::vector<bool>& isCorner) {
  const JsonValue::List* list = value.list();
  if (list == nullptr) {
    return complaint(run.place, fmt::format("\"corners\" is {}, not a list", value.typeName()),
                     "list the numbers of the points; \"corner_turn\" takes an angle in degrees");
  }
  for (const JsonValue& item : *list) {
    const double* number = item.number();
    const auto count = static_cast<double>(isCorner.size());
    if (number == nullptr || *number != std::floor(*number) || *number < 0.0 || *number >= count) {
      return complaint(run.place,
                       number != nullptr ? fmt::format("there is no point {} to make a corner", *number)
                                         : fmt::format("a corner is {}, not the number of a point", item.typeName()),
                       fmt::format("the points are numbered 0 to {}", isCorner.size() - 1));
    }
    isCorner[static_cast<std::size_t>(*number)] = true;
  }
  return success();
}

/// Marks the points where the polygon turns by more than "corner_turn" degrees.
Status markTurning(const JsonValue& value, const PointRun& run, std::vector<bool>& isCorner) {
  const double* degrees = value.number();
  if (degrees == nullptr || *degrees <= 0.0 || *degrees >= 180.0) {
    return complaint(run.place, "\"corner_turn\" must be an angle between 0 and 180",
                     "give the turning in degrees above which a point is a corner");
  }
  const std::size_t count = run.points.size();
  for (std::size_t i = run.closed ? 0 : 1; i + (run.closed ? 0 : 1) < count; ++i) {
    const Point before = run.points[i] - run.points[(i + count - 1) % count];
    const Point after = run.points[(i + 1) % count] - run.points[i];
    if (std::fabs(trig::angleBetween(before, after)) > *degrees * trig::kDegree) isCorner[i] = true;
  }
  return success();
}

Result<std::vector<int>> readCorners(const Reading& reading, const PointRun& run) {
  std::vector<bool> isCorner(run.points.size(), false);
  if (const JsonValue* listed = find(reading.object, "corners")) {
    if (auto status = markListed(*listed, run, isCorner); !status) return status.error();
  }
  if (const JsonValue* turn = find(reading.object, "corner_turn")) {
    if (auto status = markTurning(*turn, run, isCorner); !status) return status.error();
  }
  std::vector<int> corners;
  for (std::size_t i = 0; i < isCorner.size(); ++i) {
    if (isCorner[i]) corners.push_back(static_cast<int>(i));
  }
  return corners;
}

Status readSpline(const Reading& reading) {
  const auto run = readRun(reading);
  if (!run) return run.error();
  if (auto status = checkRun(*run, run->closed ? 3 : 2, run->closed ? "a closed spline" : "a spline"); !status) {
    return status;
  }
  const auto corners = readCorners(reading, *run);
  return corners ? addSplines(*run, *corners, reading.draft) : Status(corners.error());
}

/// "centre", or "center" for those who spell it so.
Result<Point> readCentre(const Reading& reading) {
  const JsonValue* american = find(reading.object, "center");
  if (american == nullptr) {
    const auto centre = require(reading.object, "centre", reading.place);
    return centre ? readPoint(**centre, "\"centre\"", reading.place, -1) : centre.error();
  }
  if (find(reading.object, "centre") == nullptr) return readPoint(*american, "\"center\"", reading.place, -1);
  return complaint(reading.place, "\"centre\" and \"center\" are given together", "keep one: they mean the same");
}

Status readCircle(const Reading& reading) {
  const auto middle = readCentre(reading);
  if (!middle) return middle.error();
  const auto radius = require(reading.object, "radius", reading.place);
  if (!radius) return radius.error();
  const auto reach = readPositive(**radius, "radius", reading.place);
  if (!reach) return reach.error();
  reading.draft.domain.curves.push_back(makeCircle(*middle, *reach));
  reading.draft.sources.push_back({.piece = reading.place.piece});
  return success();
}

Status readArc(const Reading& reading) {
  const auto run = readRun(reading);
  if (!run) return run.error();
  if (run->points.size() != 3) {
    return complaint(reading.place, fmt::format("an arc has {} points", run->points.size()),
                     "give three: where it starts, one that it passes, where it ends");
  }
  const auto status = checkRun(*run, 3, "an arc");
  return status ? addArc(*run, reading.draft) : status;
}

Status readPieces(const Reading& reading);

/// What a loop, a segment or a piece can be.
struct Kind {
  std::string_view name;
  bool ofLoop;
  bool ofSegment;
  bool ofPiece;
  std::array<std::string_view, 3> keys;  // beside the common ones
  Status (*read)(const Reading&);
};

constexpr std::array<Kind, 7> kKinds{{{"polygon", true, false, false, {"points"}, readPolygon},
                                      {"polyline", false, true, false, {"points"}, readPolygon},
                                      {"line", false, false, true, {"points"}, readPolygon},
                                      {"arc", false, false, true, {"points"}, readArc},
                                      {"spline", true, true, true, {"points", "corners", "corner_turn"}, readSpline},
                                      {"circle", true, false, false, {"centre", "radius", "center"}, readCircle},
                                      {"pieces", true, true, false, {"pieces"}, readPieces}}};

bool allows(const Kind& kind, const Reading& reading) {
  return reading.place.piece >= 0 ? kind.ofPiece : reading.closed ? kind.ofLoop : kind.ofSegment;
}

/// Reads what an object says by its "kind".
Status readKind(const Reading& reading, std::string_view otherwise) {
  const auto name = readText(reading.object, "kind", reading.place, std::string(otherwise));
  if (!name) return name.error();
  std::vector<std::string_view> possible;
  for (const Kind& kind : kKinds) {
    if (!allows(kind, reading)) continue;
    possible.push_back(kind.name);
    if (kind.name != *name) continue;
    std::vector<std::string_view> keys{"kind", "description"};
    if (reading.place.piece < 0) keys.emplace_back("name");
    std::copy_if(kind.keys.begin(), kind.keys.end(), std::back_inserter(keys), [](auto key) { return !key.empty(); });
    const auto status = checkKeys(reading.object, keys, reading.place);
    return status ? kind.read(reading) : status;
  }
  return complaint(reading.place, fmt::format("unknown kind \"{}\"", shown(*name)),
                   fmt::format("known here: {}", fmt::join(possible, ", ")));
}

Error gap(const ReadPlace& place, int from, Point end, int to, Point start) {
  Error error{.message = fmt::format("not closed: piece {} ends at ({}, {}) but piece {} starts at ({}, {})", from,
                                     end.x, end.y, to, start.x, start.y),
              .hint = "let each piece start exactly where the one before it ends",
              .loop = place.loop};
  error.at = end;
  return error;
}

Status readPieces(const Reading& reading) {
  const auto value = require(reading.object, "pieces", reading.place);
  if (!value) return value.error();
  const JsonValue::List* list = (*value)->list();
  if (list == nullptr || list->empty()) {
    return complaint(reading.place, "\"pieces\" must be a list of pieces",
                     "write \"pieces\": [{\"kind\": \"line\", \"points\": [[x, y], [x, y]]}, …]");
  }
  auto& curves = reading.draft.domain.curves;
  const std::size_t first = curves.size();
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto number = static_cast<int>(i);
    const ReadPlace place{reading.place.loop, number};
    const Object* object = (*list)[i].object();
    if (object == nullptr) {
      return complaint(place, fmt::format("it is {}, not an object", (*list)[i].typeName()),
                       "write {\"kind\": \"line\", \"points\": [[x, y], [x, y]]}");
    }
    const std::size_t begin = curves.size();
    if (auto status = readKind({*object, place, false, reading.draft}, "line"); !status) return status;
    if (begin > first && !(curves[begin - 1].b == curves[begin].a)) {
      return gap(place, number - 1, curves[begin - 1].b, number, curves[begin].a);
    }
  }
  if (reading.closed && !(curves.back().b == curves[first].a)) {
    return gap(reading.place, static_cast<int>(list->size()) - 1, curves.back().b, 0, curves[first].a);
  }
  return success();
}

Status readObject(const Object& object, ReadPlace& place, bool closed, DomainDraft& draft) {
  auto name = readText(object, "name", place, place.loop);
  if (!name) return name.error();
  if (name->empty()) return complaint(place, "\"name\" is empty", "give it a name, or leave the key out");
  place.loop = std::move(*name);
  const std::string_view plain = closed ? "polygon" : "polyline";
  return readKind({object, place, closed, draft}, find(object, "pieces") != nullptr ? "pieces" : plain);
}

}  // namespace

Status readLoop(const JsonValue& value, LoopRole role, int number, DomainDraft& draft) {
  ReadPlace place{defaultName(role, number)};
  const bool closed = role != LoopRole::chain;
  const std::size_t first = draft.domain.curves.size();
  Status status = success();
  if (const Object* object = value.object()) {
    status = readObject(*object, place, closed, draft);
  } else if (value.list() != nullptr) {
    const auto run = readRun(value, closed, place);
    status = run ? addPolygon(*run, draft) : Status(run.error());
  } else {
    status = complaint(place, fmt::format("it is {}, not a loop", value.typeName()),
                       "write a list of points [[x, y], …] or an object with a \"kind\"");
  }
  if (!status) return status;
  const std::size_t count = draft.domain.curves.size() - first;
  draft.domain.loops.push_back(
      {place.loop, role, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
  return success();
}

}  // namespace triscope
