// Files that appear together or not at all, and which names are one file.
#include "core/base/output_set.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/base/file_identity.h"
#include "core/base/temporary_name.h"

namespace triscope::output_set_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "triscope-out-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename().string());
    return names;
  }
  [[nodiscard]] std::string contents(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  [[nodiscard]] mode_t modeOf(const std::string& name) const {
    struct stat info{};
    EXPECT_EQ(::stat(path(name).c_str(), &info), 0);
    return info.st_mode & 07777;
  }

  fs::path folder_;
};

using Names = std::set<std::string>;

TEST_F(Outputs, AppearTogetherWhenCommitted) {
  put("a", "old");
  OutputSet set;
  ASSERT_TRUE(set.write(path("a"), "new a").ok());
  ASSERT_TRUE(set.write(path("b"), "new b").ok());
  EXPECT_EQ(contents("a"), "old");
  EXPECT_FALSE(fs::exists(path("b")));
  ASSERT_TRUE(set.commit().ok());
  EXPECT_EQ(contents("a"), "new a");
  EXPECT_EQ(contents("b"), "new b");
  EXPECT_EQ(names(), (Names{"a", "b"}));
}

TEST_F(Outputs, VanishWithoutCommit) {
  put("a", "old");
  {
    OutputSet set;
    ASSERT_TRUE(set.write(path("a"), "half").ok());
    ASSERT_TRUE(set.open(path("b")).ok());
    EXPECT_EQ(names().size(), 3u);
  }
  EXPECT_EQ(names(), Names{"a"});
  EXPECT_EQ(contents("a"), "old");
}

TEST_F(Outputs, OneThatIsLeftOutVanishes) {
  OutputSet set;
  ASSERT_TRUE(set.write(path("a"), "a").ok());
  ASSERT_TRUE(set.write(path("b"), "b").ok());
  set.leaveOut(path("a"));
  ASSERT_TRUE(set.commit().ok());
  EXPECT_EQ(names(), Names{"b"});
}

TEST_F(Outputs, ANameIsOpenedOnce) {
  OutputSet set;
  const auto first = set.open(path("a"));
  ASSERT_TRUE(first.ok());
  ASSERT_TRUE(set.write(path("a"), "one ").ok());
  ASSERT_TRUE(set.write(path("a"), "two").ok());
  EXPECT_EQ(*set.open(path("a")), *first);
  ASSERT_TRUE(set.commit().ok());
  EXPECT_EQ(contents("a"), "one two");
}

TEST_F(Outputs, AreAllOldWhenOneCannotTakeItsPlace) {
  put("a", "old a");
  OutputSet set;
  ASSERT_TRUE(set.write(path("a"), "new a").ok());
  ASSERT_TRUE(set.write(path("fresh"), "new").ok());
  ASSERT_TRUE(set.write(path("c"), "new c").ok());
  fs::create_directory(path("c"));  // in the meantime
  const Status committed = set.commit();
  ASSERT_FALSE(committed.ok());
  EXPECT_EQ(committed.error().kind, ErrorKind::cannot_write);
  EXPECT_EQ(committed.error().file, path("c"));
  set = OutputSet();
  EXPECT_EQ(contents("a"), "old a");
  EXPECT_EQ(names(), (Names{"a", "c"}));
}

TEST_F(Outputs, AreAllOldOnAFullDisk) {
  put("a", "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  Status written = success();
  {
    OutputSet set;
    ASSERT_TRUE(set.write(path("b"), "small").ok());
    written = set.write(path("a"), std::string(5000, 'x'));
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, SIG_DFL);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::cannot_write);
  EXPECT_EQ(names(), Names{"a"});
  EXPECT_EQ(contents("a"), "old");
}

TEST_F(Outputs, KeepTheModeOfWhatTheyReplace) {
  put("a", "secret");
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  put("run", "script");
  ASSERT_EQ(::chmod(path("run").c_str(), 0755), 0);
  const mode_t mask = ::umask(0022);
  OutputSet set;
  for (const char* name : {"a", "run", "fresh"}) ASSERT_TRUE(set.write(path(name), "new").ok());
  ASSERT_TRUE(set.commit().ok());
  ::umask(mask);
  EXPECT_EQ(modeOf("a"), 0640u);
  EXPECT_EQ(modeOf("run"), 0755u);
  EXPECT_EQ(modeOf("fresh"), 0644u);
}

TEST_F(Outputs, KeepTheOwnerOfWhatTheyReplace) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  put("a", "theirs");
  ASSERT_EQ(::chown(path("a").c_str(), 1234, 4321), 0);
  ASSERT_TRUE(writeWhole(path("a"), "new").ok());
  struct stat info{};
  ASSERT_EQ(::stat(path("a").c_str(), &info), 0);
  EXPECT_EQ(info.st_uid, 1234u);
  EXPECT_EQ(info.st_gid, 4321u);
}

TEST_F(Outputs, AFileThatNobodyMayWriteToIsKept) {
  put("a", "precious");
  ASSERT_EQ(::chmod(path("a").c_str(), 0444), 0);
  const Status written = writeWhole(path("a"), "new");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::cannot_write);
  EXPECT_NE(written.error().message.find("protected"), std::string::npos);
  EXPECT_EQ(contents("a"), "precious");
}

