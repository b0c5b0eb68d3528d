#include "render/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "core/base/number.h"
#include "legend_item.h"
#include "render/star.h"
#include "sample_states.h"

namespace triscope::scene_test {
namespace {

using EdgeSet = std::set<std::pair<std::uint32_t, std::uint32_t>>;

std::pair<std::uint32_t, std::uint32_t> sorted(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

EdgeSet liveEdges(const Mesh& mesh) {
  EdgeSet edges;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    for (int i = 0; i < 3; ++i) {
      edges.insert(sorted(startOf(mesh, halfOf(slot, i)).word(), endOf(mesh, halfOf(slot, i)).word()));
    }
  }
  return edges;
}

std::array<std::uint64_t, kLayerCount> keysOf(const Scene& scene) {
  std::array<std::uint64_t, kLayerCount> keys{};
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = scene.layers[i].key;
  return keys;
}

TEST(Scene, DrawsEveryTriangleAndEveryEdgeOnce) {
  for (const Stage stage : {Stage::triangulation, Stage::carve, Stage::front2, Stage::step1}) {
    const MeshState state = sample::after(sample::kFrame, stage);
    const Scene scene = buildScene(state, {}, nullptr, nullptr);
    EdgeSet drawn;
    std::size_t edges = 0;
    for (const TriangleBatch& batch : scene.layer(LayerId::mesh).triangles) {
      for (const Index2& edge : batch.edges) drawn.insert(sorted(edge[0], edge[1]));
      edges += batch.edges.size();
    }
    EXPECT_EQ(edges, drawn.size()) << "no edge twice";
    EXPECT_EQ(drawn, liveEdges(state.mesh));
    const TriangleBatch& inner = scene.layer(LayerId::mesh).triangles.back();
    const auto helpers =
        std::count_if(state.mesh.triangles.begin(), state.mesh.triangles.end(), [&](const Triangle& t) {
          const Slot slot(&t - state.mesh.triangles.data());
          return state.mesh.alive(slot) && std::any_of(t.v.begin(), t.v.end(), [&](Vertex v) {
                   return state.mesh.kinds[v] == VertexKind::helper;
                 });
        });
    EXPECT_EQ(inner.triangles.size() + static_cast<std::size_t>(helpers), state.mesh.liveCount());
    EXPECT_EQ(helpers > 0, stage == Stage::triangulation);
  }
}

TEST(Scene, HidesWhatIsSwitchedOff) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const Quality quality = measure(state.mesh);
  ViewOptions off;
  off.boundary = off.boundaryPoints = off.quadtree = off.constraints = off.fronts = off.steiner = false;
  off.triangulation = off.worst = off.decision = off.labels = false;
  const Scene scene = buildScene(state, off, nullptr, &quality);
  for (const Layer& layer : scene.layers) {
    EXPECT_TRUE(layer.squares.empty() && layer.triangles.empty() && layer.lines.empty());
    EXPECT_TRUE(layer.circles.empty() && layer.marks.empty() && layer.labels.empty());
  }
  EXPECT_TRUE(scene.legend.empty());
}

TEST(Scene, LargeLayersOutliveWhatDoesNotConcernThem) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  ViewOptions view;
  view.quadtree = true;
  Scene scene = buildScene(state, view, nullptr, nullptr);
  const auto before = keysOf(scene);
  const Point* const points = scene.layer(LayerId::mesh).triangles.back().points.data();

  view.selection = {Selection::Kind::vertex, 3, -1};
  updateScene(scene, state, view, nullptr, nullptr);
  EXPECT_EQ(scene.layer(LayerId::mesh).key, before[static_cast<std::size_t>(LayerId::mesh)]);
  EXPECT_EQ(scene.layer(LayerId::mesh).triangles.back().points.data(), points) << "not built again";
  EXPECT_NE(scene.layer(LayerId::selection).key, before[static_cast<std::size_t>(LayerId::selection)]);

  MeshState later = state;
  Journal nobody;
  advance(later, Grain::insertion, nobody);
  updateScene(scene, later, view, nullptr, nullptr);
  EXPECT_NE(scene.layer(LayerId::mesh).key, before[static_cast<std::size_t>(LayerId::mesh)]);
  EXPECT_EQ(scene.layer(LayerId::cells).key, before[static_cast<std::size_t>(LayerId::cells)]) << "the tree is final";
  EXPECT_EQ(scene.layer(LayerId::boundary).key, before[static_cast<std::size_t>(LayerId::boundary)]);

