#include "core/run/condition.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "core/method/pipeline.h"
#include "core/quality/quality.h"
#include "core/run/condition_parser.h"
#include "core/run/element_events.h"
#include "core/run/validity.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

using Kind = Word::Kind;

enum class Field : std::uint8_t {
  aspect,
  area_ratio,
  edge_ratio,
  min_angle,
  max_angle,
  obtuse,
  triangles,
  vertices,
  tick,
  round,
  measured,
  limit,
  x,
  y,
  stalled,
  inserted,
  refused,
  moved,
  removed,
  split,
  failed,
  finished,
  bound_broken,
  orientation_broken,
  delaunay_broken,
  boundary_broken,
  balance_broken,
  area_broken,
  edge_below_minimum,
  stage,
  event,
  rule,
  refusal,
  triangle,
  vertex,
  cell,
};

double numberOf(Field field, const Moment& m) {
  switch (field) {
    case Field::aspect:
      return m.quality.worst(Measure::aspect);
    case Field::area_ratio:
      return m.quality.worst(Measure::area_ratio);
    case Field::edge_ratio:
      return m.quality.worst(Measure::edge_ratio);
    case Field::min_angle:
      return m.quality.worst(Measure::min_angle);
    case Field::max_angle:
      return m.quality.worst(Measure::max_angle);
    case Field::obtuse:
      return static_cast<double>(m.quality.obtuse());
    case Field::triangles:
      return static_cast<double>(m.state.mesh.liveCount());
    case Field::vertices:
      return static_cast<double>(m.state.mesh.points.size());
    case Field::tick:
      return static_cast<double>(m.state.tick);
    case Field::round:
      return m.event.round;
    case Field::measured:
      return m.event.measured;
    case Field::limit:
      return m.event.limit;
    case Field::x:
      return m.event.at.x;
    case Field::y:
      return m.event.at.y;
    case Field::stalled:
      return static_cast<double>(m.sinceInsertion);
    default:
      return 0.0;
  }
}

bool boundBroken(const RunningQuality& q) {
  if (q.triangles() == 0) return false;
  return q.worst(Measure::aspect) >= Bounds::aspect || q.worst(Measure::area_ratio) >= Bounds::areaRatio ||
         q.worst(Measure::edge_ratio) >= Bounds::edgeRatio || q.worst(Measure::min_angle) <= Bounds::minAngle ||
         q.worst(Measure::max_angle) >= Bounds::maxAngle;
}

bool flagOf(Field field, const Moment& m) {
  switch (field) {
    case Field::inserted:
      return does(m.event, kInserts);
    case Field::refused:
      return m.event.refusal != Refusal::none;
    case Field::moved:
      return does(m.event, kMoves);
    case Field::removed:
      return does(m.event, kRemoves);
    case Field::split:
      return does(m.event, kSplits);
    case Field::failed:
      return m.event.kind == EventKind::failure;
    case Field::finished:
      return m.state.stage == Stage::finished;
    case Field::bound_broken:
      return boundBroken(m.quality);
    case Field::orientation_broken:
      return (m.broken & kOrientation) != 0;
    case Field::delaunay_broken:
      return (m.broken & kDelaunay) != 0;
    case Field::boundary_broken:
      return (m.broken & kBoundary) != 0;
    case Field::balance_broken:
      return (m.broken & kBalance) != 0;
    case Field::area_broken:
      return (m.broken & kArea) != 0;
    case Field::edge_below_minimum:
      return (m.broken & kMinimumLength) != 0;
    default:
      return false;
  }
}

int nameOf(Field field, const Moment& m) {
  switch (field) {
    case Field::stage:
      return static_cast<int>(m.event.stage);
    case Field::event:
      return static_cast<int>(m.event.kind);
    case Field::rule:
      return static_cast<int>(m.event.rule);
    default:
      return static_cast<int>(m.event.refusal);
  }
}

Ref::Kind refKindOf(Field field) {
  return field == Field::vertex ? Ref::Kind::vertex : field == Field::cell ? Ref::Kind::cell : Ref::Kind::triangle;
}

}  // namespace

