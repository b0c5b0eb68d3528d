// The edges of a mesh file by group: a domain may have thousands of loops, and no writer looks at every edge for each.
#pragma once

#include <span>
#include <vector>

#include "core/io/mesh_file.h"

namespace triscope {

class EdgeGroups {
 public:
  explicit EdgeGroups(const MeshFile& file) : edges_(file.edges.size()), ends_(file.groups.size() + 1, 0) {
    for (const MeshFile::Edge& edge : file.edges) ++ends_[static_cast<std::size_t>(edge.group) + 1];
    for (std::size_t g = 1; g < ends_.size(); ++g) ends_[g] += ends_[g - 1];
    std::vector<std::size_t> next = ends_;
    for (const MeshFile::Edge& edge : file.edges) edges_[next[static_cast<std::size_t>(edge.group)]++] = edge;
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
