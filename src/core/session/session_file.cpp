#include "core/session/session_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/base/json_text.h"
#include "core/base/json_value.h"
#include "core/base/output_set.h"
#include "core/base/shown_text.h"
#include "core/method/pipeline.h"

namespace triscope {
namespace {

constexpr std::string_view kFormat = "triscope session";
constexpr double kVersion = 1.0;
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: what a JSON number holds exactly
constexpr double kMostMethods = 1e9;
constexpr std::uint64_t kBeatsPerPulse = 1024;

// ---- Writing ----

/// Length of the well-formed UTF-8 character at `at`; 0 when there is none.
std::size_t characterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0u; };
  const auto follows = [&](std::size_t k) { return (byte(k) & 0xc0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return follows(1) ? 2 : 0;
  if (lead >= 0xe0 && lead < 0xf0) {
    const bool overlong = lead == 0xe0 && byte(1) < 0xa0;
    const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
    return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xf0 && lead < 0xf5) {
    const bool outside = (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) >= 0x90);
    return follows(1) && follows(2) && follows(3) && !outside ? 4 : 0;
  }
  return 0;
}

/// As JSON. A file name may hold any bytes, JSON may not: what is no UTF-8 becomes a question mark.
std::string quoted(std::string_view text) {
  std::string clean;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = characterAt(text, at);
    clean += length > 0 ? text.substr(at, length) : std::string_view("?");
    at += length > 0 ? length : 1;
  }
  return jsonText(clean);
}

template <class List, class Write>
std::string listOf(const List& list, Write write) {
  std::string text;
  for (const auto& item : list) text += fmt::format("{}\n    {}", text.empty() ? "" : ",", write(item));
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

std::string settingsText(const Settings& settings) {
  std::string text;
  for (const SettingInfo& info : settingTable()) {
    const double value = settingValue(settings, info);
    const SettingKind kind = info.member.kind;
    text += fmt::format("{}\n    {}: {}", text.empty() ? "" : ",", jsonText(info.key),
                        kind == SettingKind::on_off  ? (value != 0.0 ? "true" : "false")
                        : kind == SettingKind::named ? jsonText(valueName(info, value))
                                                     : jsonNumber(value));
  }
  return "{" + text + "\n  }";
}

// ---- Reading ----

Error wrong(std::string message, std::string hint) { return {.message = std::move(message), .hint = std::move(hint)}; }

/// The members of one object, read one after the other. The first thing that is wrong is kept; after it nothing is
/// read.
class Members {
 public:
  Members(const JsonValue& value, std::string place, std::optional<Error>& error)
      : object_(value.object()), place_(std::move(place)), error_(error) {
    if (object_ == nullptr) complain("", value.typeName(), "an object");
  }

  [[nodiscard]] const JsonValue* value(std::string_view key) const {
    return error_ || object_ == nullptr ? nullptr : find(*object_, key);
  }

  void text(std::string_view key, std::string& into) {
    const JsonValue* const found = value(key);
    if (found == nullptr) return;
    if (found->text() == nullptr) return complain(key, found->typeName(), "a text");
    into = *found->text();
  }

  void flag(std::string_view key, bool& into) {
    const JsonValue* const found = value(key);
    if (found == nullptr) return;
    const bool* const on = std::get_if<bool>(&found->data);
    if (on == nullptr) return complain(key, found->typeName(), "true or false");
    into = *on;
  }

  void number(std::string_view key, double& into) {
    const JsonValue* const found = value(key);
    if (found == nullptr) return;
    if (found->number() == nullptr) return complain(key, found->typeName(), "a number");
    into = *found->number();
  }

  /// In [0, largest].
  template <class Whole>
  void whole(std::string_view key, double largest, Whole& into) {
    double value = 0.0;
    if (this->value(key) == nullptr) return;
    number(key, value);
    if (error_) return;
    if (value < 0.0 || value > largest || value != std::floor(value))
      return complain(key, fmt::format("{:g}", value), fmt::format("a whole number from 0 to {:.0f}", largest));
    into = static_cast<Whole>(value);
  }

  /// Calls `read` with the members of each object of a list.
  template <class Read>
  void list(std::string_view key, Read read) {
    const JsonValue* const found = value(key);
    if (found == nullptr) return;
    if (found->list() == nullptr) return complain(key, found->typeName(), "a list");
    for (std::size_t k = 0; k < found->list()->size() && !error_; ++k) {
      Members members((*found->list())[k], fmt::format("{}{}[{}]", place_, key, k), error_);
      if (!error_) read(members);
    }
  }

  void complain(std::string_view key, std::string_view is, std::string_view expected) {
    const std::string name =
        place_.empty() || key.empty() ? place_ + std::string(key) : fmt::format("{}.{}", place_, key);
    refuse(wrong(fmt::format("\"{}\" is {}", name, is), fmt::format("expected {}", expected)));
  }
  void refuse(Error error) {
    if (!error_) error_ = std::move(error);
  }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] const JsonValue::Object* object() const { return object_; }

 private:
  const JsonValue::Object* object_;
  std::string place_;
  std::optional<Error>& error_;
};

