#include "core/io/events_file.h"

#include <array>
#include <string_view>

#include "core/io/json_text.h"
#include "core/pipeline.h"
#include "core/version.h"

namespace triscope {
namespace {

/// What `subject` and `created` are ids of, by EventKind in order; empty: the kind has no such number.
struct Keys {
  std::string_view subject;
  std::string_view created;
};
constexpr std::array kKeys = std::to_array<Keys>({
    {"", ""},                             // stage_begun: the round, which every event has
    {"constraint", ""},                   // constraint_found
    {"cell", "first_cell"},               // cell_split
    {"cell", ""},                         // cell_ranked
    {"curve", ""},                        // boundary_point
    {"triangle", "first_triangle"},       // vertex_inserted
    {"triangle", ""},                     // vertex_refused
    {"boundary_edge", "first_triangle"},  // edge_split
    {"triangle", "first_triangle"},       // vertex_removed
    {"triangle", ""},                     // triangle_removed
    {"triangle", "first_triangle"},       // edge_flipped
    {"triangle", "first_triangle"},       // vertex_moved
    {"triangle", ""},                     // vertex_kept
    {"changes", ""},                      // stage_finished
    {"subject", ""},                      // failure
});
static_assert(kKeys.size() == static_cast<std::size_t>(EventKind::failure) + 1);

/// What `other` is an id of.
std::string_view otherKey(const Event& event) {
  switch (event.kind) {
    case EventKind::constraint_found:
      return "curve";
    case EventKind::cell_split:
      return event.rule == Rule::advancing_front || event.rule == Rule::balance ? "from_cell" : "constraint";
    case EventKind::edge_split:
      return "triangle";
    case EventKind::cell_ranked:
      return event.rule == Rule::advancing_front ? "from_cell" : "constraint";
    case EventKind::boundary_point:
      return "boundary_point";
    case EventKind::edge_flipped:
      return "other_triangle";
    case EventKind::vertex_inserted:
    case EventKind::vertex_refused:
      if (event.rule == Rule::initial) return "curve";
      if (event.rule == Rule::first_front || event.rule == Rule::second_front) return "from_vertex";
      return "other_triangle";
    default:
      return "other";
  }
}

/// The members of one object, appended to a buffer.
class Line {
 public:
  Line(TextBuffer& out, std::uint64_t number) : out_(out) { print(out_, FMT_COMPILE("{{\"event\": {}"), number); }
  void number(std::string_view key, std::uint64_t value) {
    member(key);
    print(out_, FMT_COMPILE("{}"), value);
  }
  void id(std::string_view key, std::uint32_t value) {
    if (!key.empty() && value != kNoId) number(key, value);
  }
  void real(std::string_view key, double value) {
    member(key);
    appendJsonNumber(out_, value);
  }
  /// A name of a table, which has nothing to escape.
  void word(std::string_view key, std::string_view value) {
    member(key);
    appendText(out_, "\"");
    appendText(out_, value);
    appendText(out_, "\"");
  }
  void point(std::string_view key, Point p) {
    member(key);
    appendText(out_, "[");
    appendJsonNumber(out_, p.x);
    appendText(out_, ", ");
    appendJsonNumber(out_, p.y);
    appendText(out_, "]");
  }
  void finish() { appendText(out_, "}"); }

 private:
  void member(std::string_view key) {
    appendText(out_, ", \"");
    appendText(out_, key);
    appendText(out_, "\": ");
  }
  TextBuffer& out_;
};

void appendEvent(TextBuffer& out, const Event& event, std::uint64_t number) {
  const bool ofStage = event.kind == EventKind::stage_begun || event.kind == EventKind::stage_finished;
  const Keys& keys = kKeys[static_cast<std::size_t>(event.kind)];
  Line line(out, number);
  line.word("kind", name(event.kind));
  line.word("stage", infoOf(event.stage).key);
  if (event.round > 0) line.number("round", event.round);
  if (event.rule != Rule::none) line.word("rule", name(event.rule));
  if (event.refusal != Refusal::none) line.word("refusal", name(event.refusal));
  line.id(keys.subject, event.subject);
  line.id(otherKey(event), event.other);
  line.id("vertex", event.vertex);
  line.id(keys.created, event.created);
  if (event.createdCount > 0) line.number("created", event.createdCount);
  if (event.removedCount > 0) line.number("removed", event.removedCount);
  if (!ofStage && (event.measured != 0.0 || event.limit != 0.0)) {
    line.real("measured", event.measured);
    line.real("limit", event.limit);
  }
  if (event.kind == EventKind::vertex_moved) line.point("from", event.from);
  if (!ofStage) line.point("at", event.at);
  line.finish();
}

}  // namespace

std::string eventLine(const Event& event, std::uint64_t number) {
  TextBuffer line;
  appendEvent(line, event, number);
  return {line.data(), line.size()};
}

EventsFile::EventsFile(AtomicFile& file) : file_(&file) {
  const MadeBy now = thisVersion();
  print(buffer_, FMT_COMPILE("{{\"program_version\": {}, \"method_version\": {}}}\n"), jsonText(now.program),
        now.method);
}

Result<EventsFile> EventsFile::create(const std::string& path, OutputSet& set) {
  const Result<AtomicFile*> file = set.open(path);
  if (!file) return file.error();
  return EventsFile(**file);
}

Status EventsFile::append(std::span<const Event> events) {
  constexpr std::size_t kBlock = 1u << 16;
  for (const Event& event : events) {
    appendEvent(buffer_, event, count_++);
    buffer_.push_back('\n');
    if (buffer_.size() < kBlock) continue;
    if (const Status written = finish(); !written) return written;
  }
  return success();
}

Status EventsFile::finish() {
  const Status written = file_->write({buffer_.data(), buffer_.size()});
  buffer_.clear();
  return written;
}

}  // namespace triscope
