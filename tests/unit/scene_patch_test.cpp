// A scene that is brought up to date from moment to moment shows what one shows that is made for the moment.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/run/history.h"
#include "render/scene.h"
#include "sample_states.h"

namespace triscope::scene_patch_test {
namespace {

bool isHole(const Index3& t) { return t[0] == t[1]; }

const TriangleBatch& meshOf(const Scene& scene) { return scene.layer(LayerId::mesh).triangles.front(); }

Color fillOf(const TriangleBatch& batch, std::size_t t) {
  return batch.fills.empty() ? Color{0, 0, 0, 0} : batch.fills[batch.fills.size() == 1 ? 0 : t];
}

/// What a renderer would show of a triangle.
bool sameTriangle(const TriangleBatch& a, const TriangleBatch& b, std::size_t t) {
  const bool noneA = t >= a.triangles.size() || isHole(a.triangles[t]);
  const bool noneB = t >= b.triangles.size() || isHole(b.triangles[t]);
  if (noneA || noneB) return noneA == noneB;
  for (std::size_t i = 0; i < 3; ++i)
    if (a.points[a.triangles[t][i]] != b.points[b.triangles[t][i]]) return false;
  return a.triangles[t] == b.triangles[t] && fillOf(a, t) == fillOf(b, t);
}

struct WholeRun {
  History history;
  std::uint64_t end = 0;
};

WholeRun wholeRun() {
  WholeRun run;
  MeshState state = sample::start(sample::kFrame);
  run.history.restart(state);
  Journal deaf;
  while (advance(state, Grain::decision, deaf)) run.history.offer(state, 0);
  run.end = state.tick;
  return run;
}

/// Steps to and fro through the run. Returns how often the mesh was not drawn anew as a whole.
int expectFollows(const ViewOptions& options) {
  const WholeRun run = wholeRun();
  Journal deaf;
  Scene scene;
  Scene before;
  int patched = 0;
  std::uint64_t tick = run.end / 2;
  for (std::uint64_t k = 0; k < 80; ++k) {
    tick = k % 9 == 0   ? run.end * (k * 31 % 80) / 80
           : k % 3 == 0 ? std::min(run.end, tick + 3)
           : tick > 0   ? tick - 1
                        : 0;
    const MeshState state = run.history.seek(tick, deaf);
    updateScene(scene, state, options, nullptr, nullptr);
    Scene fresh;
    updateScene(fresh, state, options, nullptr, nullptr);
    const Layer& layer = scene.layer(LayerId::mesh);
    EXPECT_EQ(layer.triangles.empty(), fresh.layer(LayerId::mesh).triangles.empty());
    EXPECT_EQ(scene.brushed, fresh.brushed);
    if (layer.triangles.empty()) continue;
    const std::size_t most = std::max(meshOf(scene).triangles.size(), meshOf(fresh).triangles.size());
    for (std::size_t t = 0; t < most; ++t)
      EXPECT_TRUE(sameTriangle(meshOf(scene), meshOf(fresh), t)) << "triangle " << t << " after " << tick;
    if (layer.change.since != 0 && layer.version != before.layer(LayerId::mesh).version) {
      ++patched;
      EXPECT_EQ(layer.change.since, before.layer(LayerId::mesh).version);
      for (std::size_t t = 0; t < most; ++t) {
        const bool told =
            std::find(layer.change.triangles.begin(), layer.change.triangles.end(), t) != layer.change.triangles.end();
        EXPECT_TRUE(told || sameTriangle(meshOf(before), meshOf(scene), t)) << "triangle " << t << " after " << tick;
      }
    }
    before = scene;
    if (testing::Test::HasFailure()) return patched;
  }
  return patched;
}

TEST(ScenePatch, FollowsTheEdges) { EXPECT_GT(expectFollows({}), 20); }

TEST(ScenePatch, FollowsAMeasureOfEachTriangle) {
  ViewOptions options;
  options.fill = TriangleFill::aspect;
  options.obtuse = true;
  EXPECT_GT(expectFollows(options), 20);
}

TEST(ScenePatch, FollowsAMeasureOfPairs) {
  ViewOptions options;
  options.fill = TriangleFill::area_ratio;
  options.brush = {true, TriangleFill::area_ratio, 1.0, 1.4};
  EXPECT_GT(expectFollows(options), 20);
}

TEST(ScenePatch, WhatLooksTheSameKeepsItsVersion) {
  const WholeRun run = wholeRun();
  Journal deaf;
  Scene scene;
  updateScene(scene, run.history.seek(run.end - 2, deaf), {}, nullptr, nullptr);
  const std::uint64_t points = scene.layer(LayerId::points).version;
  const std::uint64_t key = scene.layer(LayerId::points).key;
  updateScene(scene, run.history.seek(run.end - 1, deaf), {}, nullptr, nullptr);
  EXPECT_NE(scene.layer(LayerId::points).key, key);
  EXPECT_EQ(scene.layer(LayerId::points).version, points);
}

}  // namespace
}  // namespace triscope::scene_patch_test
