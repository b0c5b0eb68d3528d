#include "core/domain/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/shown_text.h"
#include "core/domain/orient.h"
#include "core/domain/outline.h"
#include "core/domain/sweep_line.h"
#include "core/geometry/predicates.h"

namespace triscope {

namespace {

/// Names places of a draft as the file numbers them.
class Namer {
 public:
  Namer(const DomainDraft& draft, const std::vector<Chord>& chords) : draft_(draft), chords_(chords) {}

  [[nodiscard]] const std::string& loop(std::size_t chord) const {
    return draft_.domain.loops[chords_[chord].loop].name;
  }

  [[nodiscard]] bool isChain(std::size_t chord) const {
    return draft_.domain.loops[chords_[chord].loop].role == LoopRole::chain;
  }

  [[nodiscard]] std::uint32_t loopIndex(std::size_t chord) const { return chords_[chord].loop; }

  /// Where in its loop, as the file has it, a chord comes.
  [[nodiscard]] std::pair<int, int> order(std::size_t chord) const {
    const CurveSource& source = draft_.sources[chords_[chord].curve];
    const int knot = chords_[chord].knot;
    // Once turned round, an edge starts at the later of its points.
    return {source.piece, source.pointAt(source.step > 0 ? knot : knot + 1)};
  }

  /// Index in the file of an end of a chord, -1 when it is no point of the file.
  [[nodiscard]] int point(std::size_t chord, Point at) const {
    const Chord& c = chords_[chord];
    const Curve& curve = draft_.domain.curves[c.curve];
    const CurveSource& source = draft_.sources[c.curve];
    const auto knot = static_cast<std::size_t>(c.knot);
    if (curve.kind != CurveKind::spline) {
      if (at == curve.a) return source.pointAt(0);
      return at == curve.b ? source.pointAt(1) : -1;
    }
    if (at == curve.knots[knot]) return source.pointAt(c.knot);
    return at == curve.knots[knot + 1] ? source.pointAt(c.knot + 1) : -1;
  }

  /// "edge 3-4", "the circle", …; with its loop when that is not `own`.
  [[nodiscard]] std::string edge(std::size_t chord, const std::string& own) const {
    const Chord& c = chords_[chord];
    const Curve& curve = draft_.domain.curves[c.curve];
    const CurveSource& source = draft_.sources[c.curve];
    std::string name = curve.kind == CurveKind::arc ? curve.a == curve.b ? "the circle" : "the arc" : "the edge";
    if (source.first >= 0) {
      const auto [low, high] = std::minmax({source.pointAt(c.knot), source.pointAt(c.knot + 1)});
      const std::string_view kind = curve.kind == CurveKind::line ? "edge" : "curve";
      // The edge that closes a loop runs from the last point to the first.
      name = high - low > 1 ? fmt::format("{} {}-{}", kind, high, low) : fmt::format("{} {}-{}", kind, low, high);
    }
    return withPlace(std::move(name), chord, own);
  }

  /// "point 3", with its loop when that is not `own`.
  [[nodiscard]] std::string vertex(std::size_t chord, Point at, const std::string& own) const {
    const int index = point(chord, at);
    if (index < 0) return "a point of " + edge(chord, own);
    return withPlace(fmt::format("point {}", index), chord, own);
  }

 private:
  [[nodiscard]] std::string withPlace(std::string name, std::size_t chord, const std::string& own) const {
    const int piece = draft_.sources[chords_[chord].curve].piece;
    if (piece >= 0) name += fmt::format(" of piece {}", piece);
    if (loop(chord) != own) name += fmt::format(" of loop '{}'", shown(loop(chord)));
    return name;
  }

