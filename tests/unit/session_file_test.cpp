// Session files: what is written is read back, whatever is in it; what is wrong is refused with its place.
#include "core/session/session_file.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "support/domains.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::session_file_test {
namespace {

Breakpoint breakpoint(const std::string& text, Breakpoint::Action action, bool enabled) {
  Result<Condition> condition = Condition::compile(text);
  EXPECT_TRUE(condition.ok());
  return {std::move(*condition), action, enabled};
}

SessionFile sample() {
  SessionFile s;
  s.domainFile = "a folder/dömain \"x\".json";
  s.domainText = support::kFrame;
  s.settings.omega = 0.1;
  s.settings.laplacian = false;
  s.settings.maxRounds = 7;
  s.tick = 1234567890123;
  s.breakpoints = {breakpoint("aspect > 4 and stage == refine", Breakpoint::Action::mark, false),
                   breakpoint("in(-1, -1, 2.5, 1)", Breakpoint::Action::stop, true)};
  s.bookmarks = {{17, "here\nit turns"}, {0, ""}};
  s.notes = "ω is too large?\t\\";
  s.savedAs = "/home/a \\ b/one.session";
  s.view = SavedView{{0.1, -3e-7}, 12.75};
  s.hashes = {{Stage::constraints, 0, 12, 0xffffffffffffffffull}, {Stage::step5, 3, 999, 1}};
  return s;
}

void expectSame(const SessionFile& a, const SessionFile& b) {
  EXPECT_EQ(a.domainFile, b.domainFile);
  EXPECT_EQ(a.domainText, b.domainText);
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.tick, b.tick);
  ASSERT_EQ(a.breakpoints.size(), b.breakpoints.size());
  for (std::size_t k = 0; k < a.breakpoints.size(); ++k) {
    EXPECT_EQ(a.breakpoints[k].condition.text(), b.breakpoints[k].condition.text());
    EXPECT_EQ(a.breakpoints[k].action, b.breakpoints[k].action);
    EXPECT_EQ(a.breakpoints[k].enabled, b.breakpoints[k].enabled);
  }
  EXPECT_EQ(a.bookmarks, b.bookmarks);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.savedAs, b.savedAs);
  EXPECT_EQ(a.view, b.view);
  EXPECT_EQ(a.hashes, b.hashes);
}

std::string complaint(const std::string& json) {
  const Result<SessionFile> read = parseSession(json, "some.session");
  if (read.ok()) return "";
  EXPECT_EQ(read.error().kind, ErrorKind::bad_data);
  EXPECT_EQ(read.error().file, "some.session");
  EXPECT_FALSE(read.error().hint.empty());
  return read.error().message;
}

/// A session that is right but for one member.
std::string with(const std::string& member) {
  return R"({"format": "triscope session", "version": 1, "domain": {"file": "f", "text": "{}"}, )" + member + "}";
}

TEST(SessionFile, IsReadBackAsItWasWritten) {
  const SessionFile before = sample();
  const Result<SessionFile> after = parseSession(sessionText(before), "x");
  ASSERT_TRUE(after.ok()) << describe(after.error());
  expectSame(before, *after);
  EXPECT_EQ(sessionText(before), sessionText(*after));
}

TEST(SessionFile, SaysWhichVersionSavedIt) {
  const Result<SessionFile> read = parseSession(sessionText(sample()), "x");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->madeBy.program, thisVersion().program);
  EXPECT_EQ(read->madeBy.method, kMethodVersion);
  const Result<SessionFile> other = parseSession(with(R"("program_version": "0.0.1", "method_version": 1)"), "x");
  ASSERT_TRUE(other.ok()) << "another version is no reason to refuse it";
  EXPECT_EQ(other->madeBy.program, "0.0.1");
  EXPECT_EQ(other->madeBy.method, 1);
  EXPECT_EQ(parseSession(with(R"("tick": 1)"), "x")->madeBy.method, 0);
  EXPECT_NE(complaint(with(R"("method_version": "two")")), "");
}

TEST(SessionFile, GoesThroughAFile) {
  const std::string path = testing::TempDir() + "triscope_session_test.json";
  ASSERT_TRUE(writeSession(path, sample()).ok());
  const Result<SessionFile> read = readSession(path);
  ASSERT_TRUE(read.ok()) << describe(read.error());
  expectSame(sample(), *read);
  std::remove(path.c_str());
  EXPECT_EQ(readSession(path).error().kind, ErrorKind::no_input);
  EXPECT_EQ(writeSession(testing::TempDir() + "no such folder/x", sample()).error().kind, ErrorKind::cannot_write);
}

TEST(SessionFile, BytesThatAreNoTextDoNotSpoilIt) {
  SessionFile s = sample();
  s.domainFile = "caf\xe9 \xff\xc0\xaf\xed\xa0\x80 \xf4\x90\x80\x80 \xe2\x82";
  s.notes = "ω ✓ 𝄞";
  const Result<SessionFile> read = parseSession(sessionText(s), "x");
  ASSERT_TRUE(read.ok()) << describe(read.error());
  EXPECT_EQ(read->domainFile.substr(0, 4), "caf?");
  EXPECT_EQ(read->notes, s.notes);
}

TEST(SessionFile, OnlyTheDomainIsNeeded) {
  const Result<SessionFile> read =
      parseSession(R"({"format": "triscope session", "domain": {"text": "{}"}, "colour": "blue"})", "x");
  ASSERT_TRUE(read.ok()) << describe(read.error());
  EXPECT_EQ(read->settings, Settings{});
  EXPECT_FALSE(read->view.has_value());
}

