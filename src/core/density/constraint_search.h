// The search for constraints as a value: it knows where among the sources, requests and curves it is, and can be
// stopped and carried on between any two looks.
#pragma once

#include <cstdint>
#include <vector>

#include "core/density/boundary_tree.h"
#include "core/density/constraint.h"
#include "core/domain/domain.h"
#include "core/words/settings.h"

namespace triscope {

struct ConstraintSearch {
  enum class Part : std::uint8_t { requests, corners, curvature, short_edges, gaps, gaps_at_corners, over };
  Part part = Part::over;
  std::uint32_t index = 0;   // of the request, or of the curve
  std::uint32_t curve = 0;   // of a request along a loop
  std::uint32_t sample = 0;  // on that curve
  double along = 0.0;        // arc length on the curve where the next ray starts
  bool backwards = false;    // on the right of a chain
  double minEdge = 0.0;      // smallest length worth asking for; also the finest sampling
  double extent = 0.0;       // of the domain
  BoundaryTree boundary;     // once gaps are looked for
  std::vector<Constraint> found;
};

/// The search at its first source. `minEdge` is Δx.
ConstraintSearch searchFor(const Domain& domain, double minEdge);
/// A search for what the geometry alone asks for, without requests and corners.
ConstraintSearch geometrySearch(const Domain& domain, double minEdge);

/// Looks at one more place; some ten microseconds in a domain of a thousand curves. False when the search is over.
bool carryOn(ConstraintSearch& search, const Domain& domain, const Settings& settings);

/// How far it is, from 0 to 1.
double fractionOf(const ConstraintSearch& search, const Domain& domain);

}  // namespace triscope
