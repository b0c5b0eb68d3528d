// The picture of the run, and the mouse on it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/number.h"
#include "core/density/quadtree.h"
#include "render/picture.h"
#include "ui/kit/density_handles.h"
#include "ui/kit/imgui_canvas.h"
#include "ui/kit/imgui_pixels.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/model/pinned_run.h"
#include "ui/region/layout.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr double kPickReach = 8.0;   // pixels at 100 %
constexpr float kClickSlack = 4.0f;  // a press that moves less is a click

bool draggedFar(const View& view) {
  const float slack = view.px(static_cast<double>(kClickSlack));
  return ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > slack * slack;
}

void zoomByWheel(const View& view, Orders& orders, Pixel mouse) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0.0f) return;
  const double factor = std::pow(1.2, static_cast<double>(wheel));
  orders.emplace_back(zoomed(view.ui.camera, mouse, factor, view.scene.bounds));
}

void pan(const View& view, Orders& orders) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  if (delta.x != 0.0f || delta.y != 0.0f) orders.emplace_back(panned(view.ui.camera, toPixels(delta)));
}

/// A rectangle drawn with Shift held; on release it is what is shown.
void boxZoom(const View& view, Orders& orders, ImVec2 corner, bool released) {
  const ImVec2 from = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
  const ImVec2 to = ImGui::GetIO().MousePos;
  const ImU32 color = toImU32(accentOf(view.theme()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, to, (color & 0x00FFFFFFu) | 0x30000000u);
  list.AddRect(from, to, color, 0.0f, ImDrawFlags_None, view.px(1.5));
  if (!released) return;
  Box box;
  box.include(toWorld(view.ui.camera, toPixels({from.x - corner.x, from.y - corner.y})));
  box.include(toWorld(view.ui.camera, toPixels({to.x - corner.x, to.y - corner.y})));
  orders.emplace_back(order::Frame{box});
}

void click(const View& view, Orders& orders, Pixel mouse) {
  if (view.now() == nullptr) return;
  const double reach = kPickReach * view.ui.scale() / view.ui.camera.scale;
  const auto look = ImGui::GetIO().KeyCtrl ? pickCellFirst : pick;
  orders.emplace_back(order::SelectElement{look(view.now()->state, toWorld(view.ui.camera, mouse), reach)});
}

void centreOn(const View& view, Orders& orders, Pixel mouse) {
  Camera camera = view.ui.camera;
  camera.centre = toWorld(camera, mouse);
  orders.emplace_back(camera);
}

/// What can be asked about the element under the mouse; each entry selects it first.
void aboutTheElement(const View& view, Orders& orders, Pixel mouse) {
  if (view.now() == nullptr) return;
  const double reach = kPickReach * view.ui.scale() / view.ui.camera.scale;
  const Pick here = pick(view.now()->state, toWorld(view.ui.camera, mouse), reach);
  const std::optional<Ref> ref = refOf(here);
  const auto entry = [&](const char* label, const std::string& keys, const char* name) {
    const bool pressed = ImGui::MenuItem(label, keys.c_str(), false, ref.has_value());
    note(view, name, ref.has_value());
    if (pressed) orders.emplace_back(order::SelectElement{here});
    return pressed;
  };
  // An action is offered where it can be done once the element is selected.
  UiState selected = view.ui;
  selected.selected = here;
  const View then{{view.session, selected, view.pinned},
                  view.scene,
                  view.fonts,
                  view.debug,
                  view.canvasTexture,
                  view.legendOnCanvas,
                  view.widgets,
                  view.tooltip};
  const auto ask = [&](Action action, const char* label, const char* name) {
    Orders asked;
    actionEntry(then, asked, action, label, name);
    if (asked.empty()) return;
    orders.emplace_back(order::SelectElement{here});
    orders.insert(orders.end(), asked.begin(), asked.end());
  };
  entry(("Select " + (ref ? nameOf(*ref) : "what is here")).c_str(), "click", "context.select");
  ask(Action::why, "Why is it here?", "context.why");
  ask(Action::breakpoint, "Break here", "context.break");
  if (entry("History", "", "context.history")) orders.emplace_back(order::ShowTab{Panel::history});
}

void contextMenu(const View& view, Orders& orders, ImVec2 corner) {
  if (!ImGui::BeginPopup("canvas menu")) return;
  const ImVec2 at = ImGui::GetMousePosOnOpeningCurrentPopup();
  const Pixel mouse = toPixels({at.x - corner.x, at.y - corner.y});
  const Point world = toWorld(view.ui.camera, mouse);
  aboutTheElement(view, orders, mouse);
  const bool hasCells = view.now() != nullptr && !view.now()->state.tree.cells.empty();
  if (ImGui::MenuItem("Select the quadtree cell here", "Ctrl+click", false, hasCells))
    orders.emplace_back(order::SelectElement{pickCellFirst(view.now()->state, world, 0.0)});
  note(view, "context.cell", hasCells);
  if (ImGui::MenuItem("Centre here", "double click")) centreOn(view, orders, mouse);
  if (ImGui::MenuItem("Copy coordinates"))
    ImGui::SetClipboardText(fmt::format("{:.17g}, {:.17g}", world.x, world.y).c_str());
  ImGui::Separator();
  actionEntry(view, orders, Action::fit, "Fit", "context.fit");
  ImGui::EndPopup();
}

/// `edits`: density constraints can be placed and moved here.
void mouse(const View& view, Orders& orders, ImVec2 corner, bool edits) {
  const Pixel at = mouseOn(corner);
  if (ImGui::IsItemHovered()) zoomByWheel(view, orders, at);
  const bool released = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  const bool held = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool box = ImGui::GetIO().KeyShift;
  const bool taken = edits && densityMouse(view, orders, corner);
  if (taken) {
    // A density constraint is placed or moved.
  } else if ((held || released) && draggedFar(view)) {
    if (box)
      boxZoom(view, orders, corner, released);
    else if (held)
      pan(view, orders);
  } else if (released && !box) {
    click(view, orders, at);
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Middle)) pan(view, orders);
  if (ImGui::IsItemHovered() && !taken && !view.ui.density.placing &&
      ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    centreOn(view, orders, at);
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) ImGui::OpenPopup("canvas menu");
}