void readSettings(Members& root, Settings& settings) {
  const JsonValue* const value = root.value("settings");
  if (value == nullptr) return;
  if (value->object() == nullptr) return root.complain("settings", value->typeName(), "an object");
  for (const JsonMember& member : *value->object()) {
    const SettingInfo* const info = findSetting(member.key);
    if (info == nullptr)
      return root.refuse(wrong(fmt::format("there is no setting \"{}\"", member.key),
                               "the session may come from a newer version; 'triscope settings' lists the settings"));
    const bool* const flag = std::get_if<bool>(&member.value.data);
    const double* const number = member.value.number();
    const std::string* const name = info->member.kind == SettingKind::named ? member.value.text() : nullptr;
    if (flag == nullptr && number == nullptr && name == nullptr)
      return root.complain("settings." + member.key, member.value.typeName(),
                           info->member.kind == SettingKind::named ? rangeText(*info) : "a number, true or false");
    const Status status = name != nullptr   ? setSetting(settings, *info, *name)
                          : flag != nullptr ? setSetting(settings, *info, *flag ? 1.0 : 0.0)
                                            : setSetting(settings, *info, *number);
    if (!status.ok()) return root.refuse(wrong(status.error().message, status.error().hint));
  }
}

void readBreakpoint(Members& members, std::vector<Breakpoint>& list) {
  std::string text;
  std::string action(kBreakpointActions[0]);
  bool enabled = true;
  members.text("condition", text);
  members.text("action", action);
  members.flag("enabled", enabled);
  const auto named = std::find(kBreakpointActions.begin(), kBreakpointActions.end(), action);
  if (named == kBreakpointActions.end())
    return members.complain("action", fmt::format("\"{}\"", shown(action)), "stop, log or mark");
  Result<Condition> condition = Condition::compile(text);
  if (!condition.ok())
    return members.refuse(
        wrong(fmt::format("\"{}.condition\": {}", members.place(), condition.error().message), condition.error().hint));
  list.push_back({std::move(*condition), static_cast<Breakpoint::Action>(named - kBreakpointActions.begin()), enabled});
}

void readHash(Members& members, std::vector<StageHash>& list) {
  StageHash hash;
  std::string stage;
  std::string digits;
  members.text("stage", stage);
  members.whole("round", 65535.0, hash.round);
  members.whole("tick", kLargestWhole, hash.tick);
  members.text("hash", digits);
  const auto info = std::find_if(stages().begin(), stages().end(), [&](const StageInfo& s) { return s.key == stage; });
  if (info == stages().end()) return members.complain("stage", fmt::format("\"{}\"", stage), "the key of a stage");
  hash.stage = info->id;
  const char* const last = digits.data() + digits.size();
  const auto [stop, failure] = std::from_chars(digits.data(), last, hash.hash, 16);
  if (failure != std::errc{} || stop != last || digits.size() != 16)
    return members.complain("hash", fmt::format("\"{}\"", digits), "16 hexadecimal digits");
  list.push_back(hash);
}

void readView(Members& root, std::optional<Error>& error, std::optional<SavedView>& view) {
  const JsonValue* const value = root.value("view");
  if (value == nullptr) return;
  Members members(*value, "view", error);
  SavedView saved;
  members.number("x", saved.centre.x);
  members.number("y", saved.centre.y);
  members.number("scale", saved.scale);
  if (!error && !(saved.scale > 0.0)) members.complain("scale", fmt::format("{:g}", saved.scale), "a number above 0");
  if (!error) view = saved;
}

void readDomainPart(Members& root, std::optional<Error>& error, SessionFile& session) {
  const JsonValue* const value = root.value("domain");
  if (value == nullptr) {
    if (!error) root.refuse(wrong("there is no \"domain\"", "a session holds the domain's file name and its text"));
    return;
  }
  Members members(*value, "domain", error);
  members.text("file", session.domainFile);
  members.text("text", session.domainText);
  if (!error && session.domainText.empty())
    members.refuse(wrong("\"domain.text\" is missing or empty", "it holds the text of the domain file"));
}

void checkFormat(Members& root) {
  std::string format;
  double version = kVersion;
  root.text("format", format);
  root.number("version", version);
  if (format != kFormat)
    return root.refuse(wrong("this is no session file", "\"format\" must be \"triscope session\""));
  if (version != kVersion)
    root.refuse(wrong(fmt::format("the session has version {:g}", version), "this program reads version 1"));
}

}  // namespace

