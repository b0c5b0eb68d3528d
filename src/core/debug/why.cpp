#include "core/debug/why.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/caption.h"

namespace triscope {
namespace {

constexpr std::size_t kCauses = 4;       // of a triangle or vertex, told before the reader has to follow a link
constexpr std::size_t kCellCauses = 64;  // a density rank comes from a neighbour's; as many as there are ranks

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string told(Events events, std::size_t index) {
  return fmt::format("Event {}: {}", index, captionOf(events[index]));
}

/// True once a stage up to the triangulation has begun. These run once, in order.
bool hasBegun(Events events, Stage stage) {
  return std::any_of(events.rbegin(), events.rend(), [&](const Event& e) { return e.stage >= stage; });
}

/// What is to be said of an element that no event made.
std::string withoutBirth(Events events, Ref ref) {
  const bool box = hasBegun(events, Stage::triangulation);
  if (ref.kind == Ref::Kind::triangle && ref.id < 2 && box)
    return fmt::format("No decision made {}: it is half of the box around everything.", nameOf(ref));
  if (ref.kind == Ref::Kind::vertex && ref.id < 4 && box)
    return fmt::format("No decision made {}: it is a corner of the box around everything.", nameOf(ref));
  if (ref.kind == Ref::Kind::cell && ref.id == 0 && hasBegun(events, Stage::constraints))
    return "No decision made cell 0: it is the root, the square that holds the domain.";
  return fmt::format("There is no {} up to here.", nameOf(ref));
}

/// "It came with triangles 9000 to 9005." Nothing for a vertex.
std::string siblings(const Event& birth, Ref ref) {
  if (ref.kind != Ref::Kind::triangle && ref.kind != Ref::Kind::cell) return {};
  if (birth.createdCount < 2) return {};
  return fmt::format("{} is one of {}s {} to {}, which came together.", capitalised(nameOf(ref)), nameOf(ref.kind),
                     birth.created, birth.created + birth.createdCount - 1);
}

/// The last event before `end` that says why the element is as it is: a cell's last ranking, or else its birth.
std::optional<std::size_t> reasonFor(Events events, Ref ref, std::size_t end) {
  if (ref.kind == Ref::Kind::cell) {
    for (std::size_t k = end; k-- > 0;)
      if (events[k].kind == EventKind::cell_ranked && events[k].subject == ref.id) return k;
  }
  return birthOf(events.first(end), ref);
}

template <class Test>
std::optional<std::size_t> firstBefore(Events events, std::size_t end, Test test) {
  for (std::size_t k = 0; k < end; ++k)
    if (test(events[k])) return k;
  return std::nullopt;
}

/// The event that the decision of event `index` followed from.
std::optional<std::size_t> causeOf(Events events, std::size_t index) {
  const Event& e = events[index];
  const auto triangle = [&](std::uint32_t id) {
    return id == kNoId ? std::nullopt : reasonFor(events, {Ref::Kind::triangle, id}, index);
  };
  switch (e.kind) {
    case EventKind::cell_split:
    case EventKind::cell_ranked:
      if (e.other == kNoId) return std::nullopt;
      if (e.rule == Rule::balance || e.rule == Rule::advancing_front)
        return reasonFor(events, {Ref::Kind::cell, e.other}, index);
      return firstBefore(events, index,
                         [&](const Event& c) { return c.kind == EventKind::constraint_found && c.subject == e.other; });
    case EventKind::vertex_inserted:
    case EventKind::vertex_refused:
      if (e.rule == Rule::initial)
        return firstBefore(events, index,
                           [&](const Event& p) { return p.kind == EventKind::boundary_point && p.at == e.at; });
      if (e.rule == Rule::first_front || e.rule == Rule::second_front)
        return reasonFor(events, {Ref::Kind::vertex, e.other}, index);
      return triangle(e.subject);
    case EventKind::edge_split:
      return triangle(e.other);
    case EventKind::edge_flipped:
    case EventKind::vertex_removed:
    case EventKind::vertex_moved:
    case EventKind::vertex_kept:
      return triangle(e.subject);
    default:
      return std::nullopt;
  }
}

class Answer {
 public:
  explicit Answer(Events events) : events_(events) {}

  void say(const std::string& text) {
    if (!text.empty()) lines_.push_back(linked(text));
  }

  /// The event, what it followed from, and so on. An event is told once.
  void tell(std::size_t index, std::size_t causes) {
    for (std::optional<std::size_t> k = index; k && causes > 0; k = causeOf(events_, *k), --causes) {
      if (std::find(told_.begin(), told_.end(), *k) != told_.end()) return;
      told_.push_back(*k);
      say(told(events_, *k));
    }
  }