  const DomainDraft& draft_;
  const std::vector<Chord>& chords_;
};

/// Which of two chords a message is about: the one of the later loop, in one loop the one that comes first.
bool comesFirst(std::size_t s, std::size_t t, const Namer& names) {
  return names.loopIndex(s) != names.loopIndex(t) ? names.loopIndex(s) > names.loopIndex(t)
                                                  : names.order(s) < names.order(t);
}

Error explain(Contact contact, const Namer& names) {
  if (contact.kind != ContactKind::point_on_edge && comesFirst(contact.second, contact.first, names)) {
    std::swap(contact.first, contact.second);
  }
  const std::string& loop = names.loop(contact.first);
  Error error{.loop = loop, .point = names.point(contact.first, contact.at), .at = contact.at};
  switch (contact.kind) {
    case ContactKind::crossing:
      error.message = fmt::format("{} crosses {}", names.edge(contact.first, loop), names.edge(contact.second, loop));
      error.hint = "move or remove points so that they no longer cross";
      break;
    case ContactKind::point_on_edge:
      error.message =
          fmt::format("{} lies on {}", names.vertex(contact.first, contact.at, loop), names.edge(contact.second, loop));
      error.hint = "move it away; to join an inner segment there, give both the same point";
      break;
    case ContactKind::overlap:
      error.message =
          fmt::format("{} runs along {}", names.edge(contact.first, loop), names.edge(contact.second, loop));
      error.hint = "remove one of the two, or move a point";
      break;
    case ContactKind::shared_point:
      error.message = fmt::format("{} is at the same place as {}", names.vertex(contact.first, contact.at, loop),
                                  names.vertex(contact.second, contact.at, loop));
      error.hint = names.isChain(contact.first) || names.isChain(contact.second)
                       ? "let them meet where both have a corner or an end, or move one of the two"
                       : "move one of the two: a loop may touch neither itself nor another loop";
      break;
  }
  return error;
}

bool onOneLine(std::span<const Chord> chords) {
  return std::all_of(chords.begin(), chords.end(),
                     [&](const Chord& chord) { return orient2d(chords[0].a, chords[0].b, chord.b) == 0; });
}

Status checkNesting(const DomainDraft& draft, const std::vector<Chord>& chords, const SweepLineResult& swept) {
  const Namer names(draft, chords);
  const auto& loops = draft.domain.loops;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const std::int32_t around = swept.enclosing[i];
    const Loop& loop = loops[chords[i].loop];
    Error error{.loop = loop.name, .point = names.point(i, chords[i].a), .at = chords[i].a};
    if (loop.role == LoopRole::outer) {
      if (around < 0) continue;
      error.message =
          fmt::format("the outer loop lies inside '{}'", shown(loops[static_cast<std::size_t>(around)].name));
      error.hint = "make the loop that encloses everything the \"outer\" one";
      return error;
    }
    if (around == 0) continue;
    const std::string_view what = loop.role == LoopRole::hole ? "the hole" : "the segment";
    if (around < 0) {
      error.message = fmt::format("{} lies outside the outer loop", what);
      error.hint = "move it inside, or remove it";
    } else {
      error.message = fmt::format("{} lies inside '{}'", what, shown(loops[static_cast<std::size_t>(around)].name));
      error.hint = "remove one of the two; what lies in a hole is not meshed";
    }
    return error;
  }
  return success();
}

Status checkOutline(const DomainDraft& draft) {
  const Domain& domain = draft.domain;
  std::vector<Chord> chords;
  for (std::uint32_t i = 0; i < domain.loops.size(); ++i) {
    const Loop& loop = domain.loops[i];
    const std::vector<Chord> own = outlineOf(domain, i);
    if (own.empty() || (loop.role != LoopRole::chain && onOneLine(own))) {
      return Error{.message = own.empty() ? "all its points are at the same place" : "all its points lie on one line",
                   .hint = "a loop must enclose an area",
                   .loop = loop.name,
                   .at = domain.curves[loop.firstCurve].a};
    }
    chords.insert(chords.end(), own.begin(), own.end());
  }
  const SweepLineResult swept = sweepLine(domain, chords);
  if (swept.contact) return explain(*swept.contact, Namer(draft, chords));
  return checkNesting(draft, chords, swept);
}

}  // namespace

Result<Domain> checkDomain(DomainDraft draft) {
  orient(draft);
  auto status = checkOutline(draft);
  if (!status) {
    Error error = status.error();
    error.file = draft.domain.file;
    return error;
  }
  return std::move(draft.domain);
}

Result<Domain> checkDomain(Domain domain) {
  DomainDraft draft{std::move(domain), {}};
  draft.sources.resize(draft.domain.curves.size());
  for (const Loop& loop : draft.domain.loops) {
    const auto points = static_cast<int>(loop.curveCount) + (loop.role == LoopRole::chain ? 1 : 0);
    for (std::uint32_t i = 0; i < loop.curveCount; ++i) {
      if (draft.domain.curves[loop.firstCurve + i].kind == CurveKind::spline) continue;  // its knots have no number
      draft.sources[loop.firstCurve + i] = {static_cast<int>(i), 1, points};
    }
  }
  return checkDomain(std::move(draft));
}

}  // namespace triscope
