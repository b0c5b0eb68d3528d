// The guard of ARCHITECTURE.md's one direction: a file may include only what lies to its left in the flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// From left to right. Files directly in src/core, such as result.h, state.h and pipeline.h, are listed by name
/// because they belong between the folders.
struct Layer {
  std::string_view path;  // prefix below src/
  int level;
};
constexpr std::array kLayers{
    Layer{"memory/", 0},
    Layer{"core/assert", 0},
    Layer{"core/geometry/", 0},
    Layer{"core/result", 1},
    Layer{"core/version", 1},
    Layer{"core/counted", 1},
    Layer{"core/digest", 1},
    Layer{"core/number", 1},
    Layer{"core/stage.h", 1},
    Layer{"core/settings", 2},
    Layer{"core/event", 2},
    Layer{"core/vocabulary", 2},
    Layer{"core/domain/", 3},
    Layer{"core/density/", 4},
    Layer{"core/mesh/", 5},
    Layer{"core/state", 6},
    Layer{"core/hash", 7},
    Layer{"core/estimate", 7},
    Layer{"core/triangle_limit", 7},
    Layer{"core/pipeline.h", 7},
    Layer{"core/stages/", 8},
    Layer{"core/pipeline.cpp", 9},
    Layer{"core/quality/", 10},
    Layer{"core/fields", 11},
    Layer{"core/caption", 11},
    Layer{"core/io/", 12},
    Layer{"core/history/", 13},
    Layer{"core/debug/", 13},
    Layer{"core/run_record", 13},
    Layer{"core/quality_trace", 13},
    Layer{"core/session", 14},
    Layer{"render/", 15},
    Layer{"ui/", 16},
    Layer{"cli/", 17},
};

std::optional<int> levelOf(std::string_view path) {
  for (const Layer& layer : kLayers)
    if (path.starts_with(layer.path)) return layer.level;
  return std::nullopt;
}

/// The text between the delimiters of an #include line, or nothing.
std::optional<std::string> included(std::string_view line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string_view::npos || !line.substr(hash).starts_with("#include")) return std::nullopt;
  const std::size_t open = line.find_first_of("\"<", hash);
  const std::size_t close = line.find_first_of("\">", open + 1);
  if (open == std::string_view::npos || close == std::string_view::npos) return std::nullopt;
  return std::string(line.substr(open + 1, close - open - 1));
}

/// What is wrong with `file` (below src/) including `header`; empty when nothing is.
std::string complaint(std::string_view file, std::string_view header) {
  if (file.starts_with("core/")) {
    for (const std::string_view outsider : {"glad", "GL/", "GLFW", "imgui", "EGL", "glm", "backends/imgui"})
      if (header.starts_with(outsider)) return "src/core knows no windows and no OpenGL";
  }
  if (file.starts_with("render/")) {
    for (const std::string_view outsider : {"GLFW", "imgui", "backends/imgui"})
      if (header.starts_with(outsider)) return "src/render knows no windows";
  }
  if (file.ends_with(".h")) {
    for (const std::string_view heavy : {"nlohmann/", "CLI/"})
      if (header.starts_with(heavy)) return "slow to compile: include it in a .cpp";
  }
  const std::optional<int> from = levelOf(file);
  const std::optional<int> to = levelOf(header);
  if (!from) return "no layer is known for this file: add it to kLayers";
  if (to && *to > *from) return "the arrow points back";
  return {};
}

TEST(Includes, PointOnlyToTheLeft) {
  const fs::path root = fs::path(TRISCOPE_SOURCE_DIR) / "src";
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  ASSERT_GT(files.size(), 10u) << "no sources under " << root;
  for (const fs::path& path : files) {
    const std::string file = path.lexically_relative(root).generic_string();
    std::ifstream stream(path);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      const std::optional<std::string> header = included(line);
      if (!header) continue;
      const std::string wrong = complaint(file, *header);
      EXPECT_TRUE(wrong.empty()) << "src/" << file << ":" << number << " includes " << *header << ": " << wrong;
      if (line.find('"') != std::string::npos && fs::exists(root / *header)) continue;
      EXPECT_FALSE(levelOf(*header)) << "src/" << file << ":" << number << ": no such file: " << *header;
    }
  }
}

/// At the start of a run there is no tree: whoever looks at a state asks wantedAt() and cellOf() of wanted.h.
TEST(Includes, ViewersDoNotReadATreeThatMayBeEmpty) {
  const fs::path root = fs::path(TRISCOPE_SOURCE_DIR) / "src";
  for (const char* const folder : {"core/debug", "render", "ui", "cli"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      std::ifstream stream(entry.path());
      std::string line;
      for (int number = 1; std::getline(stream, line); ++number)
        for (const std::string_view call : {"edgeLengthAt(", "densityRankAt(", "leafAt("})
          EXPECT_EQ(line.find(call), std::string::npos) << entry.path() << ":" << number << ": " << line;
    }
}

/// A rank is a multiple of the tree's length and not of the Δx in force: only the density multiplies, in edgeLengthOf()
/// and lengthWanted().
TEST(Includes, TheLengthOfARankIsWorkedOutByTheDensityAlone) {
  const fs::path root = fs::path(TRISCOPE_SOURCE_DIR) / "src";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().lexically_relative(root).generic_string().starts_with("core/density/")) continue;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
      EXPECT_EQ(line.find("rankLength("), std::string::npos) << entry.path() << ":" << number << ": " << line;
  }
}

TEST(Includes, TheGuardSeesWhatItMustRefuse) {
  EXPECT_EQ(complaint("core/mesh/mesh.cpp", "core/geometry/point.h"), "");
  EXPECT_NE(complaint("core/geometry/point.h", "core/mesh/mesh.h"), "");
  EXPECT_NE(complaint("core/mesh/mesh.cpp", "core/pipeline.h"), "");
  EXPECT_NE(complaint("core/io/report.cpp", "render/figure.h"), "");
  EXPECT_NE(complaint("core/mesh/mesh.cpp", "GLFW/glfw3.h"), "");
  EXPECT_NE(complaint("core/io/report.h", "nlohmann/json.hpp"), "");
  EXPECT_NE(complaint("render/scene.cpp", "imgui.h"), "");
  EXPECT_NE(complaint("somewhere/else.cpp", "vector"), "");
  EXPECT_EQ(included("  #include \"core/event.h\"  // why"), "core/event.h");
  EXPECT_EQ(included("#include <vector>"), "vector");
  EXPECT_EQ(included("// #include <vector>"), std::nullopt);
}

}  // namespace
