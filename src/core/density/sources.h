// Where the density comes from: the user's wishes, curvature, corners, gaps and short input edges
// (paper, section 2: "three cells, each containing one extreme point, where the curvature is large").
#pragma once

#include <functional>
#include <optional>

#include "core/density/constraint.h"
#include "core/domain/domain.h"
#include "core/words/settings.h"

namespace triscope {

/// Edge length that the user asks for; `minEdge` is Δx, which ranks are multiples of.
double lengthWanted(const DensityRequest& request, double minEdge);
/// Of a request at a point or in a box: the part within the domain's bounds that it holds in.
Box boxOf(const DensityRequest& request, const Domain& domain);
/// Where a constraint holds: its place, or the box of the request that it came from.
Box reachOf(const Constraint& constraint, const Domain& domain);
/// Pieces between the wishes along a curve: at most two lengths each, so that no cell of that density is missed.
std::uint32_t samplesAlong(const Curve& curve, double length);

/// The request along a loop that takes the most boundary edges, each of which has a triangle of its own.
struct LoopDemand {
  double triangles = 0.0;  // at least; 0 when there is no such request
  Constraint constraint;   // one that comes of it
};
LoopDemand greediestAlong(const Domain& domain, double minEdge);

/// Edge length of density rank 1: Δx, or where kept input edges are shorter than that, Δx halved until it is no
/// more than a third above the shortest of them (the density cannot forbid what the input fixes).
double finestLength(const Domain& domain, double minEdge);

/// Told now and then how far a search is, from 0 to 1; false gives it up.
using SearchNews = std::function<bool(double fraction)>;

/// Δx for a domain that gives none: the finest length that its curvature, gaps or input edges ask for, and at most
/// 1/40 of its extent. Nothing when it was given up.
std::optional<double> deriveMinEdge(const Domain& domain, const Settings& settings, const SearchNews& goesOn = {});

}  // namespace triscope
