#include "ui/kit/density_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/number.h"
#include "core/density/quadtree.h"
#include "core/domain/outline.h"
#include "ui/kit/imgui_pixels.h"
#include "ui/kit/style.h"

namespace triscope {
namespace {

constexpr double kReach = 9.0;   // pixels at 100 %
constexpr double kHandle = 6.0;  // radius
constexpr double kLabelPadding = 3.0;
constexpr double kSlack = 3.0;  // a press that moves less moves nothing

bool shown(const View& view) {
  return view.now() != nullptr && view.session.domain() != nullptr && !view.ui.document.opening &&
         (view.ui.density.placing || view.ui.density.request || view.ui.options.constraints);
}

ImVec2 onScreen(const View& view, ImVec2 corner, Point world) {
  const Pixel pixel = toPixel(view.ui.camera, world);
  return {corner.x + static_cast<float>(pixel.x), corner.y + static_cast<float>(pixel.y)};
}

Point mouseInWorld(const View& view, ImVec2 corner) { return toWorld(view.ui.camera, mouseOn(corner)); }

std::optional<std::size_t> handleUnderMouse(const View& view, ImVec2 corner) {
  if (!shown(view)) return std::nullopt;
  const Point mouse = mouseInWorld(view, corner);
  std::optional<std::size_t> best;
  double nearest = kReach * view.ui.scale() / view.ui.camera.scale;
  const std::vector<DensityRequest>& density = view.session.domain()->density;
  for (std::size_t k = 0; k < density.size(); ++k) {
    const double away = distance(handleOf(*view.session.domain(), density[k]), mouse);
    if (away > nearest) continue;
    nearest = away;
    best = k;
  }
  return best;
}

/// Every constraint on a loop names one of the domain.
std::uint32_t loopNamed(const Domain& domain, const std::string& name) {
  const auto found =
      std::find_if(domain.loops.begin(), domain.loops.end(), [&name](const Loop& loop) { return loop.name == name; });
  return static_cast<std::uint32_t>(found - domain.loops.begin());
}

void traceLoop(const View& view, ImVec2 corner, const std::string& name, ImU32 ink) {
  const Domain& domain = *view.session.domain();
  for (const Chord& chord : outlineOf(domain, loopNamed(domain, name)))
    ImGui::GetWindowDrawList()->AddLine(onScreen(view, corner, chord.a), onScreen(view, corner, chord.b), ink,
                                        view.px(3));
}

std::string wishOf(const DensityRequest& request) {
  return request.rank > 0 ? fmt::format("rank {}", request.rank) : "h " + compact(request.length, 3);
}

/// What stands beside a handle, and where on the screen.
struct HandleLabel {
  std::string text;
  ImVec2 lo;
  ImVec2 size;
};
HandleLabel labelOf(const View& view, ImVec2 corner, const DensityRequest& request) {
  const ImFont& font = *view.fonts.small;
  HandleLabel label;
  label.text = request.name.empty() ? wishOf(request) : request.name + ", " + wishOf(request);
  label.size = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, label.text.c_str());
  const ImVec2 at = onScreen(view, corner, handleOf(*view.session.domain(), request));
  const float away = view.px(kHandle) + view.px(5);
  label.lo = {at.x + away, at.y - 0.5f * label.size.y};
  const Camera& camera = view.ui.camera;
  const ImVec2 end{corner.x + static_cast<float>(camera.width) - view.px(kLabelPadding),
                   corner.y + static_cast<float>(camera.height)};
  const bool seen = at.x >= corner.x && at.y >= corner.y && at.x <= end.x && at.y <= end.y;
  if (!seen) return label;
  if (label.lo.x + label.size.x > end.x) label.lo.x = at.x - away - label.size.x;
  label.lo.x = std::max(label.lo.x, corner.x + view.px(kLabelPadding));
  label.lo.y = std::clamp(label.lo.y, corner.y, std::max(corner.y, end.y - label.size.y));
  return label;
}

void handle(const View& view, ImVec2 corner, const DensityRequest& request, bool selected) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = onScreen(view, corner, handleOf(*view.session.domain(), request));
  const ImU32 ink = toImU32(accentOf(view.theme()));
  const ImU32 halo = toImU32(view.theme().background);
  const float radius = view.px(kHandle);
  if (request.where == DensityRequest::Where::box) {
    const ImVec2 a = onScreen(view, corner, request.at);
    const ImVec2 b = onScreen(view, corner, request.to);
    list.AddRect({a.x, b.y}, {b.x, a.y}, ink, 0.0f, ImDrawFlags_None, view.px(selected ? 2.0 : 1.2));
  }
  if (request.where == DensityRequest::Where::loop && selected) traceLoop(view, corner, request.loop, ink);
  list.AddCircleFilled(at, radius + view.px(2.5), halo);
  list.AddCircle(at, radius, ink, 0, view.px(2));
  list.AddCircleFilled(at, selected ? radius : view.px(2), ink);
  const ImFont& font = *view.fonts.small;
  const auto [text, lo, size] = labelOf(view, corner, request);
  const ImVec2 hi{lo.x + size.x, lo.y + size.y};
  const float padding = view.px(kLabelPadding);
  list.AddRectFilled({lo.x - padding, lo.y - view.px(1)}, {hi.x + padding, hi.y + view.px(1)},
                     (halo & 0x00FFFFFFu) | 0xD8000000u, view.px(3));
  list.AddText(&font, font.FontSize, lo, toImU32(view.theme().text), text.c_str());
  if (view.widgets != nullptr) view.widgets->push_back({"wish." + text, lo, hi, true});
}

}  // namespace

