#include "core/domain/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/base/json_value.h"
#include "core/base/shown_text.h"
#include "core/domain/check.h"
#include "core/domain/draft.h"
#include "core/domain/read_density.h"
#include "core/domain/read_loop.h"
#include "core/domain/read_values.h"

namespace triscope {

namespace {

using Object = JsonValue::Object;

constexpr std::array<std::string_view, 6> kDomainKeys{"name",  "min_edge_length", "outer",
                                                      "holes", "segments",        "density"};
// The quadtree counts cells of side 4 min_edge_length in 32 bits.
constexpr double kFinest = 1e-9;  // of the domain's larger side

/// Other keys are the author's own, unless they look like a slip of the finger.
Status checkTopKeys(const Object& root) {
  for (const JsonMember& member : root) {
    if (std::find(kDomainKeys.begin(), kDomainKeys.end(), member.key) != kDomainKeys.end()) continue;
    const std::string_view meant = nearestKey(member.key, kDomainKeys);
    if (meant.empty()) continue;
    return complaint({}, fmt::format("unknown key \"{}\"", shown(member.key)),
                     fmt::format("did you mean \"{}\"?", meant));
  }
  return success();
}

Status readList(const Object& root, std::string_view key, LoopRole role, DomainDraft& draft) {
  const JsonValue* value = find(root, key);
  if (value == nullptr) return success();
  if (value->list() == nullptr) {
    return complaint({}, fmt::format("\"{}\" is {}, not a list", key, value->typeName()),
                     fmt::format("write \"{}\": [ … ] with one entry for each", key));
  }
  int number = 0;
  for (const JsonValue& item : *value->list()) {
    if (auto status = readLoop(item, role, ++number, draft); !status) return status;
  }
  return success();
}

Status checkNames(const Domain& domain) {
  std::vector<std::string_view> names;
  names.reserve(domain.loops.size());
  for (const Loop& loop : domain.loops) names.emplace_back(loop.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return success();
  return complaint({std::string(*twice)}, "two loops have this name", "give each its own name");
}

Status readLoops(const Object& root, DomainDraft& draft) {
  const JsonValue* outer = find(root, "outer");
  if (outer == nullptr) {
    return complaint({}, "there is no \"outer\" loop",
                     "add \"outer\": [[x, y], …], the boundary that encloses the domain");
  }
  if (auto status = readLoop(*outer, LoopRole::outer, 0, draft); !status) return status;
  if (auto status = readList(root, "holes", LoopRole::hole, draft); !status) return status;
  if (auto status = readList(root, "segments", LoopRole::chain, draft); !status) return status;
  return checkNames(draft.domain);
}

Status readMinEdgeLength(const Object& root, Domain& domain) {
  const JsonValue* value = find(root, "min_edge_length");
  if (value == nullptr) return success();
  const auto length = readPositive(*value, "min_edge_length", {});
  if (!length) return length.error();
  const double side = std::max(domain.bounds.width(), domain.bounds.height());
  domain.minEdgeLength = *length;
  if (*length >= kFinest * side && *length < side) return success();
  return complaint({}, fmt::format("\"min_edge_length\" is {}, but the domain is {} wide", *length, side),
                   fmt::format("give a length from {} up to less than {}", kFinest * side, side));
}

std::string stemOf(const std::string& file) { return std::filesystem::path(file).stem().string(); }

Result<Domain> parse(std::string_view json, const std::string& fileName) {
  const auto tree = parseJson(json);
  if (!tree) return tree.error();
  const Object* root = tree->object();
  if (root == nullptr) {
    return complaint({}, fmt::format("the file holds {}, not an object", tree->typeName()),
                     "a domain file looks like {\"outer\": [[x, y], …], \"holes\": [ … ]}");
  }
  if (auto status = checkTopKeys(*root); !status) return status.error();
  DomainDraft draft;
  draft.domain.file = fileName;
  auto name = readText(*root, "name", {}, stemOf(fileName));
  if (!name) return name.error();
  draft.domain.name = std::move(*name);
  if (auto status = readLoops(*root, draft); !status) return status.error();
  auto domain = checkDomain(std::move(draft));
  if (!domain) return domain;
  if (auto status = readMinEdgeLength(*root, *domain); !status) return status.error();
  if (const JsonValue* density = find(*root, "density")) {
    if (auto status = readDensity(*density, *domain); !status) return status.error();
  }
  return domain;
}

}  // namespace

Result<Domain> readDomain(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof()) {
    return Error{.kind = ErrorKind::no_input,
                 .message = "the file cannot be read",
                 .hint = "check its name and that you may read it",
                 .file = path};
  }
  return parseDomain(text, path);
}

Result<Domain> parseDomain(std::string_view json, const std::string& fileName) {
  auto domain = parse(json, fileName);
  if (domain) {
    domain->text = json;
    return domain;
  }
  Error error = domain.error();
  error.file = fileName;
  return error;
}

}  // namespace triscope
