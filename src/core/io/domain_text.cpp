#include "core/io/domain_text.h"

#include <fmt/format.h>

#include "core/base/json_text.h"
#include "core/base/json_value.h"

namespace triscope {
namespace {

/// Past the string that begins at `at`.
std::size_t afterString(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return at + 1;
}

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::size_t afterSpace(std::string_view json, std::size_t at) {
  while (at < json.size() && isSpace(json[at])) ++at;
  return at;
}

/// Past the value that begins at `at`: a list or an object to its bracket, anything else to the next sign.
std::size_t afterValue(std::string_view json, std::size_t at) {
  int depth = 0;
  while (at < json.size()) {
    const char c = json[at];
    if (c == '"') {
      at = afterString(json, at);
    } else {
      const bool closes = c == ']' || c == '}';
      if (depth == 0 && (closes || c == ',' || isSpace(c))) return at;
      depth += c == '[' || c == '{' ? 1 : closes ? -1 : 0;
      ++at;
      if (closes && depth == 0) return at;
      continue;
    }
    if (depth == 0) return at;
  }
  return at;
}

struct Range {
  std::size_t from = std::string_view::npos;
  std::size_t to = std::string_view::npos;
};

/// Where the value of a member of the outermost object is; from is npos when there is no such member, and then to is
/// where the last value ends.
Range memberOf(std::string_view json, std::string_view key) {
  std::size_t at = json.find('{') + 1;
  std::size_t last = at;
  for (at = afterSpace(json, at); at < json.size() && json[at] == '"'; at = afterSpace(json, at)) {
    const std::size_t end = afterString(json, at);
    const Result<JsonValue> name = parseJson(json.substr(at, end - at));  // it may be written with escapes
    const std::size_t value = afterSpace(json, json.find(':', end) + 1);
    last = afterValue(json, value);
    if (name.ok() && name->text() != nullptr && *name->text() == key) return {value, last};
    at = afterSpace(json, last);
    if (at < json.size() && json[at] == ',') ++at;
  }
  return {std::string_view::npos, last};
}

std::string pointText(Point p) { return fmt::format("[{}, {}]", jsonNumber(p.x), jsonNumber(p.y)); }

std::string requestText(const DensityRequest& request) {
  std::string text = "{";
  if (!request.name.empty()) text += fmt::format("\"name\": {}, ", jsonText(request.name));
  if (!request.description.empty()) text += fmt::format("\"description\": {}, ", jsonText(request.description));
  switch (request.where) {
    case DensityRequest::Where::point:
      text += fmt::format("\"at\": {}", pointText(request.at));
      break;
    case DensityRequest::Where::loop:
      text += fmt::format("\"loop\": {}", jsonText(request.loop));
      break;
    case DensityRequest::Where::box:
      text += fmt::format("\"box\": [{}, {}]", pointText(request.at), pointText(request.to));
      break;
  }
  return text + (request.rank > 0 ? fmt::format(", \"rank\": {}}}", request.rank)
                                  : fmt::format(", \"length\": {}}}", jsonNumber(request.length)));
}

std::string listText(const std::vector<DensityRequest>& density) {
  std::string text;
  for (const DensityRequest& request : density)
    text += fmt::format("{}\n    {}", text.empty() ? "" : ",", requestText(request));
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

}  // namespace

std::string withDensity(std::string_view file, const std::vector<DensityRequest>& density) {
  const Range list = memberOf(file, "density");
  std::string text(file);
  if (list.from != std::string_view::npos) return text.replace(list.from, list.to - list.from, listText(density));
  if (density.empty()) return text;
  return text.insert(list.to, ",\n  \"density\": " + listText(density));
}

std::shared_ptr<const Domain> withDensity(const Domain& domain, std::vector<DensityRequest> density) {
  auto edited = std::make_shared<Domain>(domain);
  edited->density = std::move(density);
  edited->text = withDensity(domain.text, edited->density);
  return edited;
}

}  // namespace triscope