  view.theme = ThemeKind::dark;
  updateScene(scene, later, view, nullptr, nullptr);
  EXPECT_NE(scene.layer(LayerId::cells).key, before[static_cast<std::size_t>(LayerId::cells)]);
}

TEST(Scene, EveryTickOfTheQuadtreeShows) {
  MeshState state = sample::start(sample::kFrame);
  ViewOptions view;
  view.quadtree = true;
  Journal nobody;
  Scene scene = buildScene(state, view, nullptr, nullptr);
  while (state.stage <= Stage::density) {
    advance(state, Grain::decision, nobody);
    updateScene(scene, state, view, nullptr, nullptr);
    const auto leaves =
        std::count_if(state.tree.cells.begin(), state.tree.cells.end(), [](const Cell& c) { return c.child < 0; });
    const auto outside = std::count_if(state.tree.cells.begin(), state.tree.cells.end(),
                                       [](const Cell& c) { return c.child < 0 && c.type == CellType::outside; });
    const auto expected = outside == leaves ? leaves : leaves - outside;
    ASSERT_EQ(scene.layer(LayerId::cells).squares.at(0).squares.size(), static_cast<std::size_t>(expected));
  }
}

TEST(Scene, TheThreeCirclesHoldTheWorstTriangles) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const Quality quality = measure(state.mesh);
  const Scene scene = buildScene(state, {}, nullptr, &quality);
  const auto& circles = scene.layer(LayerId::worst).circles;
  ASSERT_EQ(circles.size(), 6u) << "each on a ring of background";
  const std::array<Slot, 3> slots{quality.aspectAt, quality.areaRatioAt, quality.edgeRatioAt};
  const std::array<Dash, 3> dashes{Dash::solid, Dash::dashed, Dash::dash_dotted};
  for (std::size_t i = 0; i < 3; ++i) {
    const Circle& circle = circles[2 * i + 1];
    EXPECT_EQ(circle.style.dash, dashes[i]);
    EXPECT_EQ(circles[2 * i].centre, circle.centre);
    for (const Vertex v : triangleAt(state.mesh, slots[i]).v) {
      EXPECT_LE(distance(pointOf(state.mesh, v), circle.centre), circle.radius);
    }
  }
  const LegendItem* aspect = legendItem(scene, "worst aspect ratio");
  ASSERT_NE(aspect, nullptr);
  EXPECT_EQ(aspect->value.find(compact(quality.aspectMax)), 0u);
  EXPECT_EQ(aspect->value.find("≥") != std::string::npos, quality.aspectMax >= Bounds::aspect);
}

TEST(Scene, ADecisionShowsTheEdgesThatItRemoved) {
  MeshState state = sample::after(sample::kFrame, Stage::carve);
  std::vector<Event> events;
  Journal journal{&events};
  int checked = 0;
  int same = 0;
  while (state.stage <= Stage::step3 && checked < 300) {
    const EdgeSet before = liveEdges(state.mesh);
    events.clear();
    if (!advance(state, Grain::decision, journal)) break;
    const auto made =
        std::find_if(events.begin(), events.end(), [](const Event& e) { return e.kind == EventKind::vertex_inserted; });
    if (made == events.end()) continue;
    const EdgeSet now = liveEdges(state.mesh);
    EdgeSet removed;
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::inserter(removed, removed.end()));
    Star star;
    starOf(state.mesh, Vertex(made->vertex), star);
    EdgeSet drawn;
    for (const auto& edge : edgesBefore(state.mesh, rimVertices(state.mesh, star))) {
      drawn.insert(sorted(edge[0].word(), edge[1].word()));
    }
    EXPECT_EQ(drawn.size(), removed.size());
    if (drawn == removed) ++same;  // four points on one circle leave a choice
    ++checked;
    const Scene scene = buildScene(state, {}, &*made, nullptr);
    const Layer& layer = scene.layer(LayerId::decision);
    ASSERT_EQ(layer.triangles.size(), 1u);
    EXPECT_TRUE(layer.triangles[0].hatched);
    EXPECT_EQ(layer.triangles[0].triangles.size(), made->createdCount);
  }
  EXPECT_GT(checked, 100);
  EXPECT_GT(same, checked * 9 / 10);
}

TEST(Scene, ColoursTrianglesByTheirMeasure) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  ViewOptions view;
  view.fill = TriangleFill::min_angle;
  const Scene scene = buildScene(state, view, nullptr, nullptr);
  const TriangleBatch& batch = scene.layer(LayerId::mesh).triangles.back();
  ASSERT_EQ(batch.fills.size(), batch.triangles.size());
  for (std::size_t i = 0; i < batch.triangles.size(); ++i) {
    const Index3& t = batch.triangles[i];
    const TriangleQuality q = qualityOf(batch.points[t[0]], batch.points[t[1]], batch.points[t[2]]);
    EXPECT_EQ(batch.fills[i] == scene.theme.overBound, q.minAngle <= Bounds::minAngle) << q.minAngle;
  }
  ASSERT_NE(legendItem(scene, "smallest angle"), nullptr);
}

