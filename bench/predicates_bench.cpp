// Nanoseconds of the exact predicates where a filter answers, and where it cannot.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/predicates.h"

namespace triscope::bench {
namespace {

constexpr std::size_t kQueries = 1024;
using Query = std::array<Point, 4>;

/// xorshift64*, seeded: the same queries in every run.
struct Random {
  std::uint64_t state = 0x9e3779b97f4a7c15u;
  double unit() {
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return static_cast<double>((state * 0x2545f4914f6cdd1du) >> 11) * 0x1p-53;
  }
};

std::vector<Query> randomQueries() {
  Random random;
  std::vector<Query> queries(kQueries);
  for (Query& query : queries) {
    for (Point& p : query) p = {random.unit(), random.unit()};
    if (orient2d(query[0], query[1], query[2]) < 0) std::swap(query[1], query[2]);
  }
  return queries;
}

/// Corners of squares of a grid: every query is exactly cocircular, and its first three points make a right angle.
std::vector<Query> gridQueries(double scale) {
  Random random;
  std::vector<Query> queries(kQueries);
  for (Query& query : queries) {
    const double x = scale * static_cast<double>(static_cast<int>(64.0 * random.unit()));
    const double y = scale * static_cast<double>(static_cast<int>(64.0 * random.unit()));
    query = {Point{x, y}, Point{x + scale, y}, Point{x + scale, y + scale}, Point{x, y + scale}};
  }
  return queries;
}

/// Cocircular but for the last bit of one coordinate, at coordinates that are not small integers.
std::vector<Query> nearQueries() {
  std::vector<Query> queries = gridQueries(0.1);
  for (std::size_t i = 0; i < queries.size(); ++i)
    queries[i][3].x = std::nextafter(queries[i][3].x, i % 2 == 0 ? 9.0 : -9.0);
  return queries;
}

void inCircle(benchmark::State& bench, const std::vector<Query>& queries) {
  std::size_t i = 0;
  for (auto _ : bench) {
    const Query& q = queries[i++ % kQueries];
    benchmark::DoNotOptimize(incircle(q[0], q[1], q[2], q[3]));
  }
}
BENCHMARK_CAPTURE(inCircle, random, randomQueries());
BENCHMARK_CAPTURE(inCircle, cocircular_grid, gridQueries(1.0));
BENCHMARK_CAPTURE(inCircle, nearly_cocircular, nearQueries());

void orientation(benchmark::State& bench, const std::vector<Query>& queries) {
  std::size_t i = 0;
  for (auto _ : bench) {
    const Query& q = queries[i++ % kQueries];
    benchmark::DoNotOptimize(orient2d(q[0], q[1], q[2]));
  }
}
BENCHMARK_CAPTURE(orientation, random, randomQueries());

}  // namespace
}  // namespace triscope::bench