/// `avoid`: rectangles of the canvas that have something on them already. Tests know them by their texts.
void labels(const View& view, ImVec2 corner, std::span<const Rect> avoid, bool told) {
  ImGuiCanvas canvas(*ImGui::GetWindowDrawList(), view.fonts);
  const double scale = view.ui.scale();
  for (const PlacedLabel& placed : placeLabels(view.scene, view.ui.camera, scale, avoid)) {
    const Label& label = *placed.label;
    canvas.text(toPixels(corner) + placed.at, label.text,
                {static_cast<double>(label.size) * scale, Weight::semibold, label.color, label.halo, Anchor::left});
    if (!told || view.widgets == nullptr) continue;
    const ImVec2 lo{corner.x + static_cast<float>(placed.at.x),
                    corner.y + static_cast<float>(placed.at.y - static_cast<double>(label.size) * scale)};
    view.widgets->push_back({"label." + label.text,
                             lo,
                             {lo.x + static_cast<float>(placed.width), corner.y + static_cast<float>(placed.at.y)},
                             true});
  }
}

std::string whereabouts(const Progress& p) {
  if (p.activity == Activity::searching)
    return fmt::format("Searching {}, decision {}", infoOf(p.stage).name, grouped(p.tick));
  std::string text = fmt::format("{}: {}", infoOf(p.stage).name, counted(p.triangles, "triangle", "triangles"));
  if (p.estimated > 0.0) text += " of about " + grouped(static_cast<std::uint64_t>(std::llround(p.estimated)));
  return text;
}

