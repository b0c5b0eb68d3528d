#include "core/mesh/embedding.h"

#include <fmt/format.h>

#include "core/base/index_text.h"
#include "core/domain/sweep_line.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

bool before(Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// The borders of a mesh as the loops of a domain, for the sweep that also checks domains.
class Borders {
 public:
  explicit Borders(const Mesh& mesh) : mesh_(mesh), leaving_(mesh.points.size()) {
    for (const Half half : halvesOf(mesh)) {
      if (mesh.alive(triangleOf(half)) && !oppositeOf(mesh, half).exists()) leaving_[startOf(mesh, half)] = half;
    }
    for (const Half half : halvesOf(mesh)) {
      if (mesh.alive(triangleOf(half)) && !oppositeOf(mesh, half).exists() && leaving_[startOf(mesh, half)] == half)
        follow(half);
    }
  }

  [[nodiscard]] std::optional<Violation> check() const {
    const SweepLineResult swept = sweepLine(loops_, chords_);
    if (swept.contact) return describe(*swept.contact);
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      const std::int32_t around = swept.enclosing[i];
      const bool ofPart = roleOf(chords_[i].loop) == LoopRole::outer;
      const bool inPart = around >= 0 && roleOf(static_cast<std::uint32_t>(around)) == LoopRole::outer;
      if (ofPart != inPart) continue;
      return violation(halves_[i], chords_[i].a,
                       fmt::format("the border at {} lies inside another part of the mesh: the two overlap", edge(i)));
    }
    return std::nullopt;
  }

 private:
  /// Adds the border that a half-edge belongs to, the mesh on its left, and takes its half-edges off the list.
  void follow(Half first) {
    const auto loop = static_cast<std::uint32_t>(loops_.loops.size());
    const std::size_t begin = chords_.size();
    for (Half half = first; half.exists();) {
      leaving_[startOf(mesh_, half)] = {};
      chords_.push_back(
          {.a = pointOf(mesh_, startOf(mesh_, half)), .b = pointOf(mesh_, endOf(mesh_, half)), .loop = loop});
      halves_.push_back(half);
      half = leaving_[endOf(mesh_, half)];
    }
    // Counter-clockwise at its leftmost point: it runs round a part; else round a hole.
    std::size_t left = begin;
    for (std::size_t i = begin; i < chords_.size(); ++i) {
      if (before(chords_[i].a, chords_[left].a)) left = i;
    }
    const Point previous = chords_[left == begin ? chords_.size() - 1 : left - 1].a;
    const bool ofPart = orient2d(previous, chords_[left].a, chords_[left].b) > 0;
    loops_.loops.push_back({.name = {}, .role = ofPart ? LoopRole::outer : LoopRole::hole});
  }

  [[nodiscard]] LoopRole roleOf(std::uint32_t loop) const { return loops_.loops[loop].role; }
  [[nodiscard]] std::string edge(std::size_t chord) const {
    return fmt::format("edge {}-{}", startOf(mesh_, halves_[chord]), endOf(mesh_, halves_[chord]));
  }
  [[nodiscard]] static Violation violation(Half half, Point place, std::string message) {
    return {Broken::overlap, triangleOf(half), {}, place, std::move(message)};
  }

  [[nodiscard]] Violation describe(const Contact& contact) const {
    const std::string first = edge(contact.first), second = edge(contact.second);
    switch (contact.kind) {
      case ContactKind::crossing:
        return violation(halves_[contact.first], contact.at,
                         fmt::format("border {} crosses border {}: the mesh overlaps itself", first, second));
      case ContactKind::point_on_edge:
        return violation(halves_[contact.first], contact.at,
                         fmt::format("an end of border {} lies on border {}", first, second));
      case ContactKind::overlap:
        return violation(halves_[contact.first], contact.at,
                         fmt::format("border {} runs along border {}", first, second));
      case ContactKind::shared_point:
        break;
    }
    return violation(halves_[contact.first], contact.at,
                     fmt::format("border {} touches border {} in a point", first, second));
  }

  const Mesh& mesh_;
  Per<Vertex, Half> leaving_;  // the border half-edge that starts there, none when there is none or it is followed
  Domain loops_;               // names and curves empty
  std::vector<Chord> chords_;
  std::vector<Half> halves_;  // per chord
};

}  // namespace

std::optional<Violation> findOverlap(const Mesh& mesh) { return Borders(mesh).check(); }

}  // namespace triscope
