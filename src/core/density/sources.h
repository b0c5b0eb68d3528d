// Where the density comes from: the user's wishes, curvature, corners, gaps and short input edges
// (paper, section 2: "three cells, each containing one extreme point, where the curvature is large").
#pragma once

#include <vector>

#include "core/density/constraint.h"
#include "core/domain/domain.h"
#include "core/settings.h"

namespace triscope {

/// Every constraint of the domain, source by source and curve by curve. Lengths are at least minEdge,
/// but for short_edge.
std::vector<Constraint> findConstraints(const Domain& domain, const Settings& settings, double minEdge);

/// Edge length that the user asks for; `minEdge` is Δx, which ranks are multiples of.
double lengthWanted(const DensityRequest& request, double minEdge);

/// Edge length of density rank 1: Δx, or where kept input edges are shorter than that, Δx halved until it is no
/// more than a third above the shortest of them (the density cannot forbid what the input fixes).
double finestLength(const Domain& domain, double minEdge);

/// Δx for a domain that gives none: the finest length that its curvature, gaps or input edges ask for, and at most
/// 1/40 of its extent.
double deriveMinEdge(const Domain& domain, const Settings& settings);

}  // namespace triscope
