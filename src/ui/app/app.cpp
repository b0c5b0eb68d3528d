#include "ui/app/app.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/domain/read.h"
#include "render/embedded.h"
#include "render/figure.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/model/preferences.h"
#include "ui/panel/panels.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

// A dialog is in its place, and its text field ready for keys, so many frames after the dialog was asked for.
constexpr std::uint64_t kFramesOfOpening = 3;
// Dear ImGui says some frames after the key which ends the typing that text is no longer wanted.
constexpr std::uint64_t kFramesOfTypingsEnd = 4;

constexpr const char* kFirstSample = "blunt_body.json";

Command firstSample() {
  const auto bytes = findEmbedded(embeddedSamples(), kFirstSample);
  const std::string text(bytes.begin(), bytes.end());
  Result<Domain> sample = parseDomain(text, "");
  if (!sample) return command::OpenFile{kFirstSample};
  return command::OpenDomain{std::make_shared<const Domain>(std::move(*sample))};
}

}  // namespace

App::App(const WindowOptions& options, std::function<void()> wake)
    : wake_(std::move(wake)),
      session_(wake_),
      autosave_(options.screenshot.empty() ? Autosave::defaultFolder() : std::string(), wake_),
      stateFile_(options.stateFile) {
  preferencesPath_ = options.preferences.empty()     ? preferencesPath()
                     : options.preferences == "none" ? ""
                                                     : options.preferences;
  if (!preferencesPath_.empty()) ui_.look = readPreferences(preferencesPath_);
  savedLook_ = ui_.look;
  ui_.options.theme = ui_.look.theme;
  // Meshing begins while the window is still being made.
  if (options.file.empty())
    session_.apply(firstSample());
  else
    openFile(options.file);
  ui_.document.kept = autosave_.keptWork();
  ui_.document.offering = !ui_.document.kept.empty();
}

App::~App() {
  sweep_.cancel();  // it ends while the rest is put away
  closeDocument();
  if (!preferencesPath_.empty() && ui_.look != savedLook_) writePreferences(preferencesPath_, ui_.look);
}

std::string App::start(double monitorScale) {
  ui_.monitorScale = monitorScale;
  renderer_ = std::make_unique<GlRenderer>();
  return renderer_->start();
}

bool App::takesKeys() const {
  if (ui_.debug.typeSoon > 0) return false;
  if (frames_ < typingEnds_ && ImGui::GetIO().WantTextInput) return false;
  return !opensDialog();
}

bool App::opensDialog() const { return dialogDrawn_ != Dialog::none && frames_ - dialogFrame_ < kFramesOfOpening; }

void App::onKey(int key, int mods) {
  // While text is typed, keys without Ctrl and those that edit text are not commands; Esc and F1 … F25 always are.
  if (!isModifier(key)) {
    ++ui_.keysPressed;
    ui_.tipsWait = true;
  }
  const bool endsTyping = key == GLFW_KEY_ESCAPE || key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  if (endsTyping && ImGui::GetIO().WantTextInput) typingEnds_ = frames_ + kFramesOfTypingsEnd;
  std::optional<Action> action = heatMapAction(key, mods);
  if (!action) action = actionFor(key, mods);
  if (!action) return;
  const bool edits = !withCtrl(mods) || *action == Action::undo || *action == Action::redo;
  pressed_.push_back({*action, edits && !isFunctionKey(key) && *action != Action::cancel});
}

void App::performPressed() {
  for (const auto [action, types] : std::exchange(pressed_, {})) {
    // Asked only now: the key before it may have ended the typing.
    if (types && ImGui::GetIO().WantTextInput) continue;
    const bool always = action == Action::cancel || action == Action::quit || action == Action::help;
    if (ui_.dialog == Dialog::none || always) perform(action);
  }
}

void App::onDrop(const std::string& path) { apply(command::OpenFile{path}); }

bool App::poll() {
  bool news = session_.poll();
  if (news) followRun();
  if (pinned_ && pinned_->poll()) news = true;
  if (news) followInsertion();
  if (news) showFound();
  const bool saved = save_.ready();
  followDocument();
  const bool swept = followSweep();
  return news || saved || swept || export_.ready();
}

void App::followRun() {
  if (session_.failures() != failuresSeen_ && session_.error()) {
    ui_.error = session_.error();
    openDialog(Dialog::error);
  }
  failuresSeen_ = session_.failures();
  if (session_.notice() != saidNotice_) ui_.message = saidNotice_ = session_.notice();
  std::erase_if(versions_, [](const std::weak_ptr<const Domain>& version) { return version.expired(); });
  ui_.document.opening = session_.domain() != nullptr && !isVersion(session_.domain());
  if (view().request() == nullptr) ui_.density.request.reset();  // of another domain, or taken back
  const SnapshotPtr& now = session_.current();
  if (now == nullptr || now == shown_) return;
  shown_ = now;
  if (now->state.domain != shownDomain_) {
    const bool another = !isVersion(now->state.domain);
    shownDomain_ = now->state.domain;
    if (another) beginDocument();
  }
  // A change that was given up or refused is no step of undo.
  if (!session_.busy() && !tuning_)
    while (!ui_.undo.empty() && ui_.undo.back() == inForce()) ui_.undo.pop_back();
  keepInRange();
}

