// The edges of a mesh file by group: a domain may have thousands of loops, and no writer looks at every edge for each.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/io/mesh_file.h"

namespace triscope {

class EdgeGroups {
 public:
  explicit EdgeGroups(const MeshFile& file) : edges_(file.edges), ends_(file.groups.size() + 1, 0) {
    std::ranges::stable_sort(edges_, {}, &MeshFile::Edge::group);
    for (const MeshFile::Edge& edge : edges_) ++ends_[static_cast<std::size_t>(edge.group) + 1];
    for (std::size_t g = 1; g < ends_.size(); ++g) ends_[g] += ends_[g - 1];
  }
  /// In the order of the file.
  [[nodiscard]] std::span<const MeshFile::Edge> of(std::size_t group) const {
    return std::span(edges_).subspan(ends_[group], ends_[group + 1] - ends_[group]);
  }

 private:
  std::vector<MeshFile::Edge> edges_;
  std::vector<std::size_t> ends_;  // of group g - 1
};

}  // namespace triscope