TEST_F(Outputs, ALinkStaysALink) {
  put("real", "old");
  fs::create_symlink("real", path("link"));
  fs::create_symlink("link", path("link to link"));
  fs::create_symlink("nothing yet", path("dangling"));
  ASSERT_TRUE(writeWhole(path("link to link"), "new").ok());
  ASSERT_TRUE(writeWhole(path("dangling"), "there").ok());
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_TRUE(fs::is_symlink(path("link to link")));
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(contents("real"), "new");
  EXPECT_EQ(contents("nothing yet"), "there");
}

TEST_F(Outputs, WhatIsNoFileIsWrittenDirectly) {
  fs::create_symlink("/dev/null", path("link"));
  OutputSet set;
  ASSERT_TRUE(set.write("/dev/null", "gone").ok());
  ASSERT_TRUE(set.write(path("link"), "gone").ok());
  ASSERT_TRUE(set.commit().ok());
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  const Status full = writeWhole("/dev/full", "x");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().kind, ErrorKind::cannot_write);
}

TEST_F(Outputs, ClearWhatProgramsThatAreGoneLeftBehind) {
  put(".a.12-0.tmp", "left behind");
  put(".a.7-31.tmp", "left behind");
  put(".a.1-0.tmp", "in use");
  for (const char* other : {".a.tmp", ".a.x-0.tmp", ".a.12-.tmp", "a.12-0.tmp", ".ab.12-0.tmp", ".a.12-0.tmp~"})
    put(other, "another's");
  const int live = ::open(path(".a.1-0.tmp").c_str(), O_WRONLY);
  ASSERT_GE(live, 0);
  ASSERT_EQ(::flock(live, LOCK_EX), 0);
  ASSERT_TRUE(writeWhole(path("a"), "new").ok());
  ::close(live);
  EXPECT_EQ(names(), (Names{"a", ".a.1-0.tmp", ".a.tmp", ".a.x-0.tmp", ".a.12-.tmp", "a.12-0.tmp", ".ab.12-0.tmp",
                            ".a.12-0.tmp~"}));
}

TEST_F(Outputs, AnInputThatIsCalledLikeATemporaryFileIsNotCleared) {
  put(".o.999999-0.tmp", "input");
  put(".o.999999-1.tmp", "stale");
  fs::create_symlink(".o.999999-0.tmp", path("input"));
  keepFromClearing(path("input"));
  ASSERT_TRUE(writeWhole(path("o"), "o").ok());
  EXPECT_EQ(names(), (Names{"o", "input", ".o.999999-0.tmp"}));
}

TEST_F(Outputs, AreNotClearedByAnotherWriterOfTheSameName) {
  OutputSet first;
  ASSERT_TRUE(first.write(path("a"), "first").ok());
  ASSERT_TRUE(writeWhole(path("a"), "second").ok());
  EXPECT_EQ(contents("a"), "second");
  ASSERT_TRUE(first.commit().ok());
  EXPECT_EQ(contents("a"), "first");
  EXPECT_EQ(names(), Names{"a"});
}

TEST_F(Outputs, ANameMayBeAsLongAsTheSystemHasThem) {
  const std::string name(255, 'n');
  ASSERT_TRUE(writeWhole(path(name), "one").ok());
  OutputSet set;
  ASSERT_TRUE(set.write(path(name), "two").ok());
  ASSERT_TRUE(set.write(path("b"), "b").ok());
  ASSERT_TRUE(set.commit().ok());
  EXPECT_EQ(contents(name), "two");
  EXPECT_EQ(names(), (Names{"b", name}));
}

TEST_F(Outputs, NamesOfOneFileAreToldApartFromOthers) {
  put("a", "a");
  put("b", "a");
  fs::create_symlink("a", path("soft"));
  fs::create_hard_link(path("a"), path("hard"));
  fs::create_directory(path("sub"));
  fs::create_symlink("sub", path("folder"));
  fs::create_symlink("sub/none", path("dangling"));
  for (const char* other : {"a", "soft", "hard", "sub/../a", "folder/../a", "./a"})
    EXPECT_TRUE(sameFile(path("a"), path(other))) << other;
  for (const char* other : {"b", "none", "sub/a", "A"}) EXPECT_FALSE(sameFile(path("a"), path(other))) << other;
  // Names of what is yet to be made.
  for (const char* other : {"sub/none", "folder/none", "dangling", "sub/../sub/none"})
    EXPECT_TRUE(sameFile(path("sub/none"), path(other))) << other;
  for (const char* other : {"none", "sub/none2"}) EXPECT_FALSE(sameFile(path("sub/none"), path(other))) << other;
  EXPECT_FALSE(sameFile("/dev/null", "/dev/null"));
}

TEST_F(Outputs, AnOutputMayNotBeAnInputOrAnotherOutput) {
  put("a", "a");
  fs::create_symlink("a", path("link"));
  const NamedFile domain{"the domain", path("a")};
  EXPECT_TRUE(checkOverwrites({domain, {"none", ""}}, {{"-o", path("b")}, {"--report", ""}, {"--x", ""}}).ok());
  const Status input = checkOverwrites({domain}, {{"-o", path("b")}, {"--report", path("link")}});
  ASSERT_FALSE(input.ok());
  EXPECT_EQ(input.error().kind, ErrorKind::usage);
  EXPECT_EQ(describe(input.error()),
            path("link") + ": --report would overwrite the domain (" + path("a") + "); name another file");
  const Status output = checkOverwrites({domain}, {{"-o", path("b")}, {"--report", path("b")}});
  ASSERT_FALSE(output.ok());
  EXPECT_EQ(describe(output.error()),
            path("b") + ": --report would overwrite what is written by -o; name another file");
}

}  // namespace
}  // namespace triscope::output_set_test
