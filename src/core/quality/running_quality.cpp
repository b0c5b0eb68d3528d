#include "core/quality/running_quality.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/edit.h"
#include "core/quality/quality.h"

namespace triscope {
namespace {

constexpr double kNone = -1e308;  // a slot without a triangle

double sign(std::size_t measure) { return measure == static_cast<std::size_t>(Measure::min_angle) ? -1.0 : 1.0; }

}  // namespace

MeasureValues measuresOf(const Mesh& mesh, Slot slot) {
  const TriangleQuality q = qualityOf(mesh, slot);
  double ratio = 1.0;  // of a triangle without neighbours
  const double own = std::fabs(twiceArea(mesh, slot));
  for (const Half across : triangleAt(mesh, slot).adj) {
    if (!across.exists() || touchesHelper(mesh, triangleOf(across))) continue;
    const double other = std::fabs(twiceArea(mesh, triangleOf(across)));
    ratio = std::max(ratio, std::max(own, other) / std::min(own, other));
  }
  return {q.aspect, ratio, q.edgeRatio, q.minAngle, q.maxAngle};
}

void RunningQuality::grow(std::size_t slots) {
  if (slots <= capacity_) return;
  std::size_t capacity = std::max<std::size_t>(capacity_, 64);
  while (capacity < slots) capacity *= 2;
  for (std::vector<double>& tree : trees_) {
    std::vector<double> wider(2 * capacity, kNone);
    std::copy_n(tree.begin() + static_cast<std::ptrdiff_t>(capacity_), capacity_,
                wider.begin() + static_cast<std::ptrdiff_t>(capacity));
    for (std::size_t k = capacity - 1; k > 0; --k) wider[k] = std::max(wider[2 * k], wider[2 * k + 1]);
    tree = std::move(wider);
  }
  capacity_ = capacity;
  obtuseAt_.resize(capacity, 0);
  stamp_.resize(capacity, 0);
}

void RunningQuality::set(std::size_t measure, Slot slot, double value) {
  std::vector<double>& tree = trees_[measure];
  std::size_t k = capacity_ + static_cast<std::size_t>(slot.n);
  tree[k] = value;
  while (k > 1) {
    k /= 2;
    const double larger = std::max(tree[2 * k], tree[2 * k + 1]);
    if (tree[k] == larger) break;
    tree[k] = larger;
  }
}

void RunningQuality::measure(const Mesh& mesh, Slot slot) {
  if (stamp_[slot] == update_) return;
  stamp_[slot] = update_;
  std::uint8_t& state = obtuseAt_[slot];
  obtuse_ -= state & 1u;
  triangles_ -= state >> 1u;
  const bool counts = mesh.alive(slot) && !touchesHelper(mesh, slot);
  if (!counts) {
    state = 0;
    for (std::size_t m = 0; m < trees_.size(); ++m) set(m, slot, kNone);
    return;
  }
  const MeasureValues values = measuresOf(mesh, slot);
  for (std::size_t m = 0; m < trees_.size(); ++m) set(m, slot, sign(m) * values[m]);
  const bool obtuse = qualityOf(mesh, slot).obtuse;
  state = obtuse ? 3 : 2;
  obtuse_ += obtuse ? 1 : 0;
  ++triangles_;
}

void RunningQuality::reset(const Mesh& mesh) {
  *this = {};
  grow(mesh.triangles.size());
  ++update_;
  for (const Slot slot : mesh.triangles.keys()) measure(mesh, slot);
}

void RunningQuality::update(const Mesh& mesh, const std::vector<Slot>& slots) {
  grow(mesh.triangles.size());
  ++update_;
  for (const Slot slot : slots) {
    measure(mesh, slot);
    // A dead slot still names the neighbours it had.
    for (const Half across : triangleAt(mesh, slot).adj) {
      if (across.exists()) measure(mesh, triangleOf(across));
    }
  }
}

double RunningQuality::worst(Measure measure) const {
  const auto m = static_cast<std::size_t>(measure);
  if (triangles_ == 0) return measure == Measure::min_angle ? 180.0 : 0.0;
  return sign(m) * trees_[m][1];
}

Slot RunningQuality::worstSlot(Measure measure) const {
  if (triangles_ == 0) return {};
  const std::vector<double>& tree = trees_[static_cast<std::size_t>(measure)];
  std::size_t k = 1;
  while (k < capacity_) k = tree[2 * k] == tree[k] ? 2 * k : 2 * k + 1;
  return Slot(k - capacity_);
}

}  // namespace triscope
