// Real files: all are accepted, except those that touch or cross.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/domain/outline.h"
#include "core/domain/read.h"

namespace triscope::domain_files_test {
namespace {

namespace fs = std::filesystem;

/// The JSON files of a folder in the order of their names; none when there is no such folder.
std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Domains that may not be copied into the project: read in place where they are.
fs::path elsewhere() {
  const char* folder = std::getenv("TRISCOPE_DOMAIN_CASES");
  return folder != nullptr ? folder : TRISCOPE_SOURCE_DIR "/../shared/domains";
}

void expectAccepted(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const auto domain = readDomain(file);
    ASSERT_TRUE(domain.ok()) << describe(domain.error());
    EXPECT_EQ(domain->loops[0].role, LoopRole::outer);
    for (std::uint32_t i = 0; i < domain->loops.size(); ++i) {
      double area = 0.0;
      for (const Chord& chord : outlineOf(*domain, i)) {
        area += cross(chord.a - domain->bounds.lo, chord.b - domain->bounds.lo);
      }
      const LoopRole role = domain->loops[i].role;
      if (role != LoopRole::chain) {
        EXPECT_EQ(area > 0.0, role == LoopRole::outer) << file << ", " << domain->loops[i].name;
      }
    }
  }
}

TEST(DomainFiles, TestDataIsAccepted) {
  const auto files = filesIn(TRISCOPE_SOURCE_DIR "/tests/data/domains");
  EXPECT_GE(files.size(), 10u);
  expectAccepted(files);
}

TEST(DomainFiles, DomainsElsewhereAreAccepted) {
  const auto files = filesIn(elsewhere());
  if (files.empty()) GTEST_SKIP() << "no domains in " << elsewhere();
  expectAccepted(files);
}

TEST(DomainFiles, DomainsThatTouchOrCrossAreRefusedWithAPlace) {
  const auto files = filesIn(elsewhere() / "invalid");
  if (files.empty()) GTEST_SKIP() << "no domains in " << elsewhere() / "invalid";
  for (const std::string& file : files) {
    const auto domain = readDomain(file);
    ASSERT_FALSE(domain.ok()) << file;
    EXPECT_EQ(domain.error().kind, ErrorKind::bad_data);
    EXPECT_FALSE(domain.error().loop.empty()) << describe(domain.error());
    EXPECT_TRUE(domain.error().at.has_value()) << describe(domain.error());
  }
}

}  // namespace
}  // namespace triscope::domain_files_test
