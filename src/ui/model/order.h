// What panels hand back: nothing that they draw changes anything by itself.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/session/session.h"
#include "core/words/links.h"
#include "render/camera.h"
#include "render/pick.h"
#include "render/view_options.h"
#include "ui/model/action.h"
#include "ui/model/panel.h"
#include "ui/model/sweep_state.h"

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
/// What the domain asks of the density. While a control is held each takes the place of the last, until EndTuning.
struct EditDensity {
  std::vector<DensityRequest> density;
  bool held = false;
};
struct NameRequest {
  std::string text;   // being typed …
  bool done = false;  // … or typed: the name of the one that is selected
};
struct PlaceRequest {
  Point at;  // of a new density constraint
};
struct MoveRequest {
  Point to;  // of the one that is selected and held
};
struct SelectRequest {
  std::optional<std::size_t> index;
  bool held = false;  // by the mouse, which may move it
};
struct SaveTo {
  std::string path;  // of a session file
};
struct WriteNotes {
  std::string text;
};
struct NameBookmark {
  std::size_t index = 0;
  std::string name;
};
struct DropBookmark {
  std::size_t index = 0;
};
/// What is to become of the newest work that an earlier run left behind.
struct Kept {
  enum class What : std::uint8_t { restore, discard, later } what = What::later;
};
struct SetSpeed {
  double decisionsPerSecond = 60.0;
};
struct ExportTo {
  std::string path;  // what is written goes by its extension
};
struct LayersFollow {
  bool on = true;  // quadtree and constraints are shown while they are made
};
struct ShowTab {
  Panel panel;
};
struct CloseDialog {};  // before the order that may open the next one: an error, say
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
struct CancelSweep {};
struct ChooseCell {
  std::optional<std::size_t> cell;  // of the sweep shown, which then takes the keys; nothing: it lets them go
};
}  // namespace order

using Order =
    std::variant<Action, Command, ViewOptions, Camera, Appearance, order::SelectElement, order::Frame, order::Tune,
                 order::EndTuning, order::SetSpeed, order::ExportTo, order::ShowTab, order::LayersFollow,
                 order::CloseDialog, order::FollowLink, order::ShowRange, order::TypeCondition, order::AddBreakpoint,
                 order::ShowPlot, order::EditDensity, order::NameRequest, order::PlaceRequest, order::MoveRequest,
                 order::SelectRequest, order::SaveTo, order::WriteNotes, order::NameBookmark, order::DropBookmark,
                 order::Kept, SweepChoice, order::CancelSweep, order::ChooseCell>;
using Orders = std::vector<Order>;

}  // namespace triscope
