// The samples: each is read, says what it is for, follows the schema of the docs, and comes out of its script.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/domain/read.h"

namespace triscope::domain_samples_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kSamples = TRISCOPE_SOURCE_DIR "/assets/domains";

std::string textOf(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<fs::path> samples() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kSamples)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The part of JSON Schema that docs/domain.schema.json uses; an unknown keyword fails.
class Schema {
 public:
  explicit Schema(json root) : root_(std::move(root)) {}

  [[nodiscard]] bool accepts(const json& value) const { return accepts(root_, value); }

 private:
  [[nodiscard]] bool accepts(const json& schema, const json& value) const {
    return std::all_of(schema.items().begin(), schema.items().end(),
                       [&](const auto& entry) { return holds(entry.key(), entry.value(), schema, value); });
  }

  [[nodiscard]] bool holds(const std::string& word, const json& rule, const json& schema, const json& value) const {
    if (word == "$schema" || word == "title" || word == "description" || word == "$defs") return true;
    if (word == "$ref") return accepts(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (word == "type") return hasType(rule.get<std::string>(), value);
    if (word == "const") return value == rule;
    if (word == "anyOf" || word == "oneOf" || word == "allOf") {
      const auto count = static_cast<std::size_t>(
          std::count_if(rule.begin(), rule.end(), [&](const json& option) { return accepts(option, value); }));
      return word == "anyOf" ? count > 0 : word == "oneOf" ? count == 1 : count == rule.size();
    }
    if (value.is_object()) {
      if (word == "required") {
        return std::all_of(rule.begin(), rule.end(), [&](const json& key) { return value.contains(key); });
      }
      if (word == "properties") {
        return std::all_of(rule.items().begin(), rule.items().end(), [&](const auto& property) {
          return !value.contains(property.key()) || accepts(property.value(), value.at(property.key()));
        });
      }
      if (word == "additionalProperties") {
        return std::all_of(value.items().begin(), value.items().end(),
                           [&](const auto& member) { return schema.at("properties").contains(member.key()); });
      }
    }
    if (word == "items") {
      return !value.is_array() ||
             std::all_of(value.begin(), value.end(), [&](const json& item) { return accepts(rule, item); });
    }
    if (word == "minItems") return !value.is_array() || value.size() >= rule;
    if (word == "maxItems") return !value.is_array() || value.size() <= rule;
    if (word == "minLength") return !value.is_string() || value.get<std::string>().size() >= rule;
    if (word == "minimum") return !value.is_number() || value >= rule;
    if (word == "maximum") return !value.is_number() || value <= rule;
    if (word == "exclusiveMinimum") return !value.is_number() || value > rule;
    if (word == "exclusiveMaximum") return !value.is_number() || value < rule;
    if (word == "required" || word == "properties" || word == "additionalProperties") return true;
    ADD_FAILURE() << "the test does not know the keyword " << word;
    return false;
  }

  static bool hasType(const std::string& type, const json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "integer") return value.is_number_integer();
    return type == "number" && value.is_number();
  }

  json root_;
};

Schema schema() { return Schema(json::parse(textOf(TRISCOPE_SOURCE_DIR "/docs/domain.schema.json"))); }

TEST(DomainSamples, AreReadAndSayWhatTheyAreFor) {
  EXPECT_GE(samples().size(), 11u);
  for (const fs::path& path : samples()) {
    const auto domain = readDomain(path.string());
    ASSERT_TRUE(domain.ok()) << describe(domain.error());
    const json file = json::parse(textOf(path));
    EXPECT_EQ(domain->name, file.at("name").get<std::string>());
    EXPECT_GT(file.at("description").get<std::string>().size(), 40u) << path;
  }
}

TEST(DomainSamples, FollowTheSchema) {
  const Schema rules = schema();
  for (const fs::path& path : samples()) EXPECT_TRUE(rules.accepts(json::parse(textOf(path)))) << path;
  for (const auto& entry : fs::directory_iterator(TRISCOPE_SOURCE_DIR "/tests/data/domains")) {
    if (entry.path().extension() != ".json") continue;
    EXPECT_TRUE(rules.accepts(json::parse(textOf(entry.path())))) << entry.path();
  }
}

