// What a run leaves in files: the exported mesh against its domain, the report, the events.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/version.h"
#include "core/domain/read.h"
#include "core/io/against_domain.h"
#include "core/io/events_file.h"
#include "core/io/export.h"
#include "core/io/mesh_from.h"
#include "core/io/report.h"
#include "core/mesh/edit.h"
#include "core/method/pipeline.h"
#include "core/words/vocabulary.h"

namespace triscope::io_run_test {
namespace {

using nlohmann::json;

/// A frame about a square hole, with a crack in it.
constexpr const char* kFrame = R"({"name": "frame \"A\"", "min_edge_length": 0.5,
  "outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[3,3],[5,3],[5,5],[3,5]]], "segments": [[[1,1],[1,7]]]})";

Domain frame() {
  const auto domain = parseDomain(kFrame, "frame.json");
  EXPECT_TRUE(domain.ok()) << domain.error().message;
  return *domain;
}

MeshState meshed(const Domain& domain, std::vector<Event>* events = nullptr, Stage last = Stage::step5) {
  auto state = begin(std::make_shared<const Domain>(domain), {});
  EXPECT_TRUE(state.ok());
  Journal journal{events};
  while (advanceUntil(*state, last, 1u << 20, journal)) {
  }
  return *state;
}

std::vector<std::string> complaints(const Mesh& mesh, const Domain& domain) {
  std::vector<std::string> messages;
  for (const Violation& v : checkAgainstDomain(mesh, domain)) {
    EXPECT_EQ(v.what, Broken::domain);
    EXPECT_EQ(v.at.has_value(), !v.message.starts_with("the mesh has the area")) << v.message;
    messages.push_back(v.message);
  }
  return messages;
}

TEST(Export, NumbersVerticesTrianglesAndEdgesInOrder) {
  const MeshState state = meshed(frame());
  const MeshFile file = exportMesh(state);
  EXPECT_EQ(file.triangles.size(), state.mesh.liveCount());
  EXPECT_EQ(file.groups, (std::vector<std::string>{"outer", "hole 1", "segment 1"}));
  EXPECT_TRUE(std::ranges::is_sorted(file.fields.front().values));
  EXPECT_EQ(file.fields.front().name, "id");
  std::vector<std::string> fields;
  for (const MeshFile::Field& field : file.fields) fields.push_back(field.name);
  EXPECT_EQ(fields, (std::vector<std::string>{"id", "aspect", "area_ratio", "edge_ratio", "min_angle", "max_angle"}));
  EXPECT_EQ(std::ranges::max(file.fields[2].values), measure(state.mesh).areaRatioMax);
  std::vector<int> used(file.points.size(), 0);
  for (const auto& t : file.triangles)
    for (const int v : t) used[static_cast<std::size_t>(v)] = 1;
  EXPECT_EQ(std::ranges::count(used, 0), 0);

  // The edges of a loop follow one another and close it.
  for (int group = 0; group < 3; ++group) {
    std::vector<MeshFile::Edge> edges;
    std::ranges::copy_if(file.edges, std::back_inserter(edges), [&](const auto& e) { return e.group == group; });
    ASSERT_FALSE(edges.empty());
    for (std::size_t i = 1; i < edges.size(); ++i) EXPECT_EQ(edges[i].a, edges[i - 1].b);
    EXPECT_EQ(edges.front().a == edges.back().b, group < 2);
  }
  ASSERT_EQ(file.holes.size(), 1u);
  EXPECT_TRUE(file.holes[0].x > 3 && file.holes[0].x < 5 && file.holes[0].y > 3 && file.holes[0].y < 5);
}

TEST(Export, LeavesOutTheBoxAroundEverything) {
  const MeshState state = meshed(frame(), nullptr, Stage::triangulation);
  const MeshFile file = exportMesh(state);
  EXPECT_LT(file.triangles.size(), state.mesh.liveCount());
  for (const Point p : file.points) EXPECT_TRUE(p.x >= 0 && p.x <= 8 && p.y >= 0 && p.y <= 8);
}

TEST(AgainstDomain, AMeshOfTheDomainPasses) {
  const Domain domain = frame();
  const MeshState state = meshed(domain);
  EXPECT_EQ(complaints(state.mesh, domain), std::vector<std::string>{});
  const auto again = meshFrom(exportMesh(state));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(complaints(*again, domain), std::vector<std::string>{});
}

TEST(AgainstDomain, NamesACornerThatIsNoVertex) {
  const Domain domain = frame();
  MeshState state = meshed(domain);
  const auto corner = std::ranges::find(state.mesh.points, Point{8, 8});
  ASSERT_NE(corner, state.mesh.points.end());
  corner->x -= 0x1p-50;
  const auto found = complaints(state.mesh, domain);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), "point 2 of loop 'outer' is no vertex of the mesh");
}

