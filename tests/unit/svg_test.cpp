#include "render/svg.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "render/figure.h"
#include "sample_states.h"

namespace triscope::svg_test {
namespace {

// Every tag closed in order, every attribute quoted, no bare '<' or '&' in text. "" when all is well.
std::string complaintAbout(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t i = 0;
  while (i < xml.size()) {
    if (xml[i] == '&') {
      const std::size_t end = xml.find(';', i);
      if (end == std::string::npos || end - i > 6) return "bare & at " + std::to_string(i);
    }
    if (xml[i] != '<') {
      ++i;
      continue;
    }
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos) return "tag never ends";
    const std::string tag = xml.substr(i + 1, end - i - 1);
    if (tag.find('<') != std::string::npos) return "bare < in " + tag.substr(0, 40);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "odd quotes in " + tag.substr(0, 60);
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "unexpected </" + tag.substr(1) + ">";
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    i = end + 1;
  }
  return open.empty() ? "" : "open: " + open.back();
}

struct Drawing {
  Scene scene;
  PictureOptions options;
  PictureLayout layout;
  Camera camera;
};

Drawing drawingOf(const MeshState& state, const ViewOptions& view) {
  Drawing drawing;
  const Quality quality = measure(state.mesh);
  drawing.scene = buildScene(state, view, nullptr, &quality);
  drawing.options.title = "A < B & \"C\"";
  drawing.options.caption = "caption with ω and θ";
  drawing.layout = layoutWithin(800, 600, 1.0, drawing.scene, drawing.options);
  drawing.camera = fitted(drawing.scene.bounds, drawing.layout.plot.width, drawing.layout.plot.height, 4.0);
  return drawing;
}

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(Svg, IsWellFormedAtEveryStage) {
  for (const StageInfo& info : stages()) {
    const MeshState state = sample::after(sample::kFrame, info.id);
    const Drawing d = drawingOf(state, figureView(info.id));
    const std::string text = svg(d.scene, d.camera, d.layout, d.options);
    EXPECT_EQ(complaintAbout(text), "") << info.key;
    EXPECT_NE(text.find("A &lt; B &amp; &quot;C&quot;"), std::string::npos);
    EXPECT_NE(text.find("caption with ω and θ"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
    for (const LegendItem& item : d.scene.legend) EXPECT_NE(text.find(">" + item.label + "<"), std::string::npos);
  }
}

TEST(Svg, DrawsEachTriangleOnceAndTheCirclesInTheirStyles) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  ViewOptions view = figureView(Stage::step1);
  const Drawing d = drawingOf(state, view);
  const std::string text = svg(d.scene, d.camera, d.layout, d.options);
  char fill[40];
  const Color c = d.scene.theme.domainFill;
  std::snprintf(fill, sizeof fill, "<path fill=\"#%02x%02x%02x\"", c.r, c.g, c.b);
  const std::size_t from = text.find(fill);
  ASSERT_NE(from, std::string::npos);
  const std::string path = text.substr(from, text.find("/>", from) - from);
  EXPECT_EQ(countOf(path, "z"), state.mesh.liveCount());
  EXPECT_GE(countOf(text, "stroke-dasharray"), 4u) << "dashed and dash-dotted, in the plot and in the legend";
  EXPECT_EQ(countOf(text, "<circle"), 9u) << "three with a ring of background, three in the legend";
}

TEST(Svg, IsTheSameEveryTime) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const Drawing a = drawingOf(state, {});
  const Drawing b = drawingOf(state, {});
  EXPECT_EQ(svg(a.scene, a.camera, a.layout, a.options), svg(b.scene, b.camera, b.layout, b.options));
}

TEST(Layout, KeepsThePlotTheLegendAndTheCaptionApart) {
  const MeshState state = sample::after(sample::kFrame, Stage::front2);
  const Quality quality = measure(state.mesh);
  const Scene scene = buildScene(state, {}, nullptr, &quality);
  PictureOptions options;
  options.title = "title";
  options.caption =
      "a caption long enough to be broken into several lines when the picture is narrow, which it is here";
  for (const double width : {320.0, 800.0, 2000.0}) {
    for (const double aspect : {0.0, 0.1, 1.0, 20.0}) {
      const PictureLayout l = layoutWithin(width, 700.0, aspect, scene, options);
      EXPECT_EQ(l.width, width);
      EXPECT_GE(l.legend.x, l.plot.x + l.plot.width);
      EXPECT_LE(l.legend.x + l.legend.width, width + 1e-9 + (width < 400 ? 200.0 : 0.0));
      EXPECT_GT(l.plot.width, 0.0);
      EXPECT_GT(l.plot.height, 0.0);
      EXPECT_LE(l.plot.y + l.plot.height + 18.0 * static_cast<double>(l.captionLines.size()), 700.0);
      for (const std::string& line : l.captionLines) EXPECT_LE(l.plot.x + textWidth(line, 12.5), width);
    }
  }
  const PictureLayout around = layoutAround(Camera{{0, 0}, 1.0, 640.0, 480.0}, scene, options);
  EXPECT_EQ(around.plot.width, 640.0);
  EXPECT_EQ(around.plot.height, 480.0);
}

TEST(Layout, LabelsNeverOverlapAndStayInside) {
  Scene scene;
  Layer& layer = scene.layers[static_cast<std::size_t>(LayerId::worst)];
  for (int i = 0; i < 12; ++i) {
    Label label;
    label.at = {50.0 + 3.0 * i, 50.0};
    label.text = "label " + std::to_string(i);
    label.dx = 6.0f;
    label.dy = -6.0f;
    layer.labels.push_back(label);
  }
  const Camera camera{{50.0, 50.0}, 2.0, 300.0, 200.0};
  const auto placed = placeLabels(scene, camera, 1.0);
  EXPECT_GE(placed.size(), 4u);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_GE(placed[i].at.x, 0.0);
    EXPECT_LE(placed[i].at.x + placed[i].width, 300.0);
    for (std::size_t k = 0; k < i; ++k) {
      const bool apart = placed[i].at.x >= placed[k].at.x + placed[k].width ||
                         placed[k].at.x >= placed[i].at.x + placed[i].width ||
                         std::fabs(placed[i].at.y - placed[k].at.y) >= 13.0;
      EXPECT_TRUE(apart) << placed[i].label->text << " on " << placed[k].label->text;
    }
  }
}

