#include "core/domain/sweep_line.h"

#include <algorithm>
#include <set>
#include <span>

#include "core/geometry/predicates.h"

namespace triscope {

namespace {

constexpr std::int32_t kUnknown = -2;

/// An end of a chord: the event that starts or finishes it.
struct End {
  Point at;
  std::size_t chord = 0;
  bool isA = false;     // end a of the chord, else b
  bool starts = false;  // the smaller of the two ends
};

/// A chord from left to right.
struct Edge {
  Point lo;
  Point hi;
};

class SweepLine {
 public:
  SweepLine(const Domain& domain, const std::vector<Chord>& chords) : domain_(domain), chords_(chords) {
    edges_.reserve(chords.size());
    for (const Chord& chord : chords) {
      edges_.push_back(leftOf(chord.a, chord.b) ? Edge{chord.a, chord.b} : Edge{chord.b, chord.a});
    }
    places_.resize(chords.size());
    above_.resize(chords.size(), kUnknown);
    enclosing_.resize(chords.size(), kUnknown);
    around_.resize(domain.loops.size(), kUnknown);
  }

  SweepLineResult run() {
    const std::vector<End> ends = sortedEnds();
    for (std::size_t i = 0; i < ends.size() && !contact_;) {
      std::size_t j = i + 1;
      while (j < ends.size() && ends[j].at == ends[i].at) ++j;
      visit({ends.data() + i, ends.data() + j});
      i = j;
    }
    return {contact_, std::move(enclosing_)};
  }

 private:
  /// Bottom to top where the sweep line stands. Chords may be compared with a point that lies on none of them.
  struct Below {
    using is_transparent = void;
    const std::vector<Edge>* edges;
    bool operator()(std::size_t s, std::size_t t) const {
      if (s == t) return false;
      const Edge& e = (*edges)[s];
      const Edge& f = (*edges)[t];
      if (e.lo == f.lo) return orient2d(e.lo, e.hi, f.hi) > 0;
      if (leftOf(e.lo, f.lo)) return orient2d(e.lo, e.hi, f.lo) > 0;
      return orient2d(f.lo, f.hi, e.lo) < 0;
    }
    bool operator()(std::size_t s, Point p) const { return orient2d((*edges)[s].lo, (*edges)[s].hi, p) > 0; }
    bool operator()(Point p, std::size_t s) const { return orient2d((*edges)[s].lo, (*edges)[s].hi, p) < 0; }
  };
  using Status = std::set<std::size_t, Below>;

  [[nodiscard]] const Loop& loopOf(std::size_t chord) const { return domain_.loops[chords_[chord].loop]; }

  [[nodiscard]] std::vector<End> sortedEnds() const {
    std::vector<End> ends;
    ends.reserve(2 * chords_.size());
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      const bool forward = chords_[i].a == edges_[i].lo;
      ends.push_back({chords_[i].a, i, true, forward});
      ends.push_back({chords_[i].b, i, false, !forward});
    }
    std::sort(ends.begin(), ends.end(), [](const End& e, const End& f) {
      if (leftOf(e.at, f.at) || leftOf(f.at, e.at)) return leftOf(e.at, f.at);
      return e.chord != f.chord ? e.chord < f.chord : e.isA && !f.isA;
    });
    return ends;
  }

  void visit(std::span<const End> ends) {
    if (!mayMeet(ends)) return;
    const Point p = ends.front().at;
    for (const End& end : ends) {
      if (!end.starts) status_.erase(places_[end.chord]);
    }
    const auto next = status_.lower_bound(p);
    if (next != status_.end() && orient2d(edges_[*next].lo, edges_[*next].hi, p) == 0) {
      contact_ = Contact{ContactKind::point_on_edge, ends.front().chord, *next, p};
      return;
    }

    std::vector<std::size_t>& starting = starting_;
    starting.clear();
    for (const End& end : ends) {
      if (end.starts) starting.push_back(end.chord);
    }
    std::sort(starting.begin(), starting.end(), [&](std::size_t s, std::size_t t) {
      const int turn = orient2d(p, edges_[s].hi, edges_[t].hi);
      return turn != 0 ? turn > 0 : s < t;
    });
    for (std::size_t i = 1; i < starting.size(); ++i) {
      if (orient2d(p, edges_[starting[i - 1]].hi, edges_[starting[i]].hi) == 0) {
        contact_ = Contact{ContactKind::overlap, starting[i - 1], starting[i], p};
        return;
      }
    }

    const bool hasPrevious = next != status_.begin();
    const std::size_t previous = hasPrevious ? *std::prev(next) : 0;
    std::int32_t region = hasPrevious ? above_[previous] : -1;
    for (const std::size_t chord : starting) {
      region = enter(chord, region);
      places_[chord] = status_.emplace_hint(next, chord);
    }
    if (starting.empty()) {
      if (hasPrevious && next != status_.end()) checkCrossing(previous, *next);
      return;
    }
    if (hasPrevious) checkCrossing(previous, starting.front());
    if (next != status_.end()) checkCrossing(starting.back(), *next);
  }

