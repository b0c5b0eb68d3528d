#include "core/io/events_file.h"

#include <string_view>

#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/method/pipeline.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// Of the other element: told from the subject, where both are triangles.
std::string_view otherKey(const Event& event) {
  const Names what = otherOf(event);
  if (what == Names::triangle && wordsOf(event.kind).subject == what) return "other_triangle";
  return wordsOf(what).other;
}

/// The members of one object, appended to a buffer.
class ObjectLine {
 public:
  ObjectLine(TextBuffer& out, std::uint64_t number) : out_(out) { print(out_, FMT_COMPILE("{{\"event\": {}"), number); }
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
  const bool ofStage = does(event, kBounds);
  const KindWords& words = wordsOf(event.kind);
  ObjectLine line(out, number);
  line.word("kind", words.name);
  line.word("stage", infoOf(event.stage).key);
  if (event.round > 0) line.number("round", event.round);
  if (event.rule != Rule::none) line.word("rule", name(event.rule));
  if (event.refusal != Refusal::none) line.word("refusal", name(event.refusal));
  line.id(wordsOf(words.subject).key, event.subject);
  line.id(otherKey(event), event.other);
  line.id("vertex", event.vertex);
  line.id(wordsOf(words.created).created, event.created);
  if (event.createdCount > 0) line.number("created", event.createdCount);
  if (event.removedCount > 0) line.number("removed", event.removedCount);
  if (!ofStage && (event.measured != 0.0 || event.limit != 0.0)) {
    line.real("measured", event.measured);
    line.real("limit", event.limit);
  }
  if (does(event, kMoves)) line.point("from", event.from);
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
