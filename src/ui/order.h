// What panels hand back: nothing that they draw changes anything by itself.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/debug/links.h"
#include "core/session.h"
#include "render/camera.h"
#include "render/pick.h"
#include "render/view_options.h"
#include "ui/action.h"

namespace triscope {

/// How the window looks, apart from what it shows. Kept between runs.
struct Appearance {
  ThemeKind theme = ThemeKind::light;
  double scale = 0.0;        // of text and controls: 0.75 … 3; 0: the monitor's
  double leftWidth = 300.0;  // pixels at 100 %
  double rightWidth = 300.0;
  double bottomHeight = 220.0;
  bool legend = true;
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

namespace order {
struct SelectElement {
  Pick pick;  // kind none: nothing
};
struct Frame {
  Box box;  // to be shown whole
};
struct Tune {
  Settings settings;  // while a control is held: each takes the place of the last, and all are one step of undo
};
struct EndTuning {};  // it was let go
struct SetSpeed {
  double decisionsPerSecond = 60.0;
};
struct ExportTo {
  std::string path;  // what is written goes by its extension
};
struct ShowTab {
  std::string name;
};
struct CloseDialog {};
struct FollowLink {
  Ref ref;  // selects an element, or goes to an event
};
struct ShowRange {
  double from = 0.0;  // decisions that the timeline and the plots show; all when to <= from
  double to = 0.0;
};
struct TypeCondition {
  std::string text;
  Breakpoint::Action action = Breakpoint::Action::stop;
};
struct AddBreakpoint {};  // what was typed
struct ShowPlot {
  int plot = 0;       // PlotOf
  int histogram = 0;  // Measure
};
}  // namespace order

using Order =
    std::variant<Action, Command, ViewOptions, Camera, Appearance, order::SelectElement, order::Frame, order::Tune,
                 order::EndTuning, order::SetSpeed, order::ExportTo, order::ShowTab, order::CloseDialog,
                 order::FollowLink, order::ShowRange, order::TypeCondition, order::AddBreakpoint, order::ShowPlot>;
using Orders = std::vector<Order>;

}  // namespace triscope