  std::vector<Line> take() { return std::move(lines_); }

 private:
  Events events_;
  std::vector<Line> lines_;
  std::vector<std::size_t> told_;
};

/// What became of a vertex after its birth.
void tellMoves(Events events, std::uint32_t vertex, std::size_t birth, Answer& answer) {
  std::size_t moves = 0;
  std::size_t kept = 0;
  std::size_t last = 0;
  std::optional<std::size_t> removal;
  for (std::size_t k = birth + 1; k < events.size(); ++k) {
    if (events[k].vertex != vertex) continue;
    if (events[k].kind == EventKind::vertex_kept) ++kept;
    if (events[k].kind == EventKind::vertex_removed) removal = k;
    if (events[k].kind != EventKind::vertex_moved) continue;
    ++moves;
    last = k;
  }
  if (moves > 0)
    answer.say(fmt::format("It has moved {} since, last by event {}: {}",
                           moves == 1 ? "once" : fmt::format("{} times", moves), last, captionOf(events[last])));
  if (kept > 0)
    answer.say(fmt::format("{} {} of it {} refused.", kept, kept == 1 ? "move" : "moves", kept == 1 ? "was" : "were"));
  if (removal) answer.tell(*removal, 1);
}

std::string ending(Events events, const TriangleFacts& facts) {
  return fmt::format("It ended with event {}: {}", *facts.death, captionOf(events[*facts.death]));
}

// ---- Why not ----

struct Trial {
  Rule rule;
  Stage stage;
  std::string_view foundNothing;  // what was true when it had a look and proposed nothing
};
constexpr std::array kTrials{
    Trial{Rule::step1, Stage::step1, "its circumradius R was below the edge length h wanted at its circumcentre"},
    Trial{Rule::step2, Stage::step2, "its circumradius R was below the smallest edge length h wanted at its corners"},
    Trial{Rule::step3, Stage::step3, "its circumradius R was below its shortest edge e"},
    Trial{Rule::step4, Stage::step4, "its circumradius R was below the shortest edge e of every neighbour"},
    Trial{Rule::step5, Stage::step5,
          "its apex was nearer to the middle of every shared edge than that neighbour's e + height"},
    Trial{Rule::repair, Stage::repair, "it broke no bound, on its own or with a neighbour"},
    Trial{Rule::laplacian, Stage::refine, "its corners lie on the boundary, or were settled already"},
    Trial{Rule::reduce_obtuse, Stage::refine, "it had no obtuse angle, or none with a side that is free to move"},
    Trial{Rule::shared_edge, Stage::refine, "no neighbour was twice as large, or the shared edge lies on the boundary"},
};

/// Proposals of one rule that had the same outcome; `last` is the latest event of them.
struct Outcomes {
  const Event* like;
  std::size_t last;
  std::size_t count;
};

bool isMove(EventKind kind) { return kind == EventKind::vertex_moved || kind == EventKind::vertex_kept; }

/// True when the event is a proposal of the rule for the triangle, or for the sake of one of its corners.
bool proposedFor(const Event& e, Rule rule, std::uint32_t triangle, const TriangleFacts& facts) {
  if (e.rule != rule || !(e.kind == EventKind::vertex_inserted || e.kind == EventKind::vertex_refused ||
                          e.kind == EventKind::edge_split || e.kind == EventKind::vertex_removed || isMove(e.kind)))
    return false;
  if (rule == Rule::laplacian)
    return isMove(e.kind) && std::find(facts.corners.begin(), facts.corners.end(), e.vertex) != facts.corners.end();
  return (e.kind == EventKind::edge_split ? e.other : e.subject) == triangle;
}

std::vector<Outcomes> proposals(Events events, std::size_t birth, const Trial& trial, std::uint32_t triangle,
                                const TriangleFacts& facts) {
  std::vector<Outcomes> list;
  for (std::size_t k = birth; k < events.size(); ++k) {
    const Event& e = events[k];
    if (!proposedFor(e, trial.rule, triangle, facts)) continue;
    const auto same = std::find_if(list.begin(), list.end(), [&](const Outcomes& o) {
      return o.like->kind == e.kind && o.like->refusal == e.refusal && (!isMove(e.kind) || o.like->vertex == e.vertex);
    });
    if (same == list.end()) {
      list.push_back({&e, k, 1});
    } else {
      same->last = k;
      ++same->count;
    }
  }
  return list;
}

void tellSilence(Events events, std::size_t birth, bool ended, const Trial& trial, Answer& answer) {
  const std::string rule = capitalised(std::string(name(trial.rule)));
  for (std::size_t k = events.size(); k-- > birth;) {
    const Event& e = events[k];
    if (e.kind != EventKind::stage_finished || e.stage != trial.stage) continue;
    const std::string when = e.round > 0 && trial.stage != Stage::refine ? fmt::format(", round {}", e.round) : "";
    answer.say(fmt::format("{} proposed nothing up to its end at event {}{}: {}.", rule, k, when, trial.foundNothing));
    return;
  }
  const bool before =
      std::any_of(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(birth),
                  [&](const Event& e) { return e.kind == EventKind::stage_finished && e.stage == trial.stage; });
  answer.say(fmt::format("{} has proposed nothing: {}.", rule,
                         before  ? "it was over before the triangle was made"
                         : ended ? "the triangle was gone before it came to its end"
                                 : "it has not come to its end yet"));
}

// ---- History ----

bool isRefusal(const Event& e) { return e.kind == EventKind::vertex_kept || e.kind == EventKind::vertex_refused; }

bool alike(const Event& a, const Event& b) {
  return isRefusal(a) && a.kind == b.kind && a.rule == b.rule && a.refusal == b.refusal;
}

/// Adds the moves of a triangle's corners during its life.
void addMoves(Events events, const TriangleFacts& facts, std::vector<std::size_t>& indices) {
  if (indices.empty()) return;
  const std::size_t end = facts.death ? *facts.death : events.size();
  for (std::size_t k = indices.front() + 1; k < end; ++k) {
    if (events[k].kind != EventKind::vertex_moved) continue;
    if (std::find(facts.corners.begin(), facts.corners.end(), events[k].vertex) != facts.corners.end())
      indices.push_back(k);
  }
}

}  // namespace

Line lineOf(Events events, std::size_t index) { return linked(told(events, index)); }

std::vector<Line> why(Events events, Ref ref) {
  Answer answer(events);
  const std::optional<std::size_t> birth = birthOf(events, ref);
  const bool cell = ref.kind == Ref::Kind::cell;
  if (cell) {  // its density first, back to the constraint; then its size
    const std::optional<std::size_t> reason = reasonFor(events, ref, events.size());
    if (reason) answer.tell(*reason, kCellCauses);
  }
  if (birth) {
    answer.tell(*birth, cell ? 2 : kCauses);
    if (ref.kind != Ref::Kind::event) answer.say(siblings(events[*birth], ref));
  } else {
    answer.say(withoutBirth(events, ref));
  }
  if (ref.kind == Ref::Kind::vertex && birth) tellMoves(events, ref.id, *birth, answer);
  return answer.take();
}

std::vector<Line> whyNot(Events events, std::uint32_t triangle, const TriangleFacts& facts) {
  Answer answer(events);
  const Ref ref{Ref::Kind::triangle, triangle};
  const std::optional<std::size_t> birth = birthOf(events, ref);
  if (!birth && triangle > 1) {
    answer.say(withoutBirth(events, ref));
    return answer.take();
  }
  const std::size_t from = birth.value_or(0);
  const Events life = facts.death ? events.first(*facts.death + 1) : events;
  for (const Trial& trial : kTrials) {
    if (trial.rule == Rule::laplacian && facts.corners[0] == kNoId) continue;
    const std::vector<Outcomes> tried = proposals(life, from, trial, triangle, facts);
    for (const Outcomes& outcome : tried) {
      answer.say(told(events, outcome.last) +
                 (outcome.count > 1 ? fmt::format(" The last of {} times.", outcome.count) : std::string()));
    }
    if (tried.empty()) tellSilence(life, from, facts.death.has_value(), trial, answer);
  }
  if (facts.death) answer.say(ending(events, facts));
  return answer.take();
}

std::vector<Line> historyOf(Events events, Ref ref, const TriangleFacts& facts) {
  Answer answer(events);
  std::vector<std::size_t> indices = eventsAbout(events, ref);
  if (!birthOf(events, ref)) answer.say(withoutBirth(events, ref));
  if (ref.kind == Ref::Kind::triangle) {
    if (facts.death) indices.erase(std::remove(indices.begin(), indices.end(), *facts.death), indices.end());
    addMoves(events, facts, indices);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }
  for (std::size_t k = 0; k < indices.size();) {
    std::size_t last = k;
    while (last + 1 < indices.size() && alike(events[indices[k]], events[indices[last + 1]])) ++last;
    std::string text = told(events, indices[last]);
    if (last > k) text += fmt::format(" The last of {} times since event {}.", last - k + 1, indices[k]);
    answer.say(text);
    k = last + 1;
  }
  if (facts.death) answer.say(ending(events, facts));
  return answer.take();
}

}  // namespace triscope