void App::followStage() {
  if (!ui_.layersFollow || !shown_) return;
  const ViewOptions figure = figureView(view().stage());
  ui_.options.quadtree = figure.quadtree;
  ui_.options.constraints = figure.constraints;
}

bool App::prepareFrame() {
  const double scale = ui_.scale();
  const bool rescaled = scale != styledScale_;
  if (!rescaled && ui_.look.theme == styledTheme_) return false;
  if (rescaled) fonts_ = loadFonts(static_cast<float>(scale));
  applyStyle(themeOf(ui_.look.theme), static_cast<float>(scale));
  styledScale_ = scale;
  styledTheme_ = ui_.look.theme;
  return rescaled;
}

View App::view() {
  return {session_,        ui_,
          scene_,          fonts_,
          answers_,        renderer_ ? renderer_->texture() : 0,
          legendOnCanvas_, stateFile_.wanted() ? &widgets_ : nullptr,
          pinned_.get(),   stateFile_.wanted() ? &tooltip_ : nullptr};
}

void App::frame() {
  widgets_.clear();
  tooltip_.clear();
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0.0f || moved.y != 0.0f) ui_.tipsWait = false;
  for (const bool pressed : ImGui::GetIO().MouseClicked) ui_.buttonsPressed += pressed ? 1u : 0u;
  for (const bool released : ImGui::GetIO().MouseReleased) ui_.buttonsReleased += released ? 1u : 0u;
  performPressed();
  Orders orders;
  float menuHeight = 0.0f;
  const View shown = view();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {shown.px(8), shown.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  const bool hasMenu = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar(2);
  if (hasMenu) {
    drawMenuBar(shown, orders);
    menuHeight = ImGui::GetWindowHeight();
    ImGui::EndMainMenuBar();
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const bool resized = size.x != windowSize_.x || size.y != windowSize_.y;
  if (resized && ui_.dialog == Dialog::none) closeMenus();  // they would stay where the place they are about was
  windowSize_ = size;
  forgetLegendPlace();
  const Layout layout = layoutOf(size, menuHeight, toolbarHeight(view(), size.x), legendNeeds(view()), ui_);
  placeLegend(layout);
  followStage();
  followPinned();
  askAboutLimit();
  drawPicture(layout.canvas);
  updateAnswers();
  drawRegions(layout, view(), orders);
  const SnapshotPtr drawn = shown_;
  for (const Order& order : orders) carryOut(order);
  if (!orders.empty()) followRun();
  finishExport();
  followDocument();
  if (ui_.dialog != dialogDrawn_) {
    dialogDrawn_ = ui_.dialog;
    dialogFrame_ = frames_;
  }
  // Where the orders made something newer than what was drawn, the next frame tells of both.
  if (stateFile_.wanted() && shown_ == drawn) stateFile_.update(describeWindow(view(), captionNow(view())), frames_);
}

void App::finishFrame(double milliseconds) {
  ui_.frameMs = milliseconds;
  ++frames_;
}

void App::forgetLegendPlace() {
  LegendRoom room{windowSize_, ui_.scale(), ui_.look, ui_.debug.bottom, ui_.sidePanels, pinned_ != nullptr};
  if (room == legendRoom_) return;
  legendRoom_ = std::move(room);
  ui_.legendPlace = LegendPlace::anywhere;
}

void App::placeLegend(const Layout& layout) {
  const ImVec2 needs = legendNeeds(view());
  const bool elsewhere = needs.y > 0.0f && layout.legend.size.y <= 0.0f;
  const bool folded = ui_.legendPlace == LegendPlace::folded;
  ui_.legendFolded =
      elsewhere && (folded || !legendMayCover(view(), panesOf(layout.canvas, pinned_ != nullptr).live.size));
  ui_.legendOver = ui_.legendOver && ui_.legendFolded;
  legendOnCanvas_ = elsewhere && !ui_.legendFolded;
  if (needs.y > 0.0f)
    ui_.legendPlace = ui_.legendFolded  ? LegendPlace::folded
                      : legendOnCanvas_ ? LegendPlace::picture
                                        : LegendPlace::column;
}

void App::drawPicture(const Region& region) {
  const Panes panes = panesOf(region, pinned_ != nullptr);
  const double width = std::max(1.0, static_cast<double>(panes.live.size.x));
  const double height = std::max(1.0, static_cast<double>(panes.live.size.y));
  if (ui_.camera.width != width || ui_.camera.height != height) ui_.camera = resized(ui_.camera, width, height);
  if (const SnapshotPtr& now = session_.current()) {
    ViewOptions options = ui_.options;
    options.theme = ui_.look.theme;
    options.dimmed = session_.stale();
    options.selection = view().selection();
    const InsertionUi& insertion = ui_.insertion;
    const bool entered = view().inInsertion();
    const bool inside = entered && insertion.phase != InsertionPhase::filled;
    options.worst = options.worst && !entered;  // their circles would be taken for the insertion's
    const InsertionView shown{insertion.now.get(), insertion.phase};
    updateScene(scene_, now->state, options, now->last ? &*now->last : nullptr, &now->quality,
                inside ? &shown : nullptr);
    if (fitted_) fit();
  } else {
    scene_.theme = themeOf(ui_.look.theme);
  }
  renderer_->draw(scene_, ui_.camera, ui_.scale());
  if (pinned_) {
    ViewOptions options = ui_.options;
    options.theme = ui_.look.theme;
    pinned_->draw(options, ui_.camera, ui_.scale());
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 corner = pinned_ && mouse.x < panes.live.at.x ? panes.pinned.at : panes.live.at;
  const Point pixel{static_cast<double>(mouse.x - corner.x), static_cast<double>(mouse.y - corner.y)};
  const bool over = pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < width && pixel.y < height;
  ui_.cursor = over && session_.current() ? std::optional(toWorld(ui_.camera, pixel)) : std::nullopt;
}

void App::drawRegions(const Layout& layout, const View& shown, Orders& orders) {
  struct Fixed {
    const char* name;
    const Region& region;
    ImVec2 padding;
    void (*draw)(const View&, Orders&);
    bool sunken;
  };
  const std::array<Fixed, 4> fixed{{
      {"##toolbar", layout.toolbar, {shown.px(10), shown.px(8)}, drawToolbar, false},
      {"##canvas", layout.canvas, {0, 0}, drawCanvas, true},
      {"##caption", layout.caption, {shown.px(12), shown.px(9)}, drawCaption, false},
      {"##status", layout.status, {shown.px(12), shown.px(5)}, drawStatusBar, false},
  }};
  for (const Fixed& part : fixed) {
    const ImGuiWindowFlags flags = part.sunken ? ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground : 0;
    if (beginRegion(part.name, part.region, part.padding, flags)) part.draw(shown, orders);
    ImGui::End();
  }
  if (layout.legend.size.y > 0.0f) {
    if (beginRegion("##legend", layout.legend, {0, 0})) drawLegendRegion(shown, orders);
    ImGui::End();
  }
  // With one column left, it has all the tabs.
  const bool both = layout.right.size.x >= 2.0f;
  drawSide("##left", both ? std::optional(Side::left) : std::nullopt, layout.left, shown, orders);
  if (both) drawSide("##right", Side::right, layout.right, shown, orders);
  wantedTab_.reset();
  ui_.sidePanelsShown = layout.left.size.x >= 2.0f;
  drawBottom(layout, shown, orders);
  const bool typing = ImGui::GetIO().WantTextInput || ui_.debug.bottom != Panel::breakpoints;
  ui_.debug.typeSoon = typing ? 0 : std::max(0, ui_.debug.typeSoon - 1);
  drawSplitters(shown, orders, layout);
  drawDialog(shown, orders);
}

void App::drawSide(const char* name, std::optional<Side> side, const Region& region, const View& shown,
                   Orders& orders) {
  if (region.size.x < 2.0f) return;
  constexpr ImGuiTabBarFlags kTabs = ImGuiTabBarFlags_FittingPolicyScroll | ImGuiTabBarFlags_NoTooltip;
  if (beginRegion(name, region, {shown.px(10), shown.px(6)}) && ImGui::BeginTabBar("tabs", kTabs)) {
    for (const PanelInfo& panel : panels()) {
      if (side ? panel.side != *side : panel.side == Side::bottom) continue;
      const ImGuiTabItemFlags flags = wantedTab_ == panel.id ? ImGuiTabItemFlags_SetSelected : 0;
      const bool open = ImGui::BeginTabItem(panel.name, nullptr, flags);
      note(shown, std::string("tab.") + panel.name);
      if (!open) continue;
      if (!wantedTab_) (panel.side == Side::left ? ui_.tab : ui_.debug.rightTab) = panel.id;
      if (ImGui::BeginChild("content", {0, 0}, false)) panel.draw(shown, orders);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

void App::drawDialog(const View& shown, Orders& orders) {
  switch (ui_.dialog) {
    case Dialog::none:
      break;
    case Dialog::open:
      openDialog_.draw(shown, orders);
      break;
    case Dialog::save_as:
      saveDialog_.draw(shown, orders);
      break;
    case Dialog::export_to:
      exportDialog_.draw(shown, orders);
      break;
    case Dialog::error:
      drawErrorDialog(shown, orders);
      break;
    case Dialog::help:
      drawHelpDialog(shown, orders);
      break;
    case Dialog::about:
      drawAboutDialog(shown, orders);
      break;
    case Dialog::limit:
      limitDialog_.draw(shown, orders);
      break;
  }
}

}  // namespace triscope