TEST(Scene, BrushedAndObtuseTrianglesStandOut) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const Quality quality = measure(state.mesh);
  ViewOptions view;
  view.obtuse = true;
  Scene scene = buildScene(state, view, nullptr, &quality);
  const auto countOf = [&scene](Color color) {
    const auto& fills = scene.layer(LayerId::mesh).triangles.back().fills;
    return static_cast<std::size_t>(std::count(fills.begin(), fills.end(), color));
  };
  EXPECT_EQ(countOf(scene.theme.obtuse), quality.obtuse);
  view.brush = {true, TriangleFill::aspect, 2.0, 1e6};
  updateScene(scene, state, view, nullptr, &quality);
  EXPECT_EQ(countOf(scene.theme.selection), state.mesh.liveCount());
  ASSERT_NE(legendItem(scene, "aspect ratio 2 to 1000000"), nullptr);
  view.brush.low = 0.99999999 * quality.aspectMax;
  view.brush.high = std::numeric_limits<double>::max();
  const std::string open = "aspect ratio ≥ " + compact(view.brush.low, 4);
  view.dimmed = true;  // its colours are other ones then, its count is not
  updateScene(scene, state, view, nullptr, &quality);
  ASSERT_NE(legendItem(scene, open), nullptr);
  int worst = 0;
  for (const Slot slot : state.mesh.triangles.keys()) {
    const auto& v = state.mesh.triangles[slot].v;
    const auto at = [&](std::size_t i) { return state.mesh.points[v[i]]; };
    if (state.mesh.alive(slot) && qualityOf(at(0), at(1), at(2)).aspect >= view.brush.low) ++worst;
  }
  ASSERT_GE(worst, 1);
  EXPECT_EQ(legendItem(scene, open)->value, std::to_string(worst));
}

TEST(Scene, CellsUnderColouredTrianglesAreNotInTheLegend) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  ViewOptions view;
  view.quadtree = true;
  Scene scene;
  const auto ramps = [&] {
    updateScene(scene, state, view, nullptr, nullptr);
    EXPECT_EQ(scene.layer(LayerId::cells).squares.empty(), view.triangulation && view.fill != TriangleFill::plain);
    return std::count_if(scene.legend.begin(), scene.legend.end(),
                         [](const LegendItem& item) { return item.label == "density rank"; });
  };
  EXPECT_EQ(ramps(), 1) << "plain triangles let the cells be seen";
  view.fill = TriangleFill::aspect;
  EXPECT_EQ(ramps(), 0);
  view.fill = TriangleFill::density;
  EXPECT_EQ(ramps(), 1) << "of the triangles";
  view.triangulation = false;
  EXPECT_EQ(ramps(), 1) << "of the cells";
}

TEST(Scene, TheLegendOfAPhaseIsOfWhatThePhaseDraws) {
  MeshState state = sample::after(sample::kFrame, Stage::front2);
  std::vector<Event> events;
  MeshState before = state;
  while (events.empty() || !inserts(events.back())) {
    before = state;
    events.clear();
    Journal journal{&events};
    ASSERT_TRUE(advance(state, Grain::decision, journal));
  }
  const Event earlier = [] {
    Event event;  // what led to the state before: of no concern inside the insertion
    event.kind = EventKind::vertex_inserted;
    return event;
  }();
  const std::optional<Insertion> apart = takeApart(before, events.back());
  ASSERT_TRUE(apart && apart->measured);
  const auto sceneOf = [&](InsertionPhase phase) {
    Scene scene;
    const InsertionView shown{&*apart, phase};
    updateScene(scene, before, {}, &earlier, nullptr, &shown);
    return scene;
  };
  for (const InsertionPhase phase : {InsertionPhase::candidate, InsertionPhase::walk, InsertionPhase::cavity}) {
    const Scene scene = sceneOf(phase);
    EXPECT_EQ(legendItem(scene, "new triangles"), nullptr) << name(phase);
    EXPECT_EQ(legendItem(scene, "removed edges"), nullptr) << name(phase);
    EXPECT_EQ(legendItem(scene, "candidate") != nullptr, phase != InsertionPhase::cavity) << name(phase);
    EXPECT_EQ(legendItem(scene, "limit") != nullptr, phase == InsertionPhase::candidate) << name(phase);
    EXPECT_EQ(legendItem(scene, "walk") != nullptr, phase == InsertionPhase::walk) << name(phase);
  }
  const Scene candidate = sceneOf(InsertionPhase::candidate);
  EXPECT_EQ(legendItem(candidate, "limit")->value, compact(apart->measured->limit));
  EXPECT_EQ(legendItem(candidate, "circumcircle, R")->value, compact(apart->measured->length));
  const Scene cavity = sceneOf(InsertionPhase::cavity);
  const LegendItem* const gone = legendItem(cavity, "cavity: gives way");
  ASSERT_NE(gone, nullptr);
  EXPECT_EQ(gone->value, std::to_string(apart->cavity.triangles().size()));
}

