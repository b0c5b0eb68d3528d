#include "core/method/triangle_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/number.h"
#include "core/density/forecast.h"
#include "core/density/request_text.h"
#include "core/density/sources.h"
#include "core/domain/loop_of.h"
#include "core/method/estimate.h"
#include "core/method/pipeline.h"
#include "core/method/stages/stage_runs.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// Before cells are classified every leaf says `outside`.
bool classified(const Quadtree& tree) {
  return std::ranges::any_of(tree.cells, [](const Cell& c) { return c.child < 0 && c.type != CellType::outside; });
}

std::string nameOf(const Domain& domain, Rule source, std::uint32_t index) {
  if (source == Rule::user_request) return requestName(domain, index);
  return fmt::format(fmt::runtime(wordsOf(source).demand), loopOf(domain, index).name);
}

/// Wishes with one name, and the triangles in the leaves that they are the finest in.
struct Group {
  double triangles = 0.0;
  double finest = 1e300;
  Rule source = Rule::none;
  std::uint32_t curve = kNoId;
  Point at;
};

std::size_t groupOf(const Domain& domain, const Constraint& constraint) {
  if (constraint.source == Rule::user_request) return constraint.curve;
  const auto loop = static_cast<std::size_t>(&loopOf(domain, constraint.curve) - domain.loops.data());
  return domain.density.size() + loop * kRuleCount + static_cast<std::size_t>(constraint.source);
}

/// Whether the density of an input asks for no more than its limit.
bool staysBelow(std::shared_ptr<const Domain> domain, const Settings& settings) {
  Result<MeshState> state = begin(std::move(domain), settings);
  if (!state.ok()) return false;
  Journal nobody;
  advanceUntil(*state, Stage::density, ~std::uint64_t{0}, nobody);
  return !state->failed;
}

/// The first of some lengths from about where it should do.
template <class Does>
std::optional<double> firstBelow(const MeshState& stopped, double length, const Does& does) {
  constexpr int kTries = 12;
  constexpr double kStep = 1.15;
  if (!stopped.mesh.triangles.empty()) return std::nullopt;  // the density was not what asked for too many
  // Triangles go with the square of the length, but not quite: a tree that was given up early says little of the whole,
  // and ranks are steps.
  length *= 1.05 * std::sqrt(std::max(1.0, stopped.estimatedTriangles / stopped.settings.maxTriangles));
  for (int k = 0; k < kTries; ++k, length *= kStep) {
    length = roundedUp(length);
    if (does(length)) return length;
  }
  return std::nullopt;
}

}  // namespace

bool overLimit(const MeshState& state) {
  return state.failed && state.estimatedTriangles > state.settings.maxTriangles;
}

void holdToLimit(MeshState& state, double triangles, Journal& journal) {
  const double most = state.settings.maxTriangles;
  if (triangles <= most) return;
  state.estimatedTriangles = triangles;
  state.failed = true;
  if (!journal.listening()) return;
  const Asker asker = askerOf(state);
  Event event = eventIn(state, EventKind::failure, asker.source);
  event.refusal = Refusal::too_many_triangles;
  event.other = asker.curve;
  event.measured = triangles;
  event.limit = most;
  event.at = asker.at;
  journal.record(event);
}

std::optional<double> minEdgeBelowLimit(const MeshState& stopped, const Asker& asker) {
  // Below what is asked for, Δx changes nothing.
  return firstBelow(stopped, std::max(stopped.minEdge, asker.length), [&](double length) {
    Settings settings = stopped.settings;
    settings.minEdge = length;
    return staysBelow(stopped.domain, settings);
  });
}

std::optional<double> lengthBelowLimit(const MeshState& stopped, const Asker& asker) {
  if (asker.source != Rule::user_request) return minEdgeBelowLimit(stopped, asker);
  return firstBelow(stopped, asker.length, [&](double length) {
    auto changed = std::make_shared<Domain>(*stopped.domain);
    changed->density[asker.curve].length = length;
    changed->density[asker.curve].rank = 0;
    return staysBelow(std::move(changed), stopped.settings);
  });
}

