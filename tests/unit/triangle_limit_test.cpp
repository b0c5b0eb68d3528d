// A run stops before it makes a mesh of more triangles than allowed, says what asked for them, and takes little memory.
#include "core/method/triangle_limit.h"

#include <gtest/gtest.h>

#include "core/explain/caption.h"
#include "core/method/estimate.h"
#include "core/run/driver.h"
#include "core/run/travel.h"
#include "support/runs.h"

namespace triscope::triangle_limit_test {
namespace {

/// Where the run stops, and the event that says so.
struct Stopped {
  MeshState state;
  Event event;
};

Stopped stopped(const support::DomainPtr& domain, const Settings& settings = {}) {
  Stopped stopped{support::start(domain, settings), {}};
  std::vector<Event> events;
  Journal journal{&events};
  while (!stopped.state.failed && advance(stopped.state, Grain::decision, journal)) {
    for (const Event& event : events)
      if (event.kind == EventKind::failure) stopped.event = event;
    events.clear();
  }
  EXPECT_TRUE(overLimit(stopped.state));
  EXPECT_EQ(stopped.event.kind, EventKind::failure);
  EXPECT_EQ(stopped.event.refusal, Refusal::too_many_triangles);
  EXPECT_GT(stopped.event.measured, stopped.event.limit);
  EXPECT_EQ(stopped.event.measured, stopped.state.estimatedTriangles);
  EXPECT_EQ(stopped.event.limit, settings.maxTriangles);
  EXPECT_TRUE(stopped.state.mesh.triangles.empty());
  return stopped;
}

std::string messageOf(const support::DomainPtr& domain, const Settings& settings = {}) {
  const Error error = tooManyTriangles(stopped(domain, settings).state);
  EXPECT_EQ(error.kind, ErrorKind::bad_data);
  EXPECT_TRUE(error.at.has_value());
  return describe(error);
}

Settings most(int triangles) {
  Settings settings;
  settings.maxTriangles = triangles;
  return settings;
}

TEST(TriangleLimit, IsHeldAgainstTheEstimate) {
  const support::DomainPtr domain = support::domainFrom(support::kRound);
  const MeshState whole = support::after(domain, Stage::density);
  const int estimate = static_cast<int>(whole.estimatedTriangles);
  EXPECT_FALSE(support::after(domain, Stage::refine, most(estimate + 1)).failed);
  const Stopped at = stopped(domain, most(estimate));
  EXPECT_EQ(at.state.estimatedTriangles, whole.estimatedTriangles);
  EXPECT_NE(captionOf(at.event).find("more triangles than max_triangles allows"), std::string::npos);
  EXPECT_EQ(estimateOf(at.state).triangles, whole.estimatedTriangles);
  EXPECT_GT(estimateOf(at.state).bytes, estimateOf(at.state).triangles);
}

// The tree alone would take more memory than there is: it is not built.
TEST(TriangleLimit, StopsATreeThatCannotEndBelowIt) {
  const support::DomainPtr domain =
      support::domainAt(support::testData().parent_path() / "refused" / "box_1e16_triangles.json");
  const Stopped at = stopped(domain);
  EXPECT_GT(at.state.estimatedTriangles, 1e15);
  EXPECT_LT(at.state.tree.cells.size(), 100'000u);
  EXPECT_NE(describe(tooManyTriangles(at.state)).find("density entry 1"), std::string::npos);
}

// No triangle would come of it, but a tree without end.
TEST(TriangleLimit, StopsATreeThatGrowsOutsideTheDomain) {
  const Stopped at = stopped(support::domainFrom(R"({"outer": [[0, 0], [10, 0], [10, 10], [0, 10]],
    "holes": [[[1, 1], [9, 1], [9, 9], [1, 9]]], "min_edge_length": 1e-7,
    "density": [{"box": [[2, 2], [8, 8]], "length": 1e-7}]})"),
                             most(100'000));
  EXPECT_LT(at.state.tree.cells.size(), 1'100'000u);
  EXPECT_NE(describe(tooManyTriangles(at.state)).find("density entry 1"), std::string::npos);
}

TEST(TriangleLimit, NamesWhatAsksForTheMost) {
  const auto square = [](const std::string& more) {
    return support::domainFrom(R"({"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.0005)" + more + "}");
  };
  const auto names = [](const std::string& message, const std::string& name) {
    EXPECT_NE(message.find(name), std::string::npos) << message;
  };
  names(messageOf(square(R"(, "density": [{"at": [0.3, 0.3], "length": 0.01},
                            {"name": "wake", "box": [[0.5, 0], [1, 1]], "length": 0.0005}])"),
                  most(100'000)),
        "density entry 'wake', for edges of length 0.0005");
  names(messageOf(square(R"(, "density": [{"loop": "outer", "length": 0.0005}])"), most(10'000)), "density entry 1");
  Settings uniform = most(10'000);
  uniform.maxRank = 1;
  names(messageOf(square(""), uniform), "the setting max_rank = 1");
  names(messageOf(square(R"(, "holes": [{"name": "eye", "kind": "circle", "centre": [0.5, 0.5], "radius": 0.01}])"),
                  most(1'000)),
        "loop 'eye'");
}

// Whoever looks at a run that stopped sees where it did.
TEST(TriangleLimit, AViewerStaysInTheStageThatStopped) {
  for (const auto& [domain, stage] :
       {std::pair(support::domainFrom(support::kRound), Stage::density),
        std::pair(support::domainAt(support::testData().parent_path() / "refused" / "box_1e16_triangles.json"),
                  Stage::quadtree)}) {
    Driver driver;
    driver.run = runFrom(support::start(domain, most(10)));
    driver.breakpoints = {{std::move(*Condition::compile("failed"))}};
    for (const Goal::Kind kind : {Goal::Kind::end, Goal::Kind::breakpoint}) {
      headFor(driver, towardsTick(driver.run, 0));
      std::vector<Event> fresh;
      carryOn(driver, 1, {}, fresh);
      headFor(driver, {.kind = kind});
      carryOn(driver, ~std::uint64_t{0}, {}, fresh);
      EXPECT_TRUE(overLimit(driver.run.state));
      EXPECT_EQ(driver.run.state.stage, stage);
      EXPECT_EQ(driver.stopped.has_value(), kind == Goal::Kind::breakpoint);
    }
  }
}

// One tree in two pieces is the same tree: what stops it is no matter of when it is looked at.
TEST(TriangleLimit, AStoppedRunStaysStopped) {
  Stopped at = stopped(support::domainFrom(support::kFrame), most(10));
  Journal nobody;
  advance(at.state, Grain::all, nobody);
  EXPECT_EQ(at.state.stage, Stage::finished);
  EXPECT_TRUE(overLimit(at.state));
}

TEST(EstimateText, RoundsAsPeopleDo) {
  EXPECT_EQ(bytesText(0), "0 bytes");
  EXPECT_EQ(bytesText(999), "999 bytes");
  EXPECT_EQ(bytesText(1234), "1.2 kB");
  EXPECT_EQ(bytesText(999'600), "1.0 MB");
  EXPECT_EQ(bytesText(86e6), "86 MB");
  EXPECT_EQ(bytesText(2e18), "2.0 EB");
  EXPECT_EQ(roughCount(12.4), "12");
  EXPECT_EQ(roughCount(23'412'345), "23.4 million");
  EXPECT_EQ(roughCount(2e9), "2 billion");
  EXPECT_EQ(roughCount(2.04e16), "2e+16");
}

}  // namespace
}  // namespace triscope::triangle_limit_test