TEST(Scene, AnEmptyStateGivesAnEmptyPicture) {
  const Scene scene = buildScene(MeshState{}, {}, nullptr, nullptr);
  EXPECT_TRUE(scene.bounds.empty());
  EXPECT_TRUE(scene.legend.empty());
}

TEST(Scene, EventsThatNameNothingAreHarmless) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  for (int kind = 0; kind <= static_cast<int>(EventKind::failure); ++kind) {
    Event event;
    event.kind = static_cast<EventKind>(kind);
    buildScene(state, {}, &event, nullptr);
    event.subject = event.vertex = event.created = 0x7fffffffu;
    buildScene(state, {}, &event, nullptr);
    buildScene(MeshState{}, {}, &event, nullptr);
  }
}

TEST(Palette, TextReadsInEveryTheme) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark, ThemeKind::high_contrast}) {
    const Theme& t = themeOf(kind);
    for (const Color ground : {t.background, t.surface}) {
      EXPECT_GE(contrast(t.text, ground), 4.5);
      EXPECT_GE(contrast(t.textMuted, ground), 4.5);
    }
    for (const Color line : {t.boundary, t.worstAspect, t.worstArea, t.worstEdge, t.candidate, t.selection, t.front1,
                             t.front2, t.removed, t.refused}) {
      EXPECT_GE(contrast(line, t.background), 3.0);
    }
  }
  EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21.0, 1e-9);
}

TEST(Palette, StagesAreSeenInEveryTheme) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark, ThemeKind::high_contrast}) {
    const Theme& t = themeOf(kind);
    for (int k = 0; k < kStageCount; ++k)
      EXPECT_GE(contrast(stageColor(t, static_cast<Stage>(k)), t.surface), 1.3)
          << k << " in " << static_cast<int>(kind);
    EXPECT_GE(contrast(stageColor(t, Stage::finished), t.surface), 4.5);
    EXPECT_GE(contrast(stageColor(t, Stage::finished), stageColor(t, Stage::refine)), 1.4);
  }
}

TEST(Palette, ScalesGrowLighterAllTheWay) {
  for (const Scale scale : {Scale::cividis, Scale::viridis}) {
    double before = 0.0;
    for (int i = 0; i <= 64; ++i) {
      const double now = contrast(scaleColor(scale, i / 64.0), rgb(0x000000));
      EXPECT_GT(now, before) << i;
      before = now;
    }
  }
}

TEST(Style, WiresFadeAndMarksShrinkWithTheirRoom) {
  EXPECT_EQ(wireFade(100.0), 1.0);
  EXPECT_GT(wireFade(5.0), wireFade(3.0));
  EXPECT_EQ(wireFade(0.0), wireFade(1.0));
  EXPECT_EQ(markSize(8.0f, 1e9), 8.0f);
  EXPECT_EQ(markSize(8.0f, 0.0), 2.0f);
  EXPECT_LE(markSize(8.0f, 10.0), 10.0f);
}

TEST(Number, ReadsAsPeopleWriteThem) {
  EXPECT_EQ(compact(3.7811), "3.78");
  EXPECT_EQ(compact(3.0), "3");
  EXPECT_EQ(compact(0.001), "0.001");
  EXPECT_EQ(compact(0.00123456), "0.00123");
  EXPECT_EQ(compact(1694.4), "1694");
  EXPECT_EQ(compact(120.04), "120");
  EXPECT_EQ(compact(-0.0), "0");
  EXPECT_EQ(compact(9.999), "10");
  EXPECT_EQ(compact(2.34e-9), "2.34e-09");
  EXPECT_EQ(grouped(1694), "1694");
  EXPECT_EQ(grouped(33040), "33\u2009040");
  EXPECT_EQ(grouped(1234567), "1\u2009234\u2009567");
}

}  // namespace
}  // namespace triscope::scene_test
