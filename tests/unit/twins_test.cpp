// One name, one type: two types of one name in one namespace go well until some file includes both, and where none does
// the linker takes the one for the other without a word.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// C++ without what only looks like code: comments, texts and lines of the preprocessor.
std::string bare(const std::string& source) {
  static const std::regex kNoCode(
      R"re(//[^\n]*|/\*[^]*?\*/|R"(\w*)\([^]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|(?:^|\n)[ \t]*#[^\n]*)re");
  return std::regex_replace(source, kNoCode, " ");
}

/// Full names of the types that a source defines in a namespace. An unnamed namespace is named after its file, which
/// alone can see into it; types within types and within functions belong to these.
std::vector<std::string> typesDefinedIn(const std::string& source, const std::string& file) {
  static const std::regex kNamespace(R"(\bnamespace\s*([\w:]*)\s*$)");
  static const std::regex kType(
      R"(^\s*(?:template\s*<[^]*>\s*)?(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(\w+)\s*(?:final\s*)?(?::[^]*)?$)");
  std::vector<std::string> found;
  std::vector<std::string> spaces;  // that are open, one in the other
  int bodies = 0;                   // of types and functions, likewise
  std::string statement;
  for (const char c : bare(source)) {
    std::smatch match;
    if (c == '{') {
      std::string space;
      for (const std::string& one : spaces) space += one + "::";
      if (bodies == 0 && std::regex_search(statement, match, kNamespace)) {
        spaces.push_back(match[1].length() > 0 ? match[1].str() : "(" + file + ")");
      } else {
        if (bodies == 0 && std::regex_match(statement, match, kType)) found.push_back(space + match[1].str());
        ++bodies;
      }
    } else if (c == '}') {
      if (bodies > 0)
        --bodies;
      else if (!spaces.empty())
        spaces.pop_back();
    }
    if (c == '{' || c == '}' || c == ';')
      statement.clear();
    else
      statement += c;
  }
  return found;
}

/// Files that define each type of src/, by its full name.
std::map<std::string, std::vector<std::string>> definedInSources() {
  const fs::path root = fs::path(TRISCOPE_SOURCE_DIR) / "src";
  std::map<std::string, std::vector<std::string>> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    const std::string file = entry.path().lexically_relative(root).generic_string();
    std::ifstream stream(entry.path());
    const std::string source(std::istreambuf_iterator<char>(stream), {});
    for (const std::string& type : typesDefinedIn(source, file)) files[type].push_back(file);
  }
  EXPECT_GT(files.size(), 100u) << "no sources under " << root;
  return files;
}

TEST(Twins, NoTwoTypesOfANamespaceHaveOneName) {
  for (auto [type, where] : definedInSources()) {
    std::sort(where.begin(), where.end());
    std::string list;
    for (const std::string& file : where) list += " src/" + file;
    EXPECT_EQ(where.size(), 1u) << type << " is defined in" << list;
  }
}

// Whoever reads such a file takes the one for the other, and so does the compiler as soon as the file includes both.
TEST(Twins, NoFileHasATypeOfItsOwnUnderANameThatEverybodyHas) {
  const auto files = definedInSources();
  for (const auto& [type, where] : files) {
    const std::size_t open = type.find("(");
    if (open == std::string::npos) continue;
    const std::string name = type.substr(type.rfind(':') + 1);
    const auto common = files.find(type.substr(0, open) + name);
    EXPECT_EQ(common, files.end()) << "src/" << where.front() << " has a " << name << " of its own beside that of src/"
                                   << (common == files.end() ? "" : common->second.front());
  }
}

TEST(Twins, TheGuardSeesDefinitionsAndNothingElse) {
  const auto types = [](const std::string& source) { return typesDefinedIn(source, "a.cpp"); };
  using Names = std::vector<std::string>;
  EXPECT_EQ(types("namespace n {\nstruct A {\n  int x;\n};\nenum class B : int { c };\n}"), (Names{"n::A", "n::B"}));
  EXPECT_EQ(types("namespace n::m { class A final : public B {}; }"), Names{"n::m::A"});
  EXPECT_EQ(types("namespace n { namespace { struct A {}; } struct A {}; }"), (Names{"n::(a.cpp)::A", "n::A"}));
  EXPECT_EQ(types("template <class T>\nstruct A {};\n"), Names{"A"});
  EXPECT_EQ(types("#include \"x.h\"\nstruct A {};\n"), Names{"A"});
  EXPECT_EQ(types("struct A;\nenum B : int;\nvoid f() { struct C {}; }\nstruct D { struct E {}; };"), Names{"D"});
  EXPECT_EQ(types("struct A f() { return {}; }\nconst char* s = \"struct B {\"; // struct C {\n/* struct D { */"),
            Names{});
  EXPECT_EQ(types("const char c = '{';\nconst char* s = R\"(struct A {)\";\nstruct B {};"), Names{"B"});
}

}  // namespace