  /// Notes what a chord that starts above `region` lies in; gives the region above it.
  std::int32_t enter(std::size_t chord, std::int32_t region) {
    const Chord& piece = chords_[chord];
    const LoopRole role = loopOf(chord).role;
    if (role == LoopRole::chain) {
      enclosing_[chord] = region;
      return above_[chord] = region;
    }
    std::int32_t& around = around_[piece.loop];
    if (around == kUnknown) around = region;
    enclosing_[chord] = around;
    const bool forward = piece.a == edges_[chord].lo;
    const bool insideAbove = forward == (role == LoopRole::outer);
    return above_[chord] = insideAbove ? static_cast<std::int32_t>(piece.loop) : around;
  }

  /// Are the chords that end in one point allowed to?
  bool mayMeet(std::span<const End> ends) {
    const auto meet = [&](const End& e, const End& f) {
      contact_ = Contact{ContactKind::shared_point, e.chord, f.chord, e.at};
      return false;
    };
    const End* loop = nullptr;     // the first end that belongs to a loop …
    const End* leaving = nullptr;  // … and the first chord of it that leaves the point
    bool sameRun = true;
    for (const End& end : ends) {
      sameRun = sameRun && chords_[end.chord].loop == chords_[ends.front().chord].loop;
      if (loopOf(end.chord).role == LoopRole::chain) continue;
      if (loop == nullptr) loop = &end;
      if (chords_[end.chord].loop != chords_[loop->chord].loop) return meet(*loop, end);
      if (!end.isA) continue;
      if (leaving != nullptr) return meet(*leaving, end);
      leaving = &end;
    }
    if (sameRun && ends.size() <= 2) return true;
    for (const End& end : ends) {
      const Chord& chord = chords_[end.chord];
      const bool kept = end.isA ? chord.t0 == 0.0 : chord.t1 == 1.0;
      if (kept) continue;
      for (const End& other : ends) {
        if (chords_[other.chord].curve != chord.curve) return meet(end, other);
      }
      return meet(end, &end == &ends.front() ? ends.back() : ends.front());
    }
    return true;
  }

  void checkCrossing(std::size_t s, std::size_t t) {
    const Edge& e = edges_[s];
    const Edge& f = edges_[t];
    const int fLo = orient2d(e.lo, e.hi, f.lo);
    const int fHi = orient2d(e.lo, e.hi, f.hi);
    const int eLo = orient2d(f.lo, f.hi, e.lo);
    const int eHi = orient2d(f.lo, f.hi, e.hi);
    if (fLo * fHi >= 0 || eLo * eHi >= 0) return;  // an end on the other chord is found when the sweep gets there
    const Point along = e.hi - e.lo;
    const Point across = f.hi - f.lo;
    const double share = cross(f.lo - e.lo, across) / cross(along, across);
    contact_ = Contact{ContactKind::crossing, std::min(s, t), std::max(s, t), e.lo + share * along};
  }

  const Domain& domain_;
  const std::vector<Chord>& chords_;
  std::vector<Edge> edges_;
  Status status_{Below{&edges_}};
  std::vector<Status::iterator> places_;
  std::vector<std::int32_t> above_;      // per chord in the status: the innermost loop around the region above it
  std::vector<std::int32_t> enclosing_;  // per chord
  std::vector<std::int32_t> around_;     // per loop: the loop around it
  std::vector<std::size_t> starting_;
  std::optional<Contact> contact_;
};

}  // namespace

SweepLineResult sweepLine(const Domain& domain, const std::vector<Chord>& chords) {
  return SweepLine(domain, chords).run();
}

}  // namespace triscope
