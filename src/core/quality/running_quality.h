// The worst measures of a mesh kept up to date while it changes, a few triangles at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

enum class Measure : std::uint8_t { aspect, area_ratio, edge_ratio, min_angle, max_angle };
inline constexpr int kMeasureCount = 5;

/// A triangle's own value of each measure; area_ratio is its larger ratio with a neighbour it shares an edge with.
using MeasureValues = std::array<double, kMeasureCount>;
MeasureValues measuresOf(const Mesh& mesh, Slot slot);

/// Tournaments over the slots: an update costs the logarithm of the number of slots, the worst is at the top.
class RunningQuality {
 public:
  /// Measures everything afresh.
  void reset(const Mesh& mesh);
  /// Measures the given slots and their neighbours again. Slots may repeat, and be dead.
  void update(const Mesh& mesh, const std::vector<Slot>& slots);

  /// Worst value in the mesh: largest, or smallest for min_angle. 0 (180 for min_angle) for an empty mesh.
  [[nodiscard]] double worst(Measure measure) const;
  /// A slot that has it, the lowest where several do; none for an empty mesh.
  [[nodiscard]] Slot worstSlot(Measure measure) const;
  [[nodiscard]] std::size_t obtuse() const { return obtuse_; }
  [[nodiscard]] std::size_t triangles() const { return triangles_; }

 private:
  void measure(const Mesh& mesh, Slot slot);
  void set(std::size_t measure, Slot slot, double value);
  void grow(std::size_t slots);

  // Per measure a complete binary tree in heap order: leaf s at capacity_ + s; "worse is larger" (min_angle negated).
  std::array<std::vector<double>, kMeasureCount> trees_;
  std::size_t capacity_ = 0;
  Per<Slot, std::uint8_t> obtuseAt_;  // 1 obtuse, 2 alive
  Per<Slot, std::uint32_t> stamp_;    // the update that measured it last
  std::uint32_t update_ = 0;
  std::size_t obtuse_ = 0;
  std::size_t triangles_ = 0;
};

}  // namespace triscope