TEST(SessionFile, SaysWhatIsWrongAndWhere) {
  const auto expect = [](const std::string& json, const std::string& part) {
    EXPECT_NE(complaint(json).find(part), std::string::npos) << json << "\n" << complaint(json);
  };
  expect("", "not valid JSON");
  expect("{", "not valid JSON");
  expect("[]", "a list");
  expect("{}", "no session file");
  expect(R"({"format": "triscope session", "version": 2})", "version 2");
  expect(R"({"format": "triscope session"})", "\"domain\"");
  expect(R"({"format": "triscope session", "domain": 5})", "\"domain\" is a number");
  expect(R"({"format": "triscope session", "domain": {"file": "x"}})", "domain.text");
  expect(with(R"("tick": -1)"), "\"tick\" is -1");
  expect(with(R"("tick": 1.5)"), "\"tick\" is 1.5");
  expect(with(R"("tick": 1e300)"), "\"tick\" is 1e+300");
  expect(with(R"("tick": "one")"), "\"tick\" is a text");
  expect(with(R"("settings": {"omgea": 1})"), "omgea");
  expect(with(R"("settings": {"omega": 9})"), "out of range");
  expect(with(R"("settings": {"omega": "much"})"), "settings.omega");
  expect(with(R"("settings": [])"), "\"settings\" is a list");
  expect(with(R"("breakpoints": [{"condition": "aspect > 4"}, {"condition": "aspct > 4"}])"),
         "breakpoints[1].condition");
  expect(with(R"("breakpoints": [{"condition": "failed", "action": "explode"}])"), "breakpoints[0].action");
  expect(with(R"("breakpoints": [{"condition": "failed", "action": "\u001b[31m"}])"), "is \"\\x1b[31m\"");
  expect(with(R"("breakpoints": [5])"), "breakpoints[0]");
  expect(with(R"("bookmarks": [{"tick": 0, "name": 7}])"), "bookmarks[0].name");
  expect(with(R"("view": {"x": 0, "y": 0, "scale": 0})"), "view.scale");
  expect(with(R"("hashes": [{"stage": "lunch", "hash": "0000000000000000"}])"), "hashes[0].stage");
  expect(with(R"("hashes": [{"stage": "step1", "hash": "12"}])"), "hashes[0].hash");
  expect(with(R"("hashes": [{"stage": "step1", "hash": "000000000000000g"}])"), "hashes[0].hash");
  expect(with(R"("hashes": [{"stage": "step1", "round": 70000, "hash": "0000000000000000"}])"), "hashes[0].round");
}

TEST(SessionFile, DamagedTextIsReadOrRefusedButNeverCrashes) {
  const std::string whole = sessionText(sample());
  support::Random random{20260726};
  std::size_t refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string text = whole;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(text.size());
      switch (random.below(4)) {
        case 0:
          text[at] = static_cast<char>(random.below(256));
          break;
        case 1:
          text.erase(at, 1 + random.below(40));
          break;
        case 2:
          text.insert(at, text.substr(random.below(text.size()), random.below(60)));
          break;
        default:
          text.insert(at, 1, "{}[]\",:0-e.tn"[random.below(13)]);
      }
      if (text.empty()) text = "x";
    }
    const Result<SessionFile> read = parseSession(text, "x");
    if (!read.ok()) {
      ++refused;
      EXPECT_FALSE(read.error().message.empty());
      continue;
    }
    const Result<SessionFile> again = parseSession(sessionText(*read), "x");
    ASSERT_TRUE(again.ok()) << describe(again.error()) << "\n" << text;
    expectSame(*read, *again);
  }
  EXPECT_GT(refused, 5000u);
  EXPECT_LT(refused, 20000u);
}

TEST(SessionFile, HashesAreThoseOfTheStagesPassed) {
  const auto domain = support::domainFrom(support::kFrame);
  const auto always = [](const MeshState&) { return true; };
  const auto all = stageHashes(support::start(domain), ~std::uint64_t{0}, ~std::size_t{0}, always);
  ASSERT_GT(all.size(), 12u);
  EXPECT_EQ(all.front().stage, Stage::constraints);
  EXPECT_EQ(all.back().stage, Stage::optimise);
  EXPECT_EQ(all.back().hash, hashOf(support::finished(domain)));
  for (const StageHash& h : all)
    if (h.stage == Stage::step1) {
      EXPECT_EQ(h.hash, hashOf(support::after(domain, Stage::step1)));
    }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto upTo = stageHashes(support::start(domain), all[k].tick, ~std::size_t{0}, always);
    ASSERT_GT(upTo.size(), k);
    EXPECT_EQ(upTo[k], all[k]);
    EXPECT_EQ(upTo.back().tick, all[k].tick);
    EXPECT_EQ(stageHashes(support::start(domain), ~std::uint64_t{0}, k, always).size(), k);
  }
}

TEST(SessionFile, IsToldFromADomainByItsContent) {
  EXPECT_TRUE(isSession(sessionText(sample())));
  EXPECT_TRUE(isSession(R"({"format": "triscope session"})"));
  EXPECT_FALSE(isSession(support::kFrame));
  EXPECT_FALSE(isSession(R"({"name": "triscope session", "outer": [[0, 0], [1, 0], [0, 1]]})"));
  EXPECT_FALSE(isSession(R"(["format", "triscope session"])"));
  EXPECT_FALSE(isSession(R"({"format": "triscope session")"));
  EXPECT_FALSE(isSession(""));
}

}  // namespace
}  // namespace triscope::session_file_test
