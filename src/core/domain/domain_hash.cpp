#include "core/domain/domain_hash.h"

#include "core/base/digest.h"

namespace triscope {
namespace {

// Each struct is taken apart into all of its members: one that is added to it does not compile before it is looked at.

void add(Digest& digest, const Box& box) {
  const auto& [lo, hi] = box;
  digest.point(lo);
  digest.point(hi);
}

void add(Digest& digest, const Loop& loop) {
  const auto& [name, role, firstCurve, curveCount] = loop;
  digest.text(name);
  digest.word(static_cast<std::uint64_t>(role));
  digest.word(firstCurve);
  digest.word(curveCount);
}

void add(Digest& digest, const Curve& curve) {
  const auto& [kind, a, b, centre, radius, startAngle, sweptAngle, knots, slopes, params] = curve;
  digest.word(static_cast<std::uint64_t>(kind));
  for (const Point p : {a, b, centre}) digest.point(p);
  for (const double d : {radius, startAngle, sweptAngle}) digest.number(d);
  digest.points(knots);
  digest.points(slopes);
  digest.numbers(params);
}

void add(Digest& digest, const DensityRequest& request) {
  const auto& [where, at, to, loop, rank, length, name, description] = request;
  digest.word(static_cast<std::uint64_t>(where));
  digest.point(at);
  digest.point(to);
  digest.word(static_cast<std::uint64_t>(rank));
  digest.number(length);
  for (const std::string& text : {loop, name, description}) digest.text(text);
}

template <class T>
void addAll(Digest& digest, const std::vector<T>& list) {
  digest.word(list.size());
  for (const T& one : list) add(digest, one);
}

}  // namespace

std::uint64_t hashOf(const Domain& domain) {
  const auto& [name, file, text, minEdgeLength, loops, curves, density, bounds] = domain;
  Digest digest;
  digest.text(name);
  digest.number(minEdgeLength);
  addAll(digest, loops);
  addAll(digest, curves);
  addAll(digest, density);
  add(digest, bounds);
  return digest.value;
}

}  // namespace triscope