TEST(Layout, LabelsKeepClearOfWhatIsThereWhereTheyCan) {
  Scene scene;
  Label label;
  label.at = {50.0, 50.0};
  label.text = "worst";
  label.dx = 6.0f;
  label.dy = -6.0f;
  scene.layers[static_cast<std::size_t>(LayerId::worst)].labels.push_back(label);
  const Camera camera{{50.0, 50.0}, 2.0, 300.0, 200.0};
  const Pixel free = placeLabels(scene, camera, 1.0).at(0).at;
  const std::array<Rect, 1> there{{{free.x, free.y - 10.0, 20.0, 10.0}}};
  const Pixel aside = placeLabels(scene, camera, 1.0, there).at(0).at;
  EXPECT_NE(aside, free);
  const std::array<Rect, 1> everywhere{{{0.0, 0.0, 300.0, 200.0}}};
  EXPECT_EQ(placeLabels(scene, camera, 1.0, everywhere).at(0).at, free);
}

class FigureFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("triscope_figure_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(FigureFile, IsWrittenByItsEnding) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const ViewOptions view = figureView(Stage::step1);
  FigureOptions options;
  options.width = 300;
  options.height = 200;
  ASSERT_TRUE(writeFigure(path("f.svg"), state, view, options).ok());
  ASSERT_TRUE(writeFigure(path("f.PNG"), state, view, options).ok());
  std::ostringstream text;
  text << std::ifstream(path("f.svg")).rdbuf();
  EXPECT_EQ(text.str().rfind("<svg ", 0), 0u);
  std::ostringstream png;
  png << std::ifstream(path("f.PNG"), std::ios::binary).rdbuf();
  EXPECT_EQ(png.str().rfind("\x89PNG\r\n", 0), 0u);
}

TEST_F(FigureFile, RefusesWhatItCannotDo) {
  const MeshState state = sample::after(sample::kFrame, Stage::step1);
  const Status ending = writeFigure(path("f.jpg"), state, {}, {});
  ASSERT_FALSE(ending.ok());
  EXPECT_EQ(ending.error().kind, ErrorKind::usage);
  FigureOptions tiny;
  tiny.width = 3;
  EXPECT_EQ(writeFigure(path("f.svg"), state, {}, tiny).error().kind, ErrorKind::usage);
  const Status nowhere = writeFigure(path("no/such/folder/f.svg"), state, {}, {});
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.error().kind, ErrorKind::cannot_write);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST(Figures, ThePapersComeFromOneTable) {
  EXPECT_EQ(figurePresets().size(), 13u);
  std::string_view domain;
  Stage before = Stage::constraints;
  for (const FigurePreset& preset : figurePresets()) {
    if (preset.domain != domain) before = Stage::constraints;
    domain = preset.domain;
    EXPECT_GE(preset.stage, before) << preset.name << ": one run draws them in order";
    before = preset.stage;
    const auto read = readDomain(std::string(TRISCOPE_SOURCE_DIR "/assets/domains/") + std::string(domain) + ".json");
    ASSERT_TRUE(read.ok()) << preset.name;
    EXPECT_EQ(regionAround(*read, preset.loop).has_value(), !preset.loop.empty()) << preset.name;
  }
}

TEST(Figures, TheRegionAroundALoopHoldsIt) {
  const MeshState state = sample::start(sample::kFrame);
  const auto region = regionAround(*state.domain, "hole 1");
  ASSERT_TRUE(region.has_value());
  EXPECT_EQ(region->lo, (Point{-3.0, -3.0}));
  EXPECT_EQ(region->hi, (Point{3.0, 3.0}));
}

}  // namespace
}  // namespace triscope::svg_test