Asker askerOf(const MeshState& state) {
  const Domain& domain = *state.domain;
  const bool types = classified(state.tree);
  const Quadtree& tree = state.tree;
  std::vector<std::uint8_t> ranks = forecastOf(tree, domain, state.settings, state.minEdge);
  const std::size_t byRank = domain.density.size() + domain.loops.size() * kRuleCount;
  std::vector<Group> groups(byRank + 1);
  groups[byRank].at = midpoint(domain.bounds.lo, domain.bounds.hi);
  constexpr std::size_t kNobody = ~std::size_t{0};
  std::vector<std::size_t> owner(tree.cells.size(), kNobody);
  std::vector<std::int32_t> leaves;
  for (const Constraint& constraint : state.constraints) {
    Group& group = groups[groupOf(domain, constraint)];
    if (constraint.length < group.finest) {
      group.finest = constraint.length;
      group.source = constraint.source;
      group.curve = constraint.curve;
      group.at = constraint.at;
    }
    const int rank = rankAtMost(constraint.length * tree.minEdgeInverse * (1.0 + 1e-12));
    leavesIn(tree, latticeBoxOf(tree, reachOf(constraint, domain)), leaves);
    for (const std::int32_t leaf : leaves) {
      std::uint8_t& ranked = ranks[static_cast<std::size_t>(leaf)];
      if (rank > ranked) continue;
      ranked = static_cast<std::uint8_t>(rank);
      owner[static_cast<std::size_t>(leaf)] = static_cast<std::size_t>(&group - groups.data());
    }
  }
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    const Cell& cell = tree.cells[k];
    if (cell.child >= 0 || (types && cell.type == CellType::outside)) continue;
    std::size_t group = owner[k];
    if (group == kNobody && ranks[k] == state.settings.maxRank) group = byRank;
    if (group != kNobody) groups[group].triangles += trianglesInCell(cell.rank, ranks[k]);
  }
  const Group& most = *std::ranges::max_element(groups, {}, &Group::triangles);
  if (most.curve == kNoId)
    return {Rule::none, kNoId, edgeLengthOf(state.tree, state.settings.maxRank), groups[byRank].at,
            fmt::format("the setting max_rank = {}", state.settings.maxRank)};
  return {most.source, most.curve, most.finest, most.at, nameOf(domain, most.source, most.curve)};
}

std::string adviceFor(const Asker& asker, std::optional<double> length) {
  constexpr std::string_view kOr = "or raise max_triangles";
  if (!length) return fmt::format("simplify the domain, {}", kOr);
  if (asker.source == Rule::user_request)
    return fmt::format("ask for edges of {} or longer there, {}", compact(*length), kOr);
  const std::string_view eased = asker.source == Rule::none ? "max_rank" : wordsOf(asker.source).eased;
  return fmt::format("give a min_edge_length of {} or more, {}{}", compact(*length),
                     eased.empty() ? "" : fmt::format("or a larger {}, ", eased), kOr);
}

Error tooManyTriangles(const MeshState& state) {
  const Estimate estimate = estimateOf(state);
  const Asker asker = askerOf(state);
  // A tree that outgrows the limit is given up before its cells are classified.
  const std::string size =
      !state.mesh.triangles.empty()
          ? fmt::format("more than {} triangles, because of edges that it has to keep", roughCount(estimate.triangles))
      : classified(state.tree)
          ? fmt::format("about {} triangles by the estimate of Table 1", roughCount(estimate.triangles))
          : fmt::format("at least {} triangles, or as many cells in its quadtree", roughCount(estimate.triangles));
  return {.message = fmt::format(
              "the mesh would have {}, and take {} of memory, but max_triangles is {}; most are asked "
              "for by {}, for edges of length {}",
              size, bytesText(estimate.bytes), state.settings.maxTriangles, asker.name, compact(asker.length)),
          .hint = adviceFor(asker, lengthBelowLimit(state, asker)),
          .file = state.domain->file,
          .at = asker.at};
}

}  // namespace triscope
