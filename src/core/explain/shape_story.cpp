#include "core/explain/shape_story.h"

#include <algorithm>
#include <array>

#include "core/quality/quality.h"
#include "core/words/vocabulary.h"

namespace triscope {

std::optional<ShapeStory> shapeStoryOf(Events events, std::size_t birth, const TriangleFacts& facts) {
  const auto mayMove = [&](const Mentioned& mentioned) {
    return std::any_of(facts.corners.begin(), facts.corners.end(), [&](auto v) { return mentioned.vertex.has(v); });
  };
  const auto cornerOf = [&](std::uint32_t vertex) {
    return static_cast<std::size_t>(std::find(facts.corners.begin(), facts.corners.end(), vertex) -
                                    facts.corners.begin());
  };
  std::array<std::optional<Point>, 3> places;
  const auto allPlaced = [&] { return places[0] && places[1] && places[2]; };
  const auto aspect = [&] { return qualityOf(*places[0], *places[1], *places[2]).aspect; };
  const std::size_t end = std::min(facts.death.value_or(events.size()), events.size());
  ShapeStory story;
  for (std::size_t k = events.next(0, mayMove); k < end; k = events.next(k + 1, mayMove)) {
    const Event& e = events.peek(k);
    const std::size_t corner = placesVertex(e) ? cornerOf(e.vertex) : places.size();
    if (corner == places.size()) continue;
    if (k > birth && !allPlaced()) break;
    const double before = k > birth ? aspect() : 0.0;
    places[corner] = e.at;
    if (k > birth)
      story.moves.push_back({k, before, aspect()});
    else if (allPlaced())
      story.atBirth = aspect();
  }
  if (!allPlaced()) return std::nullopt;
  return story;
}

}  // namespace triscope
