#include "core/domain/read_density.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/shown_text.h"
#include "core/domain/read_values.h"

namespace triscope {

namespace {

using Object = JsonValue::Object;
using Where = DensityRequest::Where;

constexpr int kCoarsestRank = 64;
constexpr std::array<std::string_view, 7> kRequestKeys{"name", "description", "at", "loop", "box", "rank", "length"};

bool meets(const Box& box, Point lo, Point hi) {
  return lo.x <= box.hi.x && hi.x >= box.lo.x && lo.y <= box.hi.y && hi.y >= box.lo.y;
}

std::string boxText(const Box& box) {
  return fmt::format("[{}, {}] to [{}, {}]", box.lo.x, box.lo.y, box.hi.x, box.hi.y);
}

Status readAt(const JsonValue& value, const Domain& domain, const ReadPlace& place, DensityRequest& request) {
  const auto point = readPoint(value, "\"at\"", place, -1);
  if (!point) return point.error();
  request.where = Where::point;
  request.at = *point;
  if (meets(domain.bounds, *point, *point)) return success();
  Error error = complaint(place, "the point lies outside the domain",
                          fmt::format("the domain reaches from {}", boxText(domain.bounds)));
  error.at = *point;
  return error;
}

Status readBox(const JsonValue& value, const Domain& domain, const ReadPlace& place, DensityRequest& request) {
  const auto corners = readPoints(value, place);
  if (!corners) return corners.error();
  if (corners->size() != 2) {
    return complaint(place, fmt::format("\"box\" has {} corners", corners->size()),
                     "give two opposite ones: [[x0, y0], [x1, y1]]");
  }
  Box box;
  box.include((*corners)[0]);
  box.include((*corners)[1]);
  request.where = Where::box;
  request.at = box.lo;
  request.to = box.hi;
  Error error;
  if (box.width() <= 0.0 || box.height() <= 0.0) {
    error = complaint(place, "the box has no area", "give two opposite corners");
  } else if (!meets(domain.bounds, box.lo, box.hi)) {
    error = complaint(place, "the box lies outside the domain",
                      fmt::format("the domain reaches from {}", boxText(domain.bounds)));
  } else {
    return success();
  }
  error.at = box.lo;
  return error;
}

Status readAlong(const JsonValue& value, const Domain& domain, const ReadPlace& place, DensityRequest& request) {
  if (value.text() == nullptr) {
    return complaint(place, fmt::format("\"loop\" is {}, not a text", value.typeName()), "give the name of a loop");
  }
  request.where = Where::loop;
  request.loop = *value.text();
  std::vector<std::string> names;
  for (const Loop& loop : domain.loops) {
    if (loop.name == request.loop) return success();
    if (names.size() < 12) names.push_back(shown(loop.name));
  }
  return complaint(
      place, fmt::format("there is no loop '{}'", shown(request.loop)),
      fmt::format("there are: {}{}", fmt::join(names, ", "), names.size() < domain.loops.size() ? ", …" : ""));
}

Status readRank(const JsonValue& value, const ReadPlace& place, DensityRequest& request) {
  const double* rank = value.number();
  if (rank == nullptr || *rank != std::floor(*rank) || *rank < 1.0 || *rank > kCoarsestRank) {
    return complaint(place,
                     rank == nullptr ? fmt::format("\"rank\" is {}, not a number", value.typeName())
                                     : fmt::format("\"rank\" is {}", *rank),
                     fmt::format("a density rank is a whole number from 1 (finest) to {}", kCoarsestRank));
  }
  request.rank = static_cast<int>(*rank);
  return success();
}

Status readLength(const JsonValue& value, const Domain& domain, const ReadPlace& place, DensityRequest& request) {
  const auto length = readPositive(value, "length", place);
  if (!length) return length.error();
  request.length = *length;
  if (*length >= domain.minEdgeLength) return success();
  return complaint(place,
                   fmt::format("\"length\" is {}, below the smallest edge length {}", *length, domain.minEdgeLength),
                   "raise it, or lower \"min_edge_length\"");
}

/// Exactly one of the keys must be there.
Result<std::string_view> whichOf(const Object& object, std::span<const std::string_view> keys, const ReadPlace& place) {
  std::vector<std::string_view> given;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(given),
               [&](std::string_view key) { return find(object, key) != nullptr; });
  if (given.size() == 1) return given.front();
  const auto listed = fmt::format("{}", fmt::join(keys, ", "));
  if (given.empty()) return complaint(place, fmt::format("none of {} is given", listed), "give exactly one of them");
  return complaint(place, fmt::format("{} are given together", fmt::join(given, ", ")),
                   fmt::format("give exactly one of {}", listed));
}

Result<DensityRequest> readRequest(const JsonValue& value, int number, const Domain& domain) {
  ReadPlace place{.entry = fmt::format("density entry {}", number)};
  const Object* object = value.object();
  if (object == nullptr) {
    return complaint(place, fmt::format("it is {}, not an object", value.typeName()),
                     "write {\"at\": [x, y], \"length\": 0.1} or the like");
  }
  DensityRequest request;
  const auto name = readText(*object, "name", place, "");
  if (!name) return name.error();
  request.name = *name;
  const auto description = readText(*object, "description", place, "");
  if (!description) return description.error();
  request.description = *description;
  if (!name->empty()) place.entry = fmt::format("density entry '{}'", shown(*name));
  if (auto status = checkKeys(*object, kRequestKeys, place); !status) return status.error();

  constexpr std::array<std::string_view, 3> wheres{"at", "loop", "box"};
  const auto where = whichOf(*object, wheres, place);
  if (!where) return where.error();
  const JsonValue& there = *find(*object, *where);
  auto status = *where == "at"    ? readAt(there, domain, place, request)
                : *where == "box" ? readBox(there, domain, place, request)
                                  : readAlong(there, domain, place, request);
  if (!status) return status.error();

  constexpr std::array<std::string_view, 2> sizes{"rank", "length"};
  const auto size = whichOf(*object, sizes, place);
  if (!size) return size.error();
  const JsonValue& wish = *find(*object, *size);
  status = *size == "rank" ? readRank(wish, place, request) : readLength(wish, domain, place, request);
  if (!status) return status.error();
  return request;
}

}  // namespace

Status readDensity(const JsonValue& value, Domain& domain) {
  const JsonValue::List* list = value.list();
  if (list == nullptr) {
    return complaint({}, fmt::format("\"density\" is {}, not a list", value.typeName()),
                     "write \"density\": [{\"at\": [x, y], \"length\": 0.1}, …]");
  }
  int number = 0;
  for (const JsonValue& item : *list) {
    auto request = readRequest(item, ++number, domain);
    if (!request) return request.error();
    domain.density.push_back(std::move(*request));
  }
  return success();
}

}  // namespace triscope