/// How far a long run or search is, over the dimmed old mesh where there is one, with a way out.
void progress(const View& view, Orders& orders, ImVec2 corner, ImVec2 size) {
  const Progress& p = view.session.progress();
  if (!view.session.busy() || p.activity == Activity::playing || p.seconds < 0.25) return;
  const float width = std::min(view.px(420), size.x - view.px(24));
  if (beginFloating(view, "##progress", {corner.x + 0.5f * size.x, corner.y + view.px(16)}, {0.5f, 0.0f}, width)) {
    wrapped(whereabouts(p));
    ImGui::ProgressBar(static_cast<float>(p.fraction), {-view.px(90), 0.0f});
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {-1.0f, 0.0f})) orders.emplace_back(Action::cancel);
    note(view, "cancel");
    tip(view, view.session.stale()                ? "Keep the mesh and the parameters from before."
              : p.activity == Activity::searching ? "Stop searching, and stay at this decision."
                                                  : "Stop here.");
  }
  endFloating();
}

/// Where the mouse is in the other picture.
void otherCursor(const View& view, ImVec2 corner) {
  if (!view.ui.cursor || ImGui::IsItemHovered()) return;
  const Pixel at = toPixel(view.ui.camera, *view.ui.cursor);
  const ImVec2 p{corner.x + static_cast<float>(at.x), corner.y + static_cast<float>(at.y)};
  const float reach = view.px(8);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& [color, width] : {std::pair{view.theme().background, 4.0}, std::pair{view.theme().text, 1.5}}) {
    list.AddLine({p.x - reach, p.y}, {p.x + reach, p.y}, toImU32(color), view.px(width));
    list.AddLine({p.x, p.y - reach}, {p.x, p.y + reach}, toImU32(color), view.px(width));
  }
}

/// The picture of the run in `shown`. The mouse is about the live run, whichever picture it is on: ids are its own.
void pane(const View& shown, const View& live, Orders& orders, const Region& where, const char* name) {
  const bool isLive = &shown == &live;
  const ImVec2 corner = where.at;
  const ImVec2 end{corner.x + where.size.x, corner.y + where.size.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(corner);
  ImGui::PushID(name);
  if (shown.canvasTexture != 0) {
    // Texture rows run upwards.
    const auto texture = static_cast<std::uintptr_t>(shown.canvasTexture);
    const auto id = reinterpret_cast<ImTextureID>(texture);  // NOLINT(performance-no-int-to-ptr): as ImGui wants it
    list.AddImage(id, corner, end, {0, 1}, {1, 0});
  }
  ImGui::InvisibleButton("canvas", where.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  note(live, name);
  list.PushClipRect(corner, end, true);
  mouse(live, orders, corner, isLive);
  if (isLive) drawDensityHandles(live, corner);
  std::vector<Rect> avoid = isLive ? densityHandleRects(live) : std::vector<Rect>();
  if (isLive) avoid.push_back(legendCovers(shown, where.size));
  labels(shown, corner, avoid, isLive);
  if (live.pinned != nullptr) otherCursor(live, corner);
  if (shown.legendOnCanvas) overlayLegend(shown, corner, where.size);
  if (live.pinned != nullptr) drawPaneHeading(live, isLive ? Pane::live : Pane::pinned, corner, where.size);
  list.PopClipRect();
  contextMenu(live, orders, corner);
  ImGui::PopID();
}

}  // namespace

void drawCanvas(const View& view, Orders& orders) {
  const Region whole{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail()};
  if (whole.size.x < 1.0f || whole.size.y < 1.0f) return;
  const Panes panes = panesOf(whole, view.ui);
  if (view.pinned != nullptr) {
    const PinnedRun& run = *view.pinned;
    const View a{{run.session(), view.ui}, run.scene(), view.fonts, view.debug, run.texture(), false, view.widgets};
    pane(a, view, orders, panes.pinned, "canvas.A");
  }
  pane(view, view, orders, panes.live, "canvas");
  if (view.ui.legendFolded) drawFoldedLegend(view, orders, panes.live.at, panes.live.size);
  progress(view, orders, panes.live.at, panes.live.size);
  drawKeptOffer(view, orders, whole.at, whole.size);
}

}  // namespace triscope