TEST(AgainstDomain, NamesABoundaryThatTheMeshDoesNotFollow) {
  const Domain domain = frame();
  MeshState state = meshed(domain);
  const auto onEdge = std::ranges::find_if(state.mesh.points, [](Point p) { return p.y == 0 && p.x > 1 && p.x < 7; });
  ASSERT_NE(onEdge, state.mesh.points.end());
  onEdge->y = 1e-6;
  const auto found = complaints(state.mesh, domain);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].starts_with("after point 0 of loop 'outer', no edge of the mesh follows the boundary"));
  EXPECT_TRUE(found.back().starts_with("the mesh has the area"));
}

TEST(AgainstDomain, NamesAMissingTriangle) {
  const Domain domain = frame();
  MeshFile file = exportMesh(meshed(domain));
  const auto inside = [&](int v) {
    return std::ranges::none_of(file.edges, [&](const MeshFile::Edge& e) { return e.a == v || e.b == v; });
  };
  const auto triangle =
      std::ranges::find_if(file.triangles, [&](const auto& t) { return std::ranges::all_of(t, inside); });
  ASSERT_NE(triangle, file.triangles.end());
  file.triangles.erase(triangle);
  const auto mesh = meshFrom(file);
  ASSERT_TRUE(mesh.ok());
  const auto found = complaints(*mesh, domain);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_NE(found[0].find("the mesh ends here, but not at the domain's boundary"), std::string::npos);
  EXPECT_TRUE(found.back().starts_with("the mesh has the area")) << found.back();
}

TEST(AgainstDomain, CurvedPiecesNeedOnlyTheirEnds) {
  const auto domain = readDomain(TRISCOPE_SOURCE_DIR "/assets/domains/cylinder.json");
  ASSERT_TRUE(domain.ok()) << domain.error().message;
  EXPECT_EQ(complaints(meshed(*domain).mesh, *domain), std::vector<std::string>{});
}

TEST(Report, HasEveryKeyAndAgreesWithTheMeasures) {
  const Domain domain = frame();
  const MeshState state = meshed(domain);
  const Quality q = measure(state.mesh);
  StageSeconds seconds{};
  seconds[static_cast<std::size_t>(Stage::step3)] = 0.25;
  const json report = json::parse(reportOf(state, q, seconds));
  EXPECT_EQ(report.at("program_version"), thisVersion().program);
  EXPECT_EQ(report.at("method_version"), kMethodVersion);
  EXPECT_EQ(report.at("domain"), "frame \"A\"");
  EXPECT_EQ(report.at("vertices"), q.vertices);
  EXPECT_EQ(report.at("triangles"), q.triangles);
  EXPECT_EQ(report.at("boundary_vertices"), q.boundaryVertices);
  EXPECT_EQ(report.at("estimated_triangles"), state.estimatedTriangles);
  EXPECT_EQ(report.at("aspect_ratio_max"), q.aspectMax);
  EXPECT_EQ(report.at("area_ratio_max"), q.areaRatioMax);
  EXPECT_EQ(report.at("edge_ratio_max"), q.edgeRatioMax);
  EXPECT_EQ(report.at("min_angle_deg"), q.minAngle);
  EXPECT_EQ(report.at("max_angle_deg"), q.maxAngle);
  EXPECT_EQ(report.at("obtuse"), q.obtuse);
  EXPECT_EQ(report.at("min_edge_length"), q.minEdge);
  EXPECT_EQ(report.at("min_edge"), 0.5);
  EXPECT_EQ(report.at("min_edge_derived"), false);
  EXPECT_EQ(report.at("bounds_met"), q.withinBounds());
  EXPECT_EQ(report.at("bounds").at("aspect_ratio").at("limit"), 4.31);
  EXPECT_EQ(report.at("worst").at("aspect_ratio"), idOf(state.mesh, q.aspectAt).n);
  const json& stages = report.at("stages");
  ASSERT_EQ(stages.size(), static_cast<std::size_t>(kStageCount) - 1);
  const json& step3 = stages.at(static_cast<std::size_t>(Stage::step3));
  EXPECT_EQ(step3.at("key"), "step3");
  EXPECT_EQ(step3.at("seconds"), 0.25);
  const StageCounts& counts = state.counts[static_cast<std::size_t>(Stage::step3)];
  EXPECT_EQ(step3.at("inserted"), counts.inserted);
  EXPECT_EQ(step3.at("refused"), counts.refused);
  EXPECT_EQ(step3.at("moved"), counts.moved);
  EXPECT_EQ(step3.at("decisions"), counts.decisions);
}

