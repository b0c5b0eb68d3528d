#include "support/random_domains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/geometry/trig.h"
#include "support/segment.h"

namespace triscope::support {
namespace {

constexpr double kSharpest = 62.0;  // degrees

struct Writer {
  const SizeAndPlace& placement;

  [[nodiscard]] std::string point(Point p) const {
    const Point q = placement.scale * p + placement.by;
    return fmt::format("[{}, {}]", q.x, q.y);
  }
  [[nodiscard]] std::string run(const std::vector<Point>& points) const {
    std::string text;
    for (const Point p : points) text += (text.empty() ? "" : ", ") + point(p);
    return "[" + text + "]";
  }
  [[nodiscard]] std::string circle(Point centre, double radius) const {
    return fmt::format(R"({{"kind": "circle", "centre": {}, "radius": {}}})", point(centre), placement.scale * radius);
  }
};

Point onCircle(Point centre, double radius, double radians) {
  const trig::SinCos direction = trig::sinCos(radians);
  return centre + radius * Point{direction.cos, direction.sin};
}

// Smallest angle on either side of a corner, in degrees.
double sharpest(const std::vector<Point>& polygon) {
  double least = 180.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point before = polygon[(k + polygon.size() - 1) % polygon.size()] - polygon[k];
    const Point after = polygon[(k + 1) % polygon.size()] - polygon[k];
    least = std::min(least, std::fabs(trig::angleBetween(after, before)) / trig::kDegree);
  }
  return least;
}

std::vector<Point> star(Random& random) {
  for (;;) {
    const std::size_t n = 3 + random.below(10);
    std::vector<Point> points;
    for (std::size_t k = 0; k < n; ++k) {
      const double turn = (static_cast<double>(k) + random.between(-0.35, 0.35)) / static_cast<double>(n);
      points.push_back(onCircle({0, 0}, random.between(1.5, 4.0), 2.0 * trig::kPi * turn));
    }
    if (sharpest(points) > kSharpest) return points;
  }
}

std::string round(Random& random, const Writer& write) {
  struct Disc {
    Point centre;
    double radius;
  };
  std::vector<Disc> holes;
  const std::size_t wanted = random.below(4);
  for (int tries = 0; tries < 200 && holes.size() < wanted; ++tries) {
    const Disc disc{{random.between(-3, 3), random.between(-3, 3)}, random.between(0.2, 2.0)};
    const double gap = random.between(0.03, 0.5);
    bool fits = length(disc.centre) + disc.radius + gap < 4.0;
    for (const Disc& other : holes) {
      fits = fits && distance(disc.centre, other.centre) > disc.radius + other.radius + gap;
    }
    if (fits) holes.push_back(disc);
  }
  std::string text = R"("outer": )" + write.circle({0, 0}, 4.0) + R"(, "holes": [)";
  for (std::size_t k = 0; k < holes.size(); ++k) {
    text += (k > 0 ? ", " : "") + write.circle(holes[k].centre, holes[k].radius);
  }
  return text + "]";
}

std::string perforated(Random& random, const Writer& write) {
  const double width = random.between(3, 6), height = random.between(2, 4);
  std::string text = R"("outer": )" + write.run({{0, 0}, {width, 0}, {width, height}, {0, height}}) + R"(, "holes": [)";
  const std::size_t columns = 1 + random.below(3), rows = 1 + random.below(2);
  const double cell = std::min(width / static_cast<double>(columns), height / static_cast<double>(rows));
  bool first = true;
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      if (random.below(4) == 0) continue;
      const double radius = cell * random.between(0.1, 0.35);
      const double free = 0.45 * cell - radius;
      const Point centre{
          (static_cast<double>(i) + 0.5) * width / static_cast<double>(columns) + random.between(-free, free),
          (static_cast<double>(j) + 0.5) * height / static_cast<double>(rows) + random.between(-free, free)};
      std::vector<Point> corners;
      const std::size_t n = 3 + random.below(5);
      const double turn = random.between(0, 2.0 * trig::kPi);
      for (std::size_t k = 0; k < n; ++k) {
        corners.push_back(
            onCircle(centre, radius, turn + 2.0 * trig::kPi * static_cast<double>(k) / static_cast<double>(n)));
      }
      text += (first ? "" : ", ") + (random.below(2) == 0 ? write.circle(centre, radius) : write.run(corners));
      first = false;
    }
  }
  return text + "]";
}

std::string cracked(Random& random, const Writer& write) {
  const std::vector<Point> outer = star(random);
  std::vector<std::vector<Point>> chains;
  const auto clear = [&](Point a, Point b, double room) {
    for (int k = 0; k <= 50; ++k) {
      const Point p = a + (k / 50.0) * (b - a);
      for (std::size_t i = 0; i < outer.size(); ++i) {
        if (distanceToSegment(p, outer[i], outer[(i + 1) % outer.size()]) < room) return false;
      }
      for (const auto& chain : chains) {
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
          if (distanceToSegment(p, chain[i], chain[i + 1]) < room) return false;
        }
      }
    }
    return true;
  };
  for (int tries = 0; tries < 50 && chains.size() < 2; ++tries) {
    // Within a disc that no side of the star cuts, a chain of up to three bends of less than 100°.
    double heading = random.between(0, 2.0 * trig::kPi);
    std::vector<Point> chain{onCircle({0, 0}, random.between(0.0, 0.8), random.between(0, 2.0 * trig::kPi))};
    const std::size_t pieces = 1 + random.below(3);
    for (std::size_t k = 0; k < pieces; ++k) {
      const Point next = onCircle(chain.back(), random.between(0.2, 0.6), heading);
      if (!clear(chain.back(), next, 0.15)) break;
      chain.push_back(next);
      heading += random.between(-100.0, 100.0) * trig::kDegree;
    }
    if (chain.size() >= 2 && length(chain.back()) < 1.2) chains.push_back(chain);
  }
  std::string text = R"("outer": )" + write.run(outer) + R"(, "segments": [)";
  for (std::size_t k = 0; k < chains.size(); ++k) text += (k > 0 ? ", " : "") + write.run(chains[k]);
  return text + "]";
}

}  // namespace

std::string randomDomain(Random& random, Shape shape, const SizeAndPlace& placement) {
  const Writer write{placement};
  std::string text;
  switch (shape) {
    case Shape::star:
      text = R"("outer": )" + write.run(star(random));
      break;
    case Shape::round:
      text = round(random, write);
      break;
    case Shape::perforated:
      text = perforated(random, write);
      break;
    case Shape::cracked:
      text = cracked(random, write);
      break;
  }
  const bool given = random.below(2) == 0;
  const double minEdge = placement.scale * random.between(0.03, 0.15);
  return given ? fmt::format(R"({{"min_edge_length": {}, {}}})", minEdge, text) : "{" + text + "}";
}

SizeAndPlace randomSizeAndPlace(Random& random) {
  constexpr std::array scales = {1e-9, 1e-3, 1.0, 1.0, 1e3, 1e7};
  const SizeAndPlace about{scales[random.below(scales.size())], {}};
  if (about.scale != 1.0 || random.below(2) == 0) return about;
  return {1.0, {random.between(-4e7, 4e7), random.between(-4e7, 4e7)}};
}

}  // namespace triscope::support
