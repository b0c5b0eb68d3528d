#include "core/event.h"

#include <array>

namespace triscope {
namespace {

struct Words {
  std::string_view name;
  std::string_view description;
};

/// In the order of EventKind.
constexpr std::array kKindNames = std::to_array<std::string_view>({
    "stage begun",
    "constraint found",
    "cell split",
    "cell ranked",
    "boundary point",
    "vertex inserted",
    "vertex refused",
    "edge split",
    "vertex removed",
    "triangle removed",
    "edge flipped",
    "vertex moved",
    "vertex kept",
    "stage finished",
    "failure",
});
static_assert(kKindNames.size() == static_cast<std::size_t>(EventKind::failure) + 1);

/// In the order of Rule. The descriptions of steps 1-5 state what was found true of the measured value.
constexpr std::array kRules = std::to_array<Words>({
    {"none", ""},
    {"user request", "the domain file asks for this edge length here"},
    {"curvature", "one edge may turn only so far on this curve"},
    {"corner", "the boundary has a sharp corner here"},
    {"gap", "two pieces of the boundary face each other across a narrow gap"},
    {"short edge", "an edge of the input is this long"},
    {"balance", "neighbouring cells may differ by one cell rank only"},
    {"advancing front", "the density may grow by one rank from a cell to its neighbour"},
    {"boundary point", "every boundary edge spans the same part of the density's integral"},
    {"initial triangulation", "the boundary points are joined by Bowyer-Watson"},
    {"edge recovery", "a boundary edge is missing from the triangulation"},
    {"carve", "the triangle lies outside the domain"},
    {"first front", "a spoke from a boundary vertex, or two that meet over an edge"},
    {"second front", "a spoke from a vertex of the first front, or two that meet over an edge"},
    {"step 1", "circumradius R not below the edge length h wanted at the circumcentre"},
    {"step 2", "circumradius R not below the smallest edge length h wanted at the corners"},
    {"step 3", "circumradius R not below the shortest edge e"},
    {"step 4", "circumradius R not below the shortest edge e of an adjacent triangle"},
    {"step 5", "the neighbour's apex is not nearer to the shared edge's midpoint than e + height"},
    {"boundary split", "the point would have come too near to a boundary edge, so that edge was split"},
    {"repair", "a refusal left a triangle beyond the bounds"},
    {"Laplacian filter", "moved toward the mean of its neighbours as far as many passes by the factor omega would"},
    {"obtuse angle", "the sides of an obtuse angle turned toward each other by theta"},
    {"shared edge", "the edge between unequal triangles moved into the larger one by a tenth of its height"},
    {"polish",
     "one of the places around the vertex where the worst of its triangles is less near the worst of the mesh"},
    {"Delaunay flip", "the vertex across the edge lies inside the circumcircle"},
});
static_assert(kRules.size() == static_cast<std::size_t>(kRuleCount));

/// In the order of Refusal.
constexpr std::array kRefusals = std::to_array<Words>({
    {"none", ""},
    {"outside the domain", "the point does not lie in the domain"},
    {"too close", "the point is nearer to another vertex than allowed"},
    {"encroaches on the boundary", "the point sees a boundary edge under too wide an angle"},
    {"edge below minimum", "an edge would become shorter than the smallest edge allowed"},
    {"inverts a triangle", "a triangle would turn over"},
    {"star gets worse", "the triangles around the vertex would be worse than before"},
    {"breaks a bound", "a bound on aspect, area ratio, edge ratio or angle would no longer hold"},
    {"budget spent", "the stage has used up the steps it is allowed"},
    {"too many triangles", "the mesh would have more triangles than max_triangles allows"},
});
static_assert(kRefusals.size() == static_cast<std::size_t>(kRefusalCount));

template <class Table, class Enum>
auto entry(const Table& table, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < table.size() ? table[index] : typename Table::value_type{};
}

}  // namespace

bool placesVertex(const Event& event) {
  return event.vertex != kNoId && (event.kind == EventKind::vertex_inserted || event.kind == EventKind::edge_split ||
                                   event.kind == EventKind::vertex_moved);
}

std::string_view name(EventKind kind) { return entry(kKindNames, kind); }
std::string_view name(Rule rule) { return entry(kRules, rule).name; }
std::string_view describe(Rule rule) { return entry(kRules, rule).description; }
std::string_view name(Refusal refusal) { return entry(kRefusals, refusal).name; }
std::string_view describe(Refusal refusal) { return entry(kRefusals, refusal).description; }

}  // namespace triscope
