// A parsed JSON text as a plain tree: what the domain reader walks. Keeps members in file order.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace triscope {

struct JsonMember;

struct JsonValue {
  using List = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;
  std::variant<std::monostate, bool, double, std::string, List, Object> data;  // monostate: null

  [[nodiscard]] const double* number() const { return std::get_if<double>(&data); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&data); }
  [[nodiscard]] const List* list() const { return std::get_if<List>(&data); }
  [[nodiscard]] const Object* object() const { return std::get_if<Object>(&data); }
  /// "a number", "a list", … for messages.
  [[nodiscard]] std::string_view typeName() const;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// The value of a key, or null when there is none.
const JsonValue* find(const JsonValue::Object& object, std::string_view key);

/// Parses strict JSON. Errors: a syntax error with line and column, a key given twice in one object, a number too
/// large for a double, or nesting deeper than 64.
Result<JsonValue> parseJson(std::string_view text);

}  // namespace triscope
