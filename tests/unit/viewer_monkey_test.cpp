// Commands at random, and at every state that comes of them everything that a viewer asks of one: with selections from
// other moments of the run, places outside the domain, events that are not known yet. Under the sanitizers this finds
// what reads a state before it is there. tests/window/monkey_test.py does the same to the whole window.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/density/wanted.h"
#include "core/explain/caption.h"
#include "core/explain/element.h"
#include "core/explain/insertion.h"
#include "core/explain/life.h"
#include "core/explain/why.h"
#include "core/io/domain_text.h"
#include "core/run/element_events.h"
#include "core/study/compare.h"
#include "render/figure.h"
#include "render/pick.h"
#include "render/picture.h"
#include "render/scene.h"
#include "support/random.h"
#include "support/session_driver.h"

namespace triscope::viewer_monkey_test {
namespace {

using support::Random;

struct Viewer {
  Session session;
  Random draw;
  Scene scene;             // kept from state to state, as the window keeps it
  std::vector<Pick> seen;  // picked at some moment or other
  std::size_t looks = 0;
};

template <class Enum>
Enum anyOf(Random& draw, int count) {
  return static_cast<Enum>(draw.below(static_cast<std::size_t>(count)));
}

Point anyPlace(Random& draw, const Box& box) {
  const double w = box.width();
  const double h = box.height();
  return {draw.between(box.lo.x - w, box.hi.x + w), draw.between(box.lo.y - h, box.hi.y + h)};
}

ViewOptions anyView(Random& draw) {
  ViewOptions o;
  for (bool* const layer :
       {&o.boundary, &o.boundaryPoints, &o.quadtree, &o.outsideCells, &o.constraints, &o.fronts, &o.steiner, &o.degrees,
        &o.triangulation, &o.helpers, &o.obtuse, &o.worst, &o.decision, &o.labels, &o.dimmed, &o.brush.on})
    *layer = draw.below(2) == 0;
  o.cells = anyOf<CellColoring>(draw, 3);
  o.fill = anyOf<TriangleFill>(draw, kTriangleFillCount);
  o.brush.measure = anyOf<TriangleFill>(draw, kTriangleFillCount);
  o.brush.low = 1.0;
  o.brush.high = 3.0;
  return o;
}

/// Mostly of what was picked before, which this state may not have; now and then of anything at all.
Pick anySelection(Viewer& v) {
  if (!v.seen.empty() && v.draw.below(4) > 0) return v.seen[v.draw.below(v.seen.size())];
  Pick pick;
  pick.id = static_cast<std::uint32_t>(v.draw.below(3000));
  pick.selection = {anyOf<Selection::Kind>(v.draw, 5), static_cast<std::int32_t>(v.draw.below(3000)) - 5,
                    static_cast<std::int32_t>(v.draw.below(5)) - 1};
  return pick;
}

Ref refOf(const Pick& pick) {
  switch (pick.selection.kind) {
    case Selection::Kind::vertex:
      return {Ref::Kind::vertex, pick.id};
    case Selection::Kind::cell:
      return {Ref::Kind::cell, pick.id};
    case Selection::Kind::none:
      return {Ref::Kind::event, pick.id};
    default:
      return {Ref::Kind::triangle, pick.id};
  }
}

/// What a legend counts is what is drawn.
void holdCounts(const Scene& scene) {
  for (const auto& [label, layer, shape] : {std::tuple{"first front", LayerId::fronts, Shape::circle},
                                            {"second front", LayerId::fronts, Shape::diamond},
                                            {"input point", LayerId::points, Shape::square},
                                            {"Steiner point", LayerId::points, Shape::triangle}}) {
    std::size_t drawn = 0;
    for (const MarkBatch& batch : scene.layer(layer).marks)
      if (batch.shape == shape) drawn += batch.at.size();
    for (const LegendItem& item : scene.legend)
      EXPECT_TRUE(item.label != label || item.value == grouped(drawn)) << label << ": " << item.value;
  }
}

void look(Viewer& v) {
  const SnapshotPtr& now = v.session.current();
  if (now == nullptr) return;
  ++v.looks;
  const MeshState& state = now->state;
  const Event* const last = now->last ? &*now->last : nullptr;
  const Pick selected = anySelection(v);
  const Selection here = present(state, selected);
  ViewOptions view = anyView(v.draw);
  view.selection = v.draw.below(2) == 0 ? here : selected.selection;
  std::optional<Insertion> insertion;
  const Events events = v.session.events();
  const Events run = v.session.runEvents();
  if (events.size() < run.size() && inserts(run[events.size()])) insertion = takeApart(state, run[events.size()]);
  const InsertionView inside{insertion ? &*insertion : nullptr,
                             static_cast<InsertionPhase>(1 + v.draw.below(kInsertionPhases))};
  updateScene(v.scene, state, view, last, &now->quality, insertion ? &inside : nullptr);
  if (!insertion) holdCounts(v.scene);
  Camera camera = fitted(v.scene.bounds, 640.0, 480.0, 20.0);
  (void)placeLabels(v.scene, camera, 1.0);
  EXPECT_FALSE(summaryOf(state, now->quality).empty());
  EXPECT_FALSE(figureCaption(state, state.stage).empty());
  if (last != nullptr) {
    const bool over = last->kind == EventKind::stage_finished;
    EXPECT_FALSE((over ? captionOf(*last, state) : captionOf(*last)).empty());
  }
  const Point place = anyPlace(v.draw, state.domain->bounds);
  EXPECT_EQ(wantedAt(state.tree, place).has_value(), !state.tree.cells.empty());
  const double reach = v.draw.between(0.0, 0.5);
  const Pick found = v.draw.below(2) == 0 ? pickCellFirst(state, place, reach) : pick(state, place, reach);
  if (found.selection.kind != Selection::Kind::none) {
    EXPECT_EQ(present(state, found), found.selection);
    v.seen.push_back(found);
  }
  const Ref ref = refOf(selected);
  EXPECT_FALSE(figuresOf(state, events, ref).empty());
  TriangleFacts facts;
  if (ref.kind == Ref::Kind::triangle) {
    facts = factsOf(state.mesh, TriangleId(ref.id)).value_or(TriangleFacts{});
    (void)whyNot(events, ref.id, facts);
  }
  if (ref.kind != Ref::Kind::event || ref.id < events.size()) {
    (void)why(events, ref, facts);
    (void)historyOf(events, ref, facts);
    (void)birthOf(run, ref);
    (void)eventsAbout(run, ref);
  }
  const RunRecord& record = v.session.record();
  if (record.complete) (void)counterpart({state.stage, state.tick, now->events}, record, record, std::nullopt);
}

Command anyCommand(Viewer& v, const std::shared_ptr<const Domain>& other) {
  Random& draw = v.draw;
  const std::uint64_t ticks = v.session.record().ticks;
  switch (draw.below(16)) {
    case 0:
      return command::Restart{};
    case 1:
      return command::Seek{draw.below(ticks + 10)};
    case 2:
      return command::StepBack{anyOf<Grain>(draw, 5)};
    case 3:
      return command::SeekEvent{draw.below(v.session.runEvents().size() + 10)};
    case 4:
    case 5:
      return command::GoTo{anyOf<Stage>(draw, kStageCount)};
    case 6:
      return command::Cancel{};
    case 7:
      return command::Pause{};
    case 8:
      return command::Play{draw.between(1.0, 1e5)};
    case 9:
      return command::OpenDomain{other};
    case 10: {
      Settings settings = v.session.settings();
      const SettingInfo& info = settingTable()[draw.below(settingTable().size())];
      (void)setSetting(settings, info, draw.between(info.lowest, std::min(info.highest, info.lowest + 2.0)));
      settings.minEdge = draw.below(2) == 0 ? 0.0 : draw.between(0.8, 2.0);
      return command::Change{settings};
    }
    case 11: {
      const std::shared_ptr<const Domain>& domain = v.session.domain();
      std::vector<DensityRequest> density = domain->density;
      DensityRequest request;
      request.at = {draw.between(domain->bounds.lo.x, domain->bounds.hi.x),
                    draw.between(domain->bounds.lo.y, domain->bounds.hi.y)};
      request.length = draw.between(0.3, 2.0);
      if (density.size() > 2)
        density.clear();
      else
        density.push_back(request);
      return command::Load{withDensity(*domain, std::move(density)), v.session.settings(), draw.below(ticks + 1)};
    }
    case 12:
      return command::SetBreakpoints{{{*Condition::compile("vertex == " + std::to_string(draw.below(200)))}}};
    case 13:
      return command::Continue{draw.below(2) == 0};
    case 14:
      return command::FindViolation{};
    default:
      return command::Advance{anyOf<Grain>(draw, 5)};
  }
}

class ViewerMonkey : public testing::TestWithParam<int> {};

TEST_P(ViewerMonkey, ReadsEveryStateSafely) {
  Viewer v;
  v.draw.state = static_cast<std::uint64_t>(GetParam());
  doNow(v.session, command::OpenDomain{square(1.0)});
  // First the ends of all stages, then leaps.
  doNow(v.session, command::Restart{});
  for (look(v); v.session.current()->state.stage != Stage::finished; look(v))
    doNow(v.session, command::Advance{Grain::stage});
  for (int k = 0; k < 150; ++k) {
    v.session.apply(anyCommand(v, square(v.draw.between(0.7, 1.5))));
    // Some are looked at half done.
    v.session.settle(v.draw.below(3) == 0 ? std::chrono::milliseconds(1) : std::chrono::milliseconds(200));
    look(v);
    if (testing::Test::HasFailure()) FAIL() << "command " << k;
  }
  EXPECT_GT(v.looks, 120u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ViewerMonkey, testing::Range(1, 5));

}  // namespace
}  // namespace triscope::viewer_monkey_test
