#include "ui/app/app.h"

#include <utility>

#include "core/domain/read.h"
#include "render/embedded.h"
#include "ui/app/frame_regions.h"
#include "ui/app/orders.h"
#include "ui/app/picture.h"
#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr const char* kFirstSample = "blunt_body.json";

Order firstSample() {
  const auto bytes = findEmbedded(embeddedSamples(), kFirstSample);
  const std::string text(bytes.begin(), bytes.end());
  Result<Domain> sample = parseDomain(text, "");
  if (!sample) return Command(command::OpenFile{kFirstSample});
  return Command(command::OpenDomain{std::make_shared<const Domain>(std::move(*sample))});
}

/// Counts what tests wait for, and lets tooltips show again once the mouse moves.
void noteMouse(UiState& ui) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0.0f || moved.y != 0.0f) ui.tipsWait = false;
  for (const bool pressed : ImGui::GetIO().MouseClicked) ui.buttonsPressed += pressed ? 1u : 0u;
  for (const bool released : ImGui::GetIO().MouseReleased) ui.buttonsReleased += released ? 1u : 0u;
}

/// Returns its height.
float drawMenu(const View& shown, Orders& orders) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {shown.px(8), shown.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  const bool begun = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar(2);
  if (!begun) return 0.0f;
  drawMenuBar(shown, orders);
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace

App::App(const WindowOptions& options, std::function<void()> wake) : parts_(options, std::move(wake)) {
  // Meshing begins while the window is still being made.
  carryOut(parts_, options.file.empty() ? firstSample() : Order(Command(command::OpenFile{options.file})));
}

App::~App() { parts_.sweeping.cancel(); }  // it ends while the rest is put away

std::string App::start(double monitorScale) {
  setMonitorScale(monitorScale);
  parts_.renderer = std::make_unique<GlRenderer>();
  return parts_.renderer->start();
}

void App::releaseGl() {
  parts_.comparison.letGo();
  parts_.renderer.reset();
}

bool App::settled() const { return parts_.desk.session.current() != nullptr && !parts_.desk.session.busy(); }

void App::onKey(int key, int mods) { parts_.keyboard.press(key, mods, parts_.sweeping.mapAction(key, mods)); }

void App::onDrop(const std::string& path) { carryOut(parts_, Order(Command(command::OpenFile{path}))); }

void App::performPressed() {
  for (const Action action : parts_.keyboard.take()) {
    const bool always = action == Action::cancel || action == Action::quit || action == Action::help;
    if (parts_.desk.ui.dialog == Dialog::none || always) carryOut(parts_, Orders{action});
  }
}

bool App::poll() {
  bool news = parts_.desk.session.poll();
  if (news) follow(parts_);
  news = parts_.comparison.poll() || news;
  news = parts_.document.saved() || parts_.exporting.ready() || news;
  parts_.document.keep();
  return parts_.sweeping.follow() || news;
}

void App::frame() {
  UiState& ui = parts_.desk.ui;
  parts_.stateFile.beginFrame();
  noteMouse(ui);
  performPressed();
  Orders orders;
  const float menu = drawMenu(viewOf(parts_), orders);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const bool resized = size.x != windowSize_.x || size.y != windowSize_.y;
  if (resized && ui.dialog == Dialog::none) closeMenus();  // they would stay where the place they are about was
  windowSize_ = size;
  parts_.legend.look(size);
  const View shown = viewOf(parts_);
  const Layout layout = layoutOf(size, menu, toolbarHeight(shown, size.x), legendNeeds(shown), ui);
  parts_.legend.place(shown, layout);
  parts_.comparison.follow();
  // Not while a control is held: where it is let go decides.
  if (!parts_.tuning.holds()) parts_.dialogs.askAboutLimit();
  drawPicture(parts_, layout.canvas);
  parts_.debugging.updateAnswers();
  drawRegions(parts_, layout, orders);
  const SnapshotPtr drawn = parts_.desk.shown;
  carryOut(parts_, orders);
  parts_.exporting.follow();
  parts_.document.keep();
  parts_.dialogs.finishFrame();
  // Where the orders made something newer than what was drawn, the next frame tells of both.
  if (parts_.stateFile.wanted() && parts_.desk.shown == drawn)
    parts_.stateFile.update(describeWindow(viewOf(parts_), captionNow(viewOf(parts_))), frames_);
}

void App::finishFrame(double milliseconds) {
  parts_.keyboard.finishFrame();
  parts_.desk.ui.frameMs = milliseconds;
  ++frames_;
}

}  // namespace triscope