/// Whatever the reader refuses for its shape alone, the schema refuses too, and the other way round.
TEST(DomainSamples, SchemaAndReaderAgree) {
  const Schema rules = schema();
  const std::string square = R"("outer": [[0,0],[9,0],[9,9],[0,9]])";
  const std::vector<std::string> right{
      "{" + square + "}",
      "{" + square + R"(, "note": [1, {"x": null}]})",
      R"({"outer": {"points": [[0,0],[9,0],[0,9]]}})",
      R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": [0], "corner_turn": 30.5}})",
      R"({"outer": {"kind": "circle", "centre": [0,0], "radius": 3, "description": "round"}})",
      R"({"outer": {"kind": "circle", "center": [0,0], "radius": 3}})",
      R"({"outer": {"kind": "pieces", "pieces": [{"points": [[0,0],[9,0]]},
                    {"kind": "arc", "points": [[9,0],[5,5],[0,0]]}]}})",
      "{" + square + R"(, "segments": [[[1,1],[2,2]], {"kind": "spline", "points": [[3,3],[4,4]]},
                         {"name": "w", "kind": "polyline", "points": [[5,5],[6,5]]}, {"pieces": [{"points": [[7,7],[8,8]]}]}]})",
      "{" + square + R"(, "density": [{"at": [1,1], "rank": 1}, {"loop": "outer", "length": 1},
                         {"name": "n", "box": [[1,1],[2,2]], "rank": 64}], "min_edge_length": 0.5})"};
  const std::vector<std::string> wrong{
      "[]",
      "{}",
      R"({"outer": 1})",
      R"({"outer": [[0,0],[9,0]]})",
      R"({"outer": [[0,0],[9,0],[0,9,1]]})",
      R"({"outer": [[0,0],[9,0],[0,"9"]]})",
      R"({"outer": [[0,0],[9,0],[0,1e31]]})",
      R"({"outer": {"kind": "ellipse", "points": [[0,0],[9,0],[0,9]]}})",
      R"({"outer": {"kind": "polygon"}})",
      R"({"outer": {"points": [[0,0],[9,0],[0,9]], "corners": [0]}})",
      R"({"outer": {"points": [[0,0],[9,0],[0,9]], "name": ""}})",
      R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corner_turn": 0}})",
      R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": [-1]}})",
      R"({"outer": {"kind": "circle", "centre": [0,0], "radius": -1}})",
      R"({"outer": {"kind": "circle", "centre": [0,0]}})",
      R"({"outer": {"kind": "circle", "radius": 1}})",
      R"({"outer": {"kind": "circle", "centre": [0,0], "center": [0,0], "radius": 1}})",
      R"({"outer": {"pieces": []}})",
      R"({"outer": {"pieces": [{"kind": "arc", "points": [[9,0],[0,0]]}]}})",
      "{" + square + R"(, "holes": {}})",
      "{" + square + R"(, "name": 1})",
      "{" + square + R"(, "min_edge_length": 0})",
      "{" + square + R"(, "segments": [[[1,1]]]})",
      "{" + square + R"(, "segments": [{"kind": "circle", "centre": [3,3], "radius": 1}]})",
      "{" + square + R"(, "density": [{"at": [1,1]}]})",
      "{" + square + R"(, "density": [{"at": [1,1], "loop": "outer", "rank": 1}]})",
      "{" + square + R"(, "density": [{"at": [1,1], "rank": 65}]})",
      "{" + square + R"(, "density": [{"at": [1,1], "rank": 1.5}]})",
      "{" + square + R"(, "density": [{"at": [1,1], "rank": 1, "lenght": 1}]})"};
  for (const std::string& text : right) {
    const auto domain = parseDomain(text, "");
    EXPECT_TRUE(domain.ok()) << text << "\n" << describe(domain.error());
    EXPECT_TRUE(rules.accepts(json::parse(text))) << text;
  }
  for (const std::string& text : wrong) {
    EXPECT_FALSE(parseDomain(text, "").ok()) << text;
    EXPECT_FALSE(rules.accepts(json::parse(text))) << text;
  }
}

/// The examples in the docs are files that work.
TEST(DomainSamples, ExamplesInTheDocsAreRead) {
  const std::string docs = textOf(TRISCOPE_SOURCE_DIR "/docs/domain-format.md");
  const Schema rules = schema();
  const std::string fence = "```json\n";
  int count = 0;
  for (std::size_t at = docs.find(fence); at != std::string::npos; at = docs.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    const std::string text = docs.substr(begin, docs.find("```", begin) - begin);
    const auto domain = parseDomain(text, "docs");
    EXPECT_TRUE(domain.ok()) << text << describe(domain.error());
    EXPECT_TRUE(rules.accepts(json::parse(text))) << text;
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST(DomainSamples, TheScriptWritesThemAgain) {
  const fs::path folder = fs::temp_directory_path() / ("triscope_samples_" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string command = "python3 '" + (kSamples / "generate.py").string() + "' '" + folder.string() + "'";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "python3 cannot run generate.py";
  int count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(textOf(entry.path()), textOf(kSamples / entry.path().filename())) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 3);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace triscope::domain_samples_test
