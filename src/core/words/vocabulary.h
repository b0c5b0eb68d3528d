// What an event says, one row for each kind, rule and refusal: what its numbers are ids of, what it does, how it is
// drawn and how it is put into words. Captions, event files, answers, conditions, pictures and legends read these rows;
// a new kind or rule is a row here and what its picture needs.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/words/event.h"
#include "core/words/links.h"

namespace triscope {

/// What a number of an event is an id, an index or a count of.
enum class Names : std::uint8_t {
  nothing,
  triangle,
  vertex,
  cell,
  constraint,
  curve,
  boundary_edge,
  boundary_point,
  changes,
};
inline constexpr int kNamesCount = static_cast<int>(Names::changes) + 1;

/// What a number is called in event files; empty where it is never such.
struct NamesWords {
  std::string_view key = {};              // as Event::subject
  std::string_view other = {};            // as Event::other
  std::string_view created = {};          // as Event::created
  std::optional<Ref::Kind> element = {};  // whose id it is, where it is that of an element people can point at
};

/// What a decision is drawn as.
enum class Picture : std::uint8_t { none, place, cell, insertion, refusal, move, removal, carved, failure, patch };

/// What a decision does, bit by bit.
enum Does : std::uint8_t {
  kInserts = 1,    // a point
  kMoves = 2,      // a vertex
  kRemoves = 4,    // a vertex or a triangle
  kSplits = 8,     // a cell or a boundary edge
  kProposes = 16,  // carries out or refuses what a rule proposed for a triangle, or for one of its corners
  kRefuses = 32,   // what was proposed, which then changes nothing
  kBounds = 64     // the stage: begins or ends it
};

/// Where a rule stands in the method.
enum class Family : std::uint8_t { none, source, neighbour, boundary, front, row, step, repair, move, edit };

struct RuleWords {
  std::string_view name = {};         // "step 3"
  std::string_view description = {};  // "circumradius R not below the shortest edge e": what was found true
  Family family = Family::none;
  Names other = Names::nothing;    // Event::other
  std::string_view reason = {};    // the description with an event's own figures, a template
  std::string_view limit = {};     // what the limit of a step is
  std::string_view inserted = {};  // caption of a point that it put in, a template
  std::string_view refused = {};   // caption of one that was refused, a template
  std::string_view kept = {};      // caption of an edit that was kept, a template
  std::string_view undone = {};    // caption of one that was taken back, a template
  std::string_view silent = {};    // what was true of a triangle that it had a look at and proposed nothing for
  Stage stage = Stage::finished;   // where it has a look at every triangle, if `silent` says so
  bool ofVertices = false;         // proposes for vertices, not for triangles
  std::string_view demand = {};    // of a source in the geometry: what of a loop asks for the edges; {} is its name
  std::string_view eased = {};     // the setting that, made larger, lets the source ask for fewer triangles
};

struct KindWords {
  std::string_view name = {};      // "vertex inserted"
  Names subject = Names::nothing;  // Event::subject
  Names other = Names::nothing;    // Event::other, where the rule does not say
  Names created = Names::nothing;  // Event::created and those after it
  int does = 0;                    // bits of Does
  bool placed = false;             // Event::at is where the decision was made
  bool from = false;               // Event::from is where the vertex was
  Picture picture = Picture::none;
  std::string_view caption = {};                          // a template: fields.h
  std::string_view RuleWords::* captionOfRule = nullptr;  // the rule's own, where it has one
};

struct RefusalWords {
  std::string_view name = {};         // "too close"
  std::string_view description = {};  // "the point is nearer to another vertex than allowed"
  std::string_view figures = {};      // what it was held against, a template
};

const NamesWords& wordsOf(Names names);
const KindWords& wordsOf(EventKind kind);
const RuleWords& wordsOf(Rule rule);
const RefusalWords& wordsOf(Refusal refusal);

inline std::string_view name(EventKind kind) { return wordsOf(kind).name; }
inline std::string_view name(Rule rule) { return wordsOf(rule).name; }
inline std::string_view name(Refusal refusal) { return wordsOf(refusal).name; }
inline std::string_view describe(Rule rule) { return wordsOf(rule).description; }
inline std::string_view describe(Refusal refusal) { return wordsOf(refusal).description; }

/// True when the decision does all that the bits of Does say.
inline bool does(const Event& event, int bits) { return (wordsOf(event.kind).does & bits) == bits; }

/// What Event::other is an id of.
Names otherOf(const Event& event);

/// An id, and what it is an id of.
struct Named {
  Names what = Names::nothing;
  std::uint32_t id = kNoId;
};

/// What the decision followed from: the triangle that it was proposed for, the vertex of a front, the cell or the
/// constraint that asked for it. Nothing where the event does not say.
Named originOf(const Event& event);

/// True when the event puts its vertex at Event::at.
bool placesVertex(const Event& event);

}  // namespace triscope
