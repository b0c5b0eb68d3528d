#include "core/base/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/base/shown_text.h"

namespace triscope {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr int kNumberOverflow = 406;  // the JSON library's number for it

/// Builds the tree from the parser's events; stops at the first thing that is wrong.
class TreeBuilder {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() { return add({std::monostate{}}); }
  bool boolean(bool value) { return add({value}); }
  bool number_integer(std::int64_t value) { return add({static_cast<double>(value)}); }
  bool number_unsigned(std::uint64_t value) { return add({static_cast<double>(value)}); }
  bool number_float(double value, const std::string&) { return add({value}); }
  bool string(std::string& value) { return add({std::move(value)}); }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // never sent for text

  bool start_object(std::size_t) { return open({JsonValue::Object{}}); }
  bool end_object() { return keysDiffer(std::get<JsonValue::Object>(open_.back()->data)) && close(); }
  bool start_array(std::size_t) { return open({JsonValue::List{}}); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    std::get<JsonValue::Object>(open_.back()->data).push_back({std::move(name), {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& exception) {
    // The position counts the bytes read, the offending one included; past the end it counts the end as one.
    const std::size_t offset = position == 0 ? 0 : position - 1;
    const std::string_view before = text_.substr(0, std::min(offset, text_.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 == 0
    if (exception.id == kNumberOverflow) {
      error.message =
          fmt::format("the number {} ending at line {}, column {} is too large", shown(token), line, column);
      error.hint = "use finite numbers of magnitude below 1e30";
    } else {
      error.message = fmt::format("not valid JSON at line {}, column {}: unexpected {}", line, column, found(offset));
      error.hint = "correct the text there; JSON has no comments, no trailing commas, and no NaN or Infinity";
    }
    return false;
  }

  JsonValue root;
  Error error;

 private:
  [[nodiscard]] std::string found(std::size_t offset) const {
    if (offset >= text_.size()) return "end of the text";
    const char byte = text_[offset];
    if (byte >= ' ' && byte <= '~') return fmt::format("'{}'", byte);
    return fmt::format("byte 0x{:02x}", static_cast<unsigned char>(byte));
  }

  bool keysDiffer(const JsonValue::Object& object) {
    std::vector<std::string_view> keys;
    for (const JsonMember& member : object) keys.emplace_back(member.key);
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice == keys.end()) return true;
    error.message = fmt::format("the key \"{}\" is given twice in one object", shown(*twice));
    error.hint = "keep one of the two";
    return false;
  }

  JsonValue* add(JsonValue value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    JsonValue& parent = *open_.back();
    if (auto* list = std::get_if<JsonValue::List>(&parent.data)) return &list->emplace_back(std::move(value));
    JsonValue& slot = std::get<JsonValue::Object>(parent.data).back().value;
    slot = std::move(value);
    return &slot;
  }

  bool open(JsonValue value) {
    if (open_.size() == kDeepest) {
      error.message = fmt::format("nested deeper than {} lists or objects", kDeepest);
      error.hint = "this is not a domain file";
      return false;
    }
    open_.push_back(add(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  // Containers being filled. Stable: a parent's list grows only while none of its children is open.
  std::vector<JsonValue*> open_;
};

}  // namespace

std::string_view JsonValue::typeName() const {
  constexpr std::string_view names[] = {"null", "true or false", "a number", "a text", "a list", "an object"};
  return names[data.index()];
}

const JsonValue* find(const JsonValue::Object& object, std::string_view key) {
  for (const JsonMember& member : object) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

Result<JsonValue> parseJson(std::string_view text) {
  TreeBuilder builder(text);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.error);
  return std::move(builder.root);
}

}  // namespace triscope
