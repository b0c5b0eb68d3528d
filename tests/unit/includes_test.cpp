// The guard of ARCHITECTURE.md's one direction: a file may include only what lies on its own floor or below.
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

/// The floors of the house below src/, from the ground up: a file includes what lies on its own floor or below.
constexpr std::array<std::string_view, 23> kFloors{
    "memory/",       "core/base/",     "core/geometry/", "core/words/",  "core/domain/", "core/density/",
    "core/mesh/",    "core/optimise/", "core/quality/",  "core/method/", "core/io/",     "core/run/",
    "core/explain/", "core/study/",    "core/session/",  "render/",      "ui/model/",    "ui/kit/",
    "ui/panel/",     "ui/dialog/",     "ui/region/",     "ui/app/",      "cli/",
};

std::optional<std::size_t> floorOf(std::string_view path) {
  for (std::size_t k = 0; k < kFloors.size(); ++k)
    if (path.starts_with(kFloors[k])) return k;
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
  const std::optional<std::size_t> from = floorOf(file);
  const std::optional<std::size_t> to = floorOf(header);
  if (!from) return "this folder has no floor: add it to kFloors";
  if (to && *to > *from) return "the arrow points up";
  return {};
}

TEST(Includes, PointOnlyDown) {
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
      EXPECT_FALSE(floorOf(*header)) << "src/" << file << ":" << number << ": no such file: " << *header;
    }
  }
}

/// At the start of a run there is no tree: whoever looks at a state asks wantedAt() and cellOf() of wanted.h.
TEST(Includes, ViewersDoNotReadATreeThatMayBeEmpty) {
  const fs::path root = fs::path(TRISCOPE_SOURCE_DIR) / "src";
  for (const char* const folder : {"core/run", "core/explain", "core/study", "render", "ui", "cli"})
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
  EXPECT_EQ(complaint("core/mesh/mesh.cpp", "core/base/point.h"), "");
  EXPECT_NE(complaint("core/base/point.h", "core/mesh/mesh.h"), "");
  EXPECT_NE(complaint("core/mesh/mesh.cpp", "core/method/pipeline.h"), "");
  EXPECT_NE(complaint("core/io/report.cpp", "render/figure.h"), "");
  EXPECT_NE(complaint("core/mesh/mesh.cpp", "GLFW/glfw3.h"), "");
  EXPECT_NE(complaint("core/io/report.h", "nlohmann/json.hpp"), "");
  EXPECT_NE(complaint("render/scene.cpp", "imgui.h"), "");
  EXPECT_NE(complaint("somewhere/else.cpp", "vector"), "");
  EXPECT_EQ(included("  #include \"core/words/event.h\"  // why"), "core/words/event.h");
  EXPECT_EQ(included("#include <vector>"), "vector");
  EXPECT_EQ(included("// #include <vector>"), std::nullopt);
}

}  // namespace
