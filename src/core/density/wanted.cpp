#include "core/density/wanted.h"

namespace triscope {

std::optional<Wanted> wantedAt(const Quadtree& tree, Point p) {
  if (tree.cells.empty()) return std::nullopt;
  LeafPath path;
  const std::int32_t leaf = leafAt(tree, p, path);
  const int rank = tree.cells[static_cast<std::size_t>(leaf)].density;
  return Wanted{leaf, rank, edgeLengthAt(tree, p, path)};
}

const Cell* cellOf(const Quadtree& tree, std::int64_t index) {
  if (index < 0 || static_cast<std::uint64_t>(index) >= tree.cells.size()) return nullptr;
  return &tree.cells[static_cast<std::size_t>(index)];
}

}  // namespace triscope
