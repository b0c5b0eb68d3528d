// What each subcommand was asked to do, as plain data.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/debug_request.h"
#include "cli/notices.h"
#include "core/method/method.h"
#include "core/words/settings.h"
#include "core/words/stage.h"
#include "render/view_options.h"
#include "ui/app/window.h"

namespace triscope {

/// triscope mesh DOMAIN -o OUT
struct MeshCommand {
  std::string domain;
  Settings settings;
  std::vector<std::string> outputs;           // by extension
  Stage until = paperMethod().stages.back();  // the last stage to run
  std::string report;                         // empty: none
  std::string events;                         // empty: none
  bool msh2 = false;
  Notices notices = Notices::shown;
};

/// triscope check MESH
struct CheckCommand {
  std::string mesh;
  std::string domain;  // empty: the mesh is judged by itself
};

/// triscope figure DOMAIN -o OUT
struct FigureCommand {
  std::string domain;
  Settings settings;
  std::vector<std::string> outputs;
  Stage stage = paperMethod().stages.back();  // drawn as it is when this stage is over
  std::optional<CellColoring> cells;          // draw the quadtree, coloured so; by default as suits the stage
  std::optional<Box> box;                     // draw this part of the plane only
  int width = 1200;                           // pixels
  int height = 900;
  bool dark = false;
  Notices notices = Notices::shown;
};

/// triscope settings
struct SettingsCommand {};

/// triscope debug DOMAIN
struct DebugCommand {
  std::string domain;
  Settings settings;
  std::vector<std::string> breaks;  // conditions, as typed
  std::optional<Goto> place;
  std::vector<Print> prints;
  bool back = false;  // to the last hit before the place
  bool firstViolation = false;
  bool json = false;
  Notices notices = Notices::shown;
  std::string saveSession;  // empty: none
};

/// triscope sweep DOMAIN --omega RANGE --theta RANGE
struct SweepCommand {
  std::string domain;
  Settings settings;
  std::string omega;  // "0.05:0.25:5"
  std::string theta;
  std::string output;    // empty: the standard output
  unsigned threads = 0;  // 0: one for each core
  Notices notices = Notices::shown;
};

/// triscope replay FILE
struct ReplayCommand {
  std::string file;
  Notices notices = Notices::shown;
};

/// What was asked for; triscope [FILE] opens the window.
using Options = std::variant<WindowOptions, MeshCommand, CheckCommand, FigureCommand, SettingsCommand, DebugCommand,
                             SweepCommand, ReplayCommand>;

}  // namespace triscope