TEST(Report, CountsRoundsAndPasses) {
  const auto reportOn = [](const MeshState& state) { return json::parse(reportOf(state, measure(state.mesh), {})); };
  const Domain domain = frame();
  EXPECT_EQ(reportOn(meshed(domain, nullptr, Stage::step1)).at("rounds"), 0);

  std::vector<Event> events;
  const json meshedReport = reportOn(meshed(domain, &events));
  EXPECT_GT(meshedReport.at("rounds"), 0);
  EXPECT_EQ(meshedReport.at("passes"), 0);
  EXPECT_EQ(meshedReport.at("rounds"), std::ranges::count_if(events, [](const Event& event) {
              return event.kind == EventKind::stage_begun && event.stage == Stage::step2;
            }));

  const json refinedReport = reportOn(meshed(domain, nullptr, Stage::refine));
  EXPECT_EQ(refinedReport.at("rounds"), meshedReport.at("rounds"));
  EXPECT_GT(refinedReport.at("passes"), 0);
}

TEST(Report, OfAnEmptyMeshIsJsonToo) {
  const json report = json::parse(reportOf(Mesh{}, measure(Mesh{})));
  EXPECT_EQ(report.at("triangles"), 0);
  EXPECT_TRUE(report.at("worst").at("aspect_ratio").is_null());
  EXPECT_FALSE(report.contains("stages"));
}

TEST(Events, SayWhatTheNumbersMean) {
  Event event;
  event.kind = EventKind::vertex_inserted;
  event.stage = Stage::step4;
  event.rule = Rule::step4;
  event.round = 2;
  event.subject = 5821;
  event.other = 77;
  event.vertex = 611;
  event.created = 9000;
  event.createdCount = 5;
  event.removedCount = 3;
  event.measured = 2.31;
  event.limit = 1.98;
  event.at = {0.1, -3};
  EXPECT_EQ(eventLine(event, 1204),
            R"({"event": 1204, "kind": "vertex inserted", "stage": "step4", "round": 2, "rule": "step 4", )"
            R"("triangle": 5821, "other_triangle": 77, "vertex": 611, "first_triangle": 9000, "created": 5, )"
            R"("removed": 3, "measured": 2.31, "limit": 1.98, "at": [0.1, -3]})");
  event = Event{};
  event.kind = EventKind::vertex_refused;
  event.stage = Stage::front1;
  event.rule = Rule::first_front;
  event.refusal = Refusal::too_close;
  event.other = 4;
  EXPECT_EQ(eventLine(event, 0), R"({"event": 0, "kind": "vertex refused", "stage": "front1", "rule": "first front", )"
                                 R"("refusal": "too close", "from_vertex": 4, "at": [0, 0]})");
}

TEST(Events, FileAppearsWhenItIsComplete) {
  std::vector<Event> events;
  meshed(frame(), &events);
  ASSERT_GT(events.size(), 100u);
  const auto path = std::filesystem::temp_directory_path() / "triscope-events-test.jsonl";
  std::filesystem::remove(path);
  OutputSet set;
  auto file = EventsFile::create(path.string(), set);
  ASSERT_TRUE(file.ok());
  const std::span<const Event> all(events);
  ASSERT_TRUE(file->append(all.first(50)).ok());
  ASSERT_TRUE(file->append(all.subspan(50)).ok());
  EXPECT_EQ(file->count(), events.size());
  ASSERT_TRUE(file->finish().ok());
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(set.commit().ok());

  std::ifstream in(path);
  std::string line;
  ASSERT_TRUE(std::getline(in, line));
  EXPECT_EQ(json::parse(line), json({{"program_version", thisVersion().program}, {"method_version", kMethodVersion}}));
  std::size_t number = 0;
  while (std::getline(in, line)) {
    const json parsed = json::parse(line);
    EXPECT_EQ(parsed.at("event"), number);
    EXPECT_EQ(parsed.at("kind"), name(events[number].kind));
    EXPECT_EQ(parsed.at("stage"), infoOf(events[number].stage).key);
    ++number;
  }
  EXPECT_EQ(number, events.size());
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace triscope::io_run_test
