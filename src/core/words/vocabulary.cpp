#include "core/words/vocabulary.h"

#include <array>

namespace triscope {
namespace {

/// In the order of Names.
constexpr std::array kNumbers = std::to_array<NamesWords>({
    {.other = "other"},
    {"triangle", "triangle", "first_triangle", Ref::Kind::triangle},
    {"vertex", "from_vertex", "", Ref::Kind::vertex},
    {"cell", "from_cell", "first_cell", Ref::Kind::cell},
    {"constraint", "constraint", "", {}},
    {"curve", "curve", "", {}},
    {"boundary_edge", "boundary_edge", "", {}},
    {"boundary_point", "boundary_point", "", {}},
    {"changes", "changes", "", {}},
});
static_assert(kNumbers.size() == static_cast<std::size_t>(kNamesCount));

/// In the order of EventKind.
constexpr std::array kKinds = std::to_array<KindWords>({
    {.name = "stage begun", .does = kBounds, .caption = "{stage} begins{in_round}: it {does}."},
    {.name = "constraint found",
     .subject = Names::constraint,
     .other = Names::curve,
     .placed = true,
     .picture = Picture::place,
     .caption = "An edge length of {measured} is wanted at {place}: {why}."},
    {.name = "cell split",
     .subject = Names::cell,
     .other = Names::constraint,
     .created = Names::cell,
     .does = kSplits,
     .picture = Picture::cell,
     .caption = "Cell {subject} was split into four{beside}: {why}."},
    {.name = "cell ranked",
     .subject = Names::cell,
     .other = Names::constraint,
     .picture = Picture::cell,
     .caption = "Cell {subject} took density rank {measured}{instead}{beside}: {why}."},
    {.name = "boundary point",
     .subject = Names::curve,
     .other = Names::boundary_point,
     .placed = true,
     .picture = Picture::place,
     .caption = "Boundary point {other} was placed at {place} on curve {subject}, where edges of h = {measured} are "
                "wanted."},
    {.name = "vertex inserted",
     .subject = Names::triangle,
     .other = Names::triangle,
     .created = Names::triangle,
     .does = kInserts | kProposes,
     .placed = true,
     .picture = Picture::insertion,
     .caption = "{rule} put vertex {vertex} at the circumcentre of {triangle}: {reason}.{effect}",
     .captionOfRule = &RuleWords::inserted},
    {.name = "vertex refused",
     .subject = Names::triangle,
     .other = Names::triangle,
     .does = kProposes | kRefuses,
     .placed = true,
     .picture = Picture::refusal,
     .caption = "{rule} proposed a vertex at {place}{off}, and it was refused: {refusal}.",
     .captionOfRule = &RuleWords::refused},
    {.name = "edge split",
     .subject = Names::boundary_edge,
     .other = Names::triangle,
     .created = Names::triangle,
     .does = kInserts | kSplits | kProposes,
     .placed = true,
     .picture = Picture::insertion,
     .caption = "Boundary edge {subject} was split at vertex {vertex}: {why}.{effect}"},
    {.name = "vertex removed",
     .subject = Names::triangle,
     .created = Names::triangle,
     .does = kRemoves | kProposes,
     .picture = Picture::removal,
     .caption = "Vertex {vertex} was removed: {why}."},
    {.name = "triangle removed",
     .subject = Names::triangle,
     .does = kRemoves,
     .picture = Picture::carved,
     .caption = "Triangle {subject} was removed: {why}."},
    {.name = "vertex moved",
     .subject = Names::triangle,
     .created = Names::triangle,
     .does = kMoves | kProposes,
     .placed = true,
     .from = true,
     .picture = Picture::move,
     .caption = "{rule}: vertex {vertex} moved by {by} to {place}: {why}.{around}"},
    {.name = "vertex kept",
     .subject = Names::triangle,
     .does = kProposes | kRefuses,
     .placed = true,
     .from = true,
     .picture = Picture::refusal,
     .caption = "{rule}: vertex {vertex} stays where it is, because {refusal}."},
    {.name = "stage finished", .subject = Names::changes, .does = kBounds, .caption = "{stage} is over{outcome}."},
    {.name = "failure",
     .subject = Names::boundary_edge,
     .placed = true,
     .picture = Picture::failure,
     .caption = "{stage} cannot go on at {place}{because}."},
    {.name = "edit kept",
     .subject = Names::triangle,
     .created = Names::triangle,
     .does = kProposes,
     .placed = true,
     .picture = Picture::patch,
     .caption = "{rule} around {triangle}: {why}. The penalty of the patch fell from {limit} to {measured}.",
     .captionOfRule = &RuleWords::kept},
    {.name = "edit undone",
     .subject = Names::triangle,
     .does = kProposes | kRefuses,
     .placed = true,
     .picture = Picture::patch,
     .caption = "{rule} around {triangle}, tried and taken back: {refusal}. The penalty of the patch went from {limit} "
                "to {measured}.",
     .captionOfRule = &RuleWords::undone},
});
static_assert(kKinds.size() == static_cast<std::size_t>(kEventKindCount));

constexpr std::string_view kStepRefused =
    "{rule} proposed a vertex at {place} for {triangle}, because {reason}; it was refused: {refused}.";
constexpr std::string_view kRowInserted =
    "{rule} put vertex {vertex} at {place} over the shortest front edge of {triangle}, {measured} long, where edges of "
    "h "
    "= {limit} are wanted: {why}.{effect}";
constexpr std::string_view kRowRefused =
    "{rule} proposed a vertex at {place} over the shortest front edge of {triangle}, and it was refused: {refusal}. "
    "The "
    "triangle is done.";
constexpr std::string_view kFrontInserted = "{rule}: vertex {vertex} was placed at {place}{off}, {why}.{effect}";

/// In the order of Rule.
constexpr std::array kRules = std::to_array<RuleWords>({
    {.name = "none"},
    {.name = "user request", .description = "the domain file asks for this edge length here", .family = Family::source},
    {.name = "curvature",
     .description = "one edge may turn only so far on this curve",
     .family = Family::source,
     .demand = "the curvature of loop '{}'",
     .eased = "curvature_turn"},
    {.name = "corner",
     .description = "the boundary has a sharp corner here",
     .family = Family::source,
     .demand = "the corners of loop '{}'"},
    {.name = "gap",
     .description = "two pieces of the boundary face each other across a narrow gap",
     .family = Family::source,
     .demand = "the gaps beside loop '{}'",
     .eased = "gap_fraction"},
    {.name = "short edge",
     .description = "an edge of the input is this long",
     .family = Family::source,
     .demand = "the short edges of loop '{}'"},
    {.name = "balance",
     .description = "neighbouring cells may differ by one cell rank only",
     .family = Family::neighbour,
     .other = Names::cell},
    {.name = "advancing front",
     .description = "the density may grow by one rank from a cell to its neighbour",
     .family = Family::neighbour,
     .other = Names::cell},
    {.name = "boundary point",
     .description = "every boundary edge spans the same part of the density's integral",
     .family = Family::boundary},
    {.name = "initial triangulation",
     .description = "the boundary points are joined by Bowyer-Watson",
     .family = Family::boundary,
     .other = Names::curve,
     .inserted = "Vertex {vertex}, a boundary point, joined the triangulation.{effect}"},
    {.name = "edge recovery",
     .description = "a boundary edge is missing from the triangulation",
     .family = Family::boundary},
    {.name = "carve", .description = "the triangle lies outside the domain", .family = Family::boundary},
    {.name = "first front",
     .description = "a spoke from a boundary vertex, or two that meet over an edge",
     .family = Family::front,
     .other = Names::vertex,
     .inserted = kFrontInserted},
    {.name = "second front",
     .description = "a spoke from a vertex of the first front, or two that meet over an edge",
     .family = Family::front,
     .other = Names::vertex,
     .inserted = kFrontInserted},
    {.name = "step 1",
     .description = "circumradius R not below the edge length h wanted at the circumcentre",
     .family = Family::step,
     .reason = "its circumradius R = {measured} is not below the edge length h = {limit} wanted at the circumcentre",
     .limit = "the edge length h wanted at the circumcentre",
     .refused = kStepRefused,
     .silent = "its circumradius R was below the edge length h wanted at its circumcentre",
     .stage = Stage::step1},
    {.name = "step 2",
     .description = "circumradius R not below the smallest edge length h wanted at the corners",
     .family = Family::step,
     .reason =
         "its circumradius R = {measured} is not below h = {limit}, the smallest edge length wanted at its corners",
     .limit = "the smallest edge length h wanted at its corners",
     .refused = kStepRefused,
     .silent = "its circumradius R was below the smallest edge length h wanted at its corners",
     .stage = Stage::step2},
    {.name = "step 3",
     .description = "circumradius R not below the shortest edge e",
     .family = Family::step,
     .reason = "its circumradius R = {measured} is not below its shortest edge e = {limit}",
     .limit = "its shortest edge e",
     .refused = kStepRefused,
     .silent = "its circumradius R was below its shortest edge e",
     .stage = Stage::step3},
    {.name = "step 4",
     .description = "circumradius R not below the shortest edge e of an adjacent triangle",
     .family = Family::step,
     .reason = "its circumradius R = {measured} is not below the shortest edge e = {limit} of its neighbour{neighbour}",
     .limit = "the shortest edge e",
     .refused = kStepRefused,
     .silent = "its circumradius R was below the shortest edge e of every neighbour that it is much larger than",
     .stage = Stage::step4},
    {.name = "step 5",
     .description = "the neighbour's apex is not nearer to the shared edge's midpoint than e + height",
     .family = Family::step,
     .reason = "its apex lies {measured} from the middle of the edge shared with its neighbour{neighbour}: not nearer "
               "than that one's shortest edge and height, e + height = {limit}",
     .limit = "shortest edge and height, e + height,",
     .inserted = "{rule} put vertex {vertex} across an edge of {triangle}: {reason}.{effect}",
     .refused = kStepRefused,
     .silent = "its apex was nearer to the middle of every shared edge than that neighbour's e + height",
     .stage = Stage::step5},
    {.name = "repair",
     .description = "a refusal left a triangle beyond the bounds",
     .family = Family::repair,
     .inserted = "{rule} put vertex {vertex} at {place}, near {triangle}: {why}.{effect}",
     .refused = "{rule} left {triangle} alone: every edit tried around it leaves as much broken.",
     .silent = "it broke no bound, on its own or with a neighbour",
     .stage = Stage::repair},
    {.name = "Laplacian filter",
     .description = "moved toward the mean of its neighbours as far as many passes by the factor omega would",
     .family = Family::move,
     .silent = "its corners lie on the boundary, or were settled already",
     .stage = Stage::refine,
     .ofVertices = true},
    {.name = "obtuse angle",
     .description = "the sides of an obtuse angle turned toward each other by theta",
     .family = Family::move,
     .silent = "it had no obtuse angle, or none with a side that is free to move",
     .stage = Stage::refine},
    {.name = "shared edge",
     .description = "the edge between unequal triangles moved into the larger one by a tenth of its height",
     .family = Family::move,
     .silent = "no neighbour was twice as large, or the shared edge lies on the boundary",
     .stage = Stage::refine},
    {.name = "polish",
     .description =
         "one of the places around the vertex where the worst of its triangles is less near the worst of the mesh",
     .family = Family::move,
     .silent = "it was far from the worst of the mesh, and not obtuse",
     .stage = Stage::refine,
     .ofVertices = true},
    {.name = "frontal",
     .description = "over a front edge, where its triangle gets the circumradius of an equilateral one",
     .family = Family::row,
     .inserted = kRowInserted,
     .refused = kRowRefused},
    {.name = "size-optimal",
     .description = "over a front edge, where its sides have the length wanted",
     .family = Family::row,
     .inserted = kRowInserted,
     .refused = kRowRefused},
    {.name = "spokes",
     .description = "over a front edge, between the tips of two spokes that divide the angles at its ends",
     .family = Family::row,
     .inserted = kRowInserted,
     .refused = kRowRefused},
    {.name = "tiling",
     .description = "a point of the hexagonal lattice of a density rank, in a white cell",
     .family = Family::row,
     .inserted = "{rule} put vertex {vertex} at {place}: {why}, with edges of h = {limit}.{effect}",
     .refused = "{rule} proposed a vertex at {place}, and it was refused: {refusal}."},
    {.name = "rest of the rows",
     .description = "the triangle was left too large by the rows",
     .family = Family::row,
     .inserted =
         "The rows left {triangle} too large, with R = {measured} where edges of h = {limit} are wanted: vertex "
         "{vertex} was put at its circumcentre.{effect}",
     .refused = "The rows left {triangle} too large; a vertex at its circumcentre {place} was refused: {refusal}."},
    {.name = "smoothing",
     .description = "moved to the mean of the circumcentres around it, dense places weighing more",
     .family = Family::move,
     .silent = "its corners lie on the boundary, or hardly moved",
     .stage = Stage::optimise,
     .ofVertices = true},
    {.name = "best shape",
     .description = "moved to where the triangles around it are nearest to equilateral ones of the size wanted",
     .family = Family::move,
     .silent = "its corners lie on the boundary, or hardly moved",
     .stage = Stage::optimise,
     .ofVertices = true},
    {.name = "Delaunay flip",
     .description = "after the moves, its edge was no longer Delaunay",
     .family = Family::edit,
     .kept = "{rule}: {why}, opposite an obtuse angle of {triangle}.{effect}"},
    {.name = "anneal",
     .description = "dislocations, a vertex of five triangles beside one of seven, glide by flips until they meet",
     .family = Family::edit,
     .kept = "{rule} from vertex {vertex}: {why}. The patch was smoothed; its sum of squared excess degrees fell from "
             "{limit} to {measured}.{effect}",
     .undone =
         "{rule} from vertex {vertex}, tried and taken back: with the flips, smoothed, a triangle would be thin, or "
         "the sum of squared excess degrees would not stay below {limit}."},
    {.name = "relax",
     .description = "moved to where less around it is beyond what is aimed at",
     .family = Family::move,
     .silent = "nothing around it was beyond what is aimed at, or its corners may not move",
     .stage = Stage::optimise,
     .ofVertices = true},
    {.name = "cure by relaxing", .description = "the patch around it was relaxed", .family = Family::edit},
    {.name = "cure by a flip", .description = "an edge was flipped, and the patch relaxed", .family = Family::edit},
    {.name = "cure by merging",
     .description = "the ends of an edge were merged, and the patch relaxed",
     .family = Family::edit},
    {.name = "cure by splitting", .description = "an edge was split, and the patch relaxed", .family = Family::edit},
    {.name = "cure by two edits",
     .description = "two edits were made in a row, the patch relaxed after each",
     .family = Family::edit},
});
static_assert(kRules.size() == static_cast<std::size_t>(kRuleCount));

/// In the order of Refusal.
constexpr std::array kRefusals = std::to_array<RefusalWords>({
    {"none", "", ""},
    {"outside the domain", "the point does not lie in the domain", ""},
    {"too close", "the point is nearer to another vertex than allowed", " ({measured} < {limit})"},
    {"encroaches on the boundary", "the point sees a boundary edge under too wide an angle", ""},
    {"edge below minimum", "an edge would become shorter than the smallest edge allowed", " ({measured} < {limit})"},
    {"inverts a triangle", "a triangle would turn over", ""},
    {"star gets worse", "the triangles around the vertex would be worse than before", "{star}"},
    {"breaks a bound", "a bound on aspect, area ratio, edge ratio or angle would no longer hold", ""},
    {"budget spent", "the stage has used up the steps it is allowed", ""},
    {"too many triangles", "the mesh would have more triangles than max_triangles allows",
     " ({rough} > {whole_limit})"},
    {"misses the circumcircle", "the point lies outside the triangle's circumcircle, or hardly above its edge", ""},
    {"too thin", "a triangle would become too thin, even a quarter of the way", ""},
    {"patch gets worse", "the patch would not become better by enough", ""},
});
static_assert(kRefusals.size() == static_cast<std::size_t>(kRefusalCount));

/// A number beyond the table, as a damaged file may hold, has the words of nothing.
template <class Table, class Enum>
const typename Table::value_type& row(const Table& table, Enum value) {
  static constexpr typename Table::value_type kUnknown{};
  const auto index = static_cast<std::size_t>(value);
  return index < table.size() ? table[index] : kUnknown;
}

}  // namespace

const NamesWords& wordsOf(Names names) { return row(kNumbers, names); }
const KindWords& wordsOf(EventKind kind) { return row(kKinds, kind); }
const RuleWords& wordsOf(Rule rule) { return row(kRules, rule); }
const RefusalWords& wordsOf(Refusal refusal) { return row(kRefusals, refusal); }

Names otherOf(const Event& event) {
  const Names ofRule = wordsOf(event.rule).other;
  const Names ofKind = wordsOf(event.kind).other;
  return ofRule != Names::nothing && ofKind != Names::nothing ? ofRule : ofKind;
}

Named originOf(const Event& event) {
  if (does(event, kProposes) && wordsOf(event.kind).subject == Names::triangle && event.subject != kNoId)
    return {Names::triangle, event.subject};
  return event.other == kNoId ? Named{} : Named{otherOf(event), event.other};
}

bool placesVertex(const Event& event) {
  return event.vertex != kNoId && (does(event, kInserts) || does(event, kMoves));
}

}  // namespace triscope