const std::vector<Word>& conditionWords() {
  // In the order of Field.
  static const std::vector<Word> words = {
      {"aspect", Kind::number, false, "worst aspect ratio R/r of the mesh"},
      {"area_ratio", Kind::number, false, "worst area ratio of two triangles that share an edge"},
      {"edge_ratio", Kind::number, false, "worst edge ratio"},
      {"min_angle", Kind::number, false, "smallest angle, degrees"},
      {"max_angle", Kind::number, false, "largest angle, degrees"},
      {"obtuse", Kind::number, false, "number of obtuse triangles"},
      {"triangles", Kind::number, false, "number of triangles"},
      {"vertices", Kind::number, false, "number of vertices made so far"},
      {"tick", Kind::number, false, "decisions made so far"},
      {"round", Kind::number, true, "round of steps 2-5, or pass of step 6 or of the optimiser"},
      {"measured", Kind::number, true, "the value that the decision measured"},
      {"limit", Kind::number, true, "the limit that it was held against"},
      {"x", Kind::number, true, "where the event is"},
      {"y", Kind::number, true, "where the event is"},
      {"stalled", Kind::number, false, "decisions since the last that inserted a point"},
      {"inserted", Kind::flag, true, "the decision inserted a point"},
      {"refused", Kind::flag, true, "the decision refused a point or a move"},
      {"moved", Kind::flag, true, "the decision moved a vertex"},
      {"removed", Kind::flag, true, "the decision removed a vertex or a triangle"},
      {"split", Kind::flag, true, "the decision split a cell or a boundary edge"},
      {"failed", Kind::flag, true, "the method could not go on"},
      {"finished", Kind::flag, false, "the run is over"},
      {"bound_broken", Kind::flag, false, "a bound of the paper's section 3 does not hold"},
      {"orientation_broken", Kind::flag, false, "a triangle that changed is not counter-clockwise"},
      {"delaunay_broken", Kind::flag, false, "an edge of a triangle that changed is not locally Delaunay"},
      {"boundary_broken", Kind::flag, false, "a boundary edge beside a triangle that changed is not in the mesh"},
      {"balance_broken", Kind::flag, false, "the density ended with neighbouring cells more than one rank apart"},
      {"area_broken", Kind::flag, false, "a stage ended with triangles that do not fill the domain"},
      {"edge_below_minimum", Kind::flag, false,
       "an edge of a triangle that changed is shorter than the smallest length"},
      {"stage", Kind::name, true, "the stage, as on the command line: stage == step3"},
      {"event", Kind::name, true, "the kind of event: event == vertex_refused"},
      {"rule", Kind::name, true, "the rule: rule == step_5"},
      {"refusal", Kind::name, true, "the reason of a refusal: refusal == too_close"},
      {"triangle", Kind::id, true, "the event is about this triangle: triangle == 5821"},
      {"vertex", Kind::id, true, "the event is about this vertex"},
      {"cell", Kind::id, true, "the event is about this cell of the quadtree"},
  };
  return words;
}

std::vector<std::string> namesOf(std::string_view word) {
  // The displayed names with spaces and hyphens turned into underscores; "none" is not worth asking for.
  const auto plain = [](std::string_view text) {
    std::string out(text);
    for (char& c : out) {
      if (c == ' ' || c == '-') c = '_';
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return out;
  };
  std::vector<std::string> list;
  if (word == "stage") {
    for (const StageInfo& info : stages()) list.emplace_back(info.key);
  } else if (word == "event") {
    for (int k = 0; k < kEventKindCount; ++k) list.push_back(plain(name(static_cast<EventKind>(k))));
  } else if (word == "rule") {
    for (int k = 0; k < kRuleCount; ++k) list.push_back(plain(name(static_cast<Rule>(k))));
  } else {
    for (int k = 0; k < kRefusalCount; ++k) list.push_back(plain(name(static_cast<Refusal>(k))));
  }
  return list;
}

Result<Condition> Condition::compile(std::string_view text) { return ConditionParser(text).parse(); }

bool Condition::holds(const Moment& m) const {
  std::array<bool, 64> stack{};  // the parser refuses deeper texts
  std::size_t depth = 0;
  for (const Step& step : steps_) {
    const auto field = static_cast<Field>(step.word);
    bool result = false;
    switch (step.code) {
      case Step::Code::test:
        result = compareNumbers(static_cast<Compare>(step.compare), numberOf(field, m), step.value);
        break;
      case Step::Code::flag:
        result = flagOf(field, m);
        break;
      case Step::Code::name:
        result = (nameOf(field, m) == static_cast<int>(step.value)) ==
                 (static_cast<Compare>(step.compare) == Compare::equal);
        break;
      case Step::Code::id:
        result = isAbout(m.event, {refKindOf(field), static_cast<std::uint32_t>(step.value)}) ==
                 (static_cast<Compare>(step.compare) == Compare::equal);
        break;
      case Step::Code::inside:
        result = m.event.at.x >= step.box[0] && m.event.at.y >= step.box[1] && m.event.at.x <= step.box[2] &&
                 m.event.at.y <= step.box[3];
        break;
      case Step::Code::negate:
        stack[depth - 1] = !stack[depth - 1];
        continue;
      case Step::Code::all:
      case Step::Code::any:
        --depth;
        stack[depth - 1] =
            step.code == Step::Code::all ? stack[depth - 1] && stack[depth] : stack[depth - 1] || stack[depth];
        continue;
    }
    stack[depth++] = result;
  }
  return stack[0];
}

}  // namespace triscope