Point handleOf(const Domain& domain, const DensityRequest& request) {
  switch (request.where) {
    case DensityRequest::Where::point:
      break;
    case DensityRequest::Where::box:
      return midpoint(request.at, request.to);
    case DensityRequest::Where::loop:
      return pointAt(domain.curves[domain.loops[loopNamed(domain, request.loop)].firstCurve], 0.5);
  }
  return request.at;
}

bool densityMouse(const View& view, Orders& orders, ImVec2 corner) {
  const DensityUi& ui = view.ui.density;
  if (ui.held) {
    const float slack = view.px(kSlack);
    const bool moved = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > slack * slack;
    // The last move may come with the release.
    if (moved && view.request() != nullptr && (ImGui::IsItemActive() || ImGui::IsItemDeactivated()))
      orders.emplace_back(order::MoveRequest{mouseInWorld(view, corner)});
    if (!ImGui::IsItemActive()) orders.emplace_back(order::EndTuning{});
    return true;
  }
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift) {
    const std::optional<std::size_t> under = handleUnderMouse(view, corner);
    if (under) orders.emplace_back(order::SelectRequest{under, true});
    return under.has_value();
  }
  const bool places = (ui.placing && !io.KeyShift && !io.KeyCtrl) || io.KeyAlt;
  const float slack = view.px(kSlack);
  const bool clicked = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                       io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <= slack * slack;
  if (!places || !clicked || view.now() == nullptr) return false;
  orders.emplace_back(order::PlaceRequest{mouseInWorld(view, corner)});
  return true;
}

std::vector<Rect> densityHandleRects(const View& view) {
  std::vector<Rect> rects;
  if (!shown(view)) return rects;
  for (const DensityRequest& request : view.session.domain()->density) {
    const HandleLabel label = labelOf(view, {0.0f, 0.0f}, request);
    const double at = toPixel(view.ui.camera, handleOf(*view.session.domain(), request)).x;
    const double radius = kHandle * view.ui.scale();
    const double left = std::min(at - radius, static_cast<double>(label.lo.x));
    const double right = std::max(at + radius, static_cast<double>(label.lo.x + label.size.x));
    rects.push_back({left, static_cast<double>(label.lo.y), right - left, static_cast<double>(label.size.y)});
  }
  return rects;
}

void drawDensityHandles(const View& view, ImVec2 corner) {
  if (!shown(view)) return;
  const std::vector<DensityRequest>& density = view.session.domain()->density;
  for (std::size_t k = 0; k < density.size(); ++k) handle(view, corner, density[k], view.ui.density.request == k);
}

}  // namespace triscope
