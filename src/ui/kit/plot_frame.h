// The frame of a plot, and what is drawn in and around it.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/model/view.h"

namespace triscope {

struct PlotFrame {
  ImVec2 lo;
  ImVec2 hi;
  [[nodiscard]] float width() const { return hi.x - lo.x; }
  [[nodiscard]] float height() const { return hi.y - lo.y; }
};

/// The rest of the column, less room for the scale at the left and below.
PlotFrame plotFrameHere(const View& view);
/// Small words; `align` is the part of their width that lies left of `at`, 0 … 1.
void plotText(const View& view, ImVec2 at, float align, const std::string& words, Color color);
/// The frame and what is under the curve.
void plotGround(const View& view, const PlotFrame& frame);
/// Lines across the frame, from its foot upwards, each with its value at the left where the one below leaves room.
struct PlotTick {
  float at;  // on the screen
  std::string value;
};
void plotTicks(const View& view, const PlotFrame& frame, const std::vector<PlotTick>& ticks);
void dashedLine(const View& view, ImVec2 a, ImVec2 b, Color color);

}  // namespace triscope
