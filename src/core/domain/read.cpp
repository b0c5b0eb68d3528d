#include "core/domain/read.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <utility>

#include "core/domain/check.h"
#include "core/domain/draft.h"
#include "core/domain/json_value.h"
#include "core/domain/read_loop.h"

namespace triscope {

namespace {

Status readLoops(const JsonValue::Object& root, DomainDraft& draft) {
  const JsonValue* outer = find(root, "outer");
  if (outer == nullptr) {
    return Error{.message = "there is no \"outer\" loop",
                 .hint = "add \"outer\": [[x, y], …], the boundary that encloses the domain"};
  }
  if (auto status = readLoop(*outer, LoopRole::outer, 0, draft); !status) return status;
  constexpr std::pair<std::string_view, LoopRole> lists[] = {{"holes", LoopRole::hole}, {"segments", LoopRole::chain}};
  for (const auto& [key, role] : lists) {
    const JsonValue* value = find(root, key);
    if (value == nullptr) continue;
    if (value->list() == nullptr) {
      return Error{.message = fmt::format("\"{}\" is {}, not a list", key, value->typeName()),
                   .hint = fmt::format("write \"{}\": [ … ] with one entry for each", key)};
    }
    int number = 0;
    for (const JsonValue& item : *value->list()) {
      if (auto status = readLoop(item, role, ++number, draft); !status) return status;
    }
  }
  return success();
}

Result<Domain> parse(std::string_view json, const std::string& fileName) {
  const auto tree = parseJson(json);
  if (!tree) return tree.error();
  const JsonValue::Object* root = tree->object();
  if (root == nullptr) {
    return Error{.message = fmt::format("the file holds {}, not an object", tree->typeName()),
                 .hint = "a domain file looks like {\"outer\": [[x, y], …], \"holes\": [ … ]}"};
  }
  DomainDraft draft;
  draft.domain.file = fileName;
  if (auto status = readLoops(*root, draft); !status) return status.error();
  return checkDomain(std::move(draft));
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
    return Error{.code = ExitCode::no_input,
                 .message = "the file cannot be read",
                 .hint = "check its name and that you may read it",
                 .file = path};
  }
  return parseDomain(text, path);
}

Result<Domain> parseDomain(std::string_view json, const std::string& fileName) {
  auto domain = parse(json, fileName);
  if (domain) return domain;
  Error error = domain.error();
  error.file = fileName;
  return error;
}

}  // namespace triscope