std::string sessionText(const SessionFile& s) {
  const std::string breakpoints = listOf(s.breakpoints, [](const Breakpoint& b) {
    return fmt::format("{{\"condition\": {}, \"action\": \"{}\", \"enabled\": {}}}", quoted(b.condition.text()),
                       kBreakpointActions[static_cast<std::size_t>(b.action)], b.enabled);
  });
  const std::string bookmarks = listOf(s.bookmarks, [](const Bookmark& b) {
    return fmt::format("{{\"tick\": {}, \"name\": {}}}", b.tick, quoted(b.name));
  });
  const std::string hashes = listOf(s.hashes, [](const StageHash& h) {
    return fmt::format("{{\"stage\": {}, \"round\": {}, \"tick\": {}, \"hash\": \"{:016x}\"}}",
                       jsonText(infoOf(h.stage).key), h.round, h.tick, h.hash);
  });
  const std::string view =
      s.view ? fmt::format("\n  \"view\": {{\"x\": {}, \"y\": {}, \"scale\": {}}},", jsonNumber(s.view->centre.x),
                           jsonNumber(s.view->centre.y), jsonNumber(s.view->scale))
             : "";
  const std::string savedAs = s.savedAs.empty() ? "" : fmt::format("\n  \"saved_as\": {},", quoted(s.savedAs));
  const MadeBy now = thisVersion();
  return fmt::format(
      "{{\n  \"format\": {},\n  \"version\": {:g},\n  \"program_version\": {},\n  \"method_version\": {},\n"
      "  \"domain\": {{\"file\": {}, \"text\": {}}},\n  \"settings\": "
      "{},\n"
      "  \"tick\": {},\n  \"breakpoints\": {},\n  \"bookmarks\": {},\n  \"notes\": {},{}{}\n  \"hashes\": {}\n}}\n",
      jsonText(kFormat), kVersion, jsonText(now.program), now.method, quoted(s.domainFile), quoted(s.domainText),
      settingsText(s.settings), s.tick, breakpoints, bookmarks, quoted(s.notes), view, savedAs, hashes);
}

bool isSession(std::string_view json) {
  // Nearly every domain file is told from a session without reading it through.
  if (json.find(kFormat) == std::string_view::npos) return false;
  const Result<JsonValue> parsed = parseJson(json);
  if (!parsed.ok() || parsed->object() == nullptr) return false;
  const JsonValue* const format = find(*parsed->object(), "format");
  return format != nullptr && format->text() != nullptr && *format->text() == kFormat;
}

Result<SessionFile> parseSession(std::string_view json, const std::string& fileName) {
  std::optional<Error> error;
  SessionFile session;
  const Result<JsonValue> parsed = parseJson(json);
  if (parsed.ok()) {
    Members root(*parsed, "", error);
    checkFormat(root);
    root.text("program_version", session.madeBy.program);
    root.whole("method_version", kMostMethods, session.madeBy.method);
    readDomainPart(root, error, session);
    readSettings(root, session.settings);
    root.whole("tick", kLargestWhole, session.tick);
    root.list("breakpoints", [&](Members& members) { readBreakpoint(members, session.breakpoints); });
    root.list("bookmarks", [&](Members& members) {
      Bookmark bookmark;
      members.whole("tick", kLargestWhole, bookmark.tick);
      members.text("name", bookmark.name);
      session.bookmarks.push_back(std::move(bookmark));
    });
    root.text("notes", session.notes);
    root.text("saved_as", session.savedAs);
    readView(root, error, session.view);
    root.list("hashes", [&](Members& members) { readHash(members, session.hashes); });
  } else {
    error = parsed.error();
  }
  if (!error) return session;
  error->file = fileName;
  return *error;
}

Status writeSession(const std::string& path, const SessionFile& session) {
  return writeWhole(path, sessionText(session));
}

Result<SessionFile> readSession(const std::string& path) {
  Result<std::string> text = readTextFile(path);
  if (!text.ok()) return text.error();
  return parseSession(*text, path);
}

Result<std::string> readTextFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()) || in.gcount() > 0)
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  if (in.eof()) return text;
  return Error{.kind = ErrorKind::no_input,
               .message = "the file cannot be read",
               .hint = "check its name and that you may read it",
               .file = path};
}

std::vector<StageHash> stageHashes(MeshState state, std::uint64_t limit, std::size_t most,
                                   const std::function<bool(const MeshState&)>& pulse) {
  std::vector<StageHash> hashes;
  Journal nobody;
  for (std::uint64_t beat = 1; state.stage != Stage::finished && hashes.size() < most; ++beat) {
    if (beat % kBeatsPerPulse == 0 && pulse && !pulse(state)) break;
    const Stage stage = state.stage;
    const std::uint16_t round = state.round;
    advanceUntil(state, state.method->stages.back(), 1, nobody);
    if (state.tick > limit) break;
    if (state.stage != stage) hashes.push_back({stage, round, state.tick, hashOf(state)});
  }
  return hashes;
}

}  // namespace triscope
