// One pass of a vertical line over the chords of a domain, left to right, in O(n log n): finds the first place where
// two of them meet that must not, and which loop encloses which. All decisions are signs of exact orientations
// (M. I. Shamos and D. Hoey, "Geometric Intersection Problems", FOCS 1976).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/domain/domain.h"
#include "core/domain/outline.h"

namespace triscope {

enum class ContactKind : std::uint8_t {
  crossing,       // the insides of both chords meet in one point
  point_on_edge,  // an end of the first chord lies inside the second
  overlap,        // both leave the place in the same direction
  shared_point,   // both have an end there, and it is not a point where they may be joined
};

struct Contact {
  ContactKind kind = ContactKind::crossing;
  std::size_t first = 0;   // index of a chord; for a shared point of one loop both are the chords that leave it
  std::size_t second = 0;  // index of the other chord
  Point at;                // exact, except for a crossing
};

struct SweepLineResult {
  std::optional<Contact> contact;
  /// Per chord: the loop directly around it (for a chord of a loop: around that loop), -1 when there is none.
  /// Complete only without a contact.
  std::vector<std::int32_t> enclosing;
};

/// Loops of the domain must be oriented, chords have length. Chains may share points with loops and with one
/// another where all of them have kept points (ends of curves); nothing else may meet.
SweepLineResult sweepLine(const Domain& domain, const std::vector<Chord>& chords);

}  // namespace triscope
