#include "cli/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "cli/exit_codes.h"
#include "cli/messages.h"
#include "cli/outputs.h"
#include "cli/stage_names.h"
#include "core/base/version.h"
#include "core/io/read_mesh.h"
#include "core/words/preset.h"

namespace triscope {
namespace {

/// Values of --set and of a stage's name, kept as text until the whole command line has been read.
struct Texts {
  std::string preset;
  std::vector<std::string> set;
  std::string stage;
  std::string cells;
  std::string box;
  std::string place;
  std::vector<std::string> prints;
};

/// What is set by hand comes after the preset, wherever it stands on the command line.
Status applySettings(Settings& settings, const Texts& texts) {
  if (!texts.preset.empty()) {
    Status status = applyPreset(settings, texts.preset);
    if (!status.ok()) return status;
  }
  for (const std::string_view assignment : texts.set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
      return Error{.kind = ErrorKind::usage,
                   .message = fmt::format("--set wants key=value, not '{}'", assignment),
                   .hint = "'triscope settings' lists the keys"};
    Status status = setSetting(settings, assignment.substr(0, equals), assignment.substr(equals + 1));
    if (!status.ok()) return status;
  }
  return success();
}

Status applyStage(Stage& stage, const std::string& name) {
  if (name.empty()) return success();
  const Result<Stage> named = stageNamed(name);
  if (!named.ok()) return named.error();
  stage = *named;
  return success();
}

/// "x0,y0,x1,y1": two opposite corners.
Status applyBox(std::optional<Box>& box, const std::string& text) {
  if (text.empty()) return success();
  std::array<double, 4> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (std::size_t i = 0; i < numbers.size() && good; ++i) {
    const auto [next, code] = std::from_chars(at, end, numbers[i]);
    const bool last = i + 1 == numbers.size();
    good = code == std::errc() && std::isfinite(numbers[i]) && (last ? next == end : next != end && *next == ',');
    at = next + 1;
  }
  Box found;
  found.include({numbers[0], numbers[1]});
  found.include({numbers[2], numbers[3]});
  if (!good || found.width() <= 0.0 || found.height() <= 0.0)
    return Error{.kind = ErrorKind::usage,
                 .message = fmt::format("--box wants two opposite corners, not '{}'", text),
                 .hint = "write x0,y0,x1,y1, such as --box=-1,-1,2,1"};
  box = found;
  return success();
}

Status applyRequests(DebugCommand& options, const Texts& texts) {
  if (!texts.place.empty()) {
    const Result<Goto> place = gotoFrom(texts.place);
    if (!place.ok()) return place.error();
    options.place = *place;
  }
  for (const std::string& text : texts.prints) {
    const Result<Print> print = printFrom(text);
    if (!print.ok()) return print.error();
    options.prints.push_back(*print);
  }
  if (options.prints.empty()) options.prints.push_back(*printFrom("state"));
  return success();
}

void addQuiet(CLI::App& command, Notices& notices, const char* what) {
  command.add_flag_callback("-q,--quiet", [&notices] { notices = Notices::none; }, what);
}

void addSet(CLI::App& command, Texts& texts) {
  command
      .add_option("--preset", texts.preset,
                  fmt::format("Settings that go together: {}; --set then changes some", presetKeys()))
      ->type_name("PRESET");
  command.add_option("--set", texts.set, "Change a setting; 'triscope settings' lists them")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option_function<std::string>(
          "--max-triangles", [&texts](const std::string& most) { texts.set.push_back("max_triangles=" + most); },
          "Stop before a mesh of more is made; the same as --set max_triangles=N")
      ->type_name("N");
}

void addWindow(CLI::App& app, WindowOptions& options) {
  app.add_option("FILE", options.file, "Domain file to open in the window")->type_name("");
  app.add_option("--screenshot", options.screenshot, "Write a picture of the window once the mesh is complete, and end")
      ->type_name("FILE.png");
  app.add_option("--state-file", options.stateFile, "Keep a JSON file up to date with what the window shows")
      ->type_name("FILE");
  app.add_option("--preferences", options.preferences,
                 "File of theme, scale and layout; 'none' neither reads nor writes one")
      ->type_name("FILE");
}

CLI::App& addMesh(CLI::App& app, MeshCommand& options, Texts& texts) {
  CLI::App& mesh =
      *app.add_subcommand("mesh", "Mesh a domain without a window; notes say which bounds are not met, and where");
  mesh.add_option("DOMAIN", options.domain, "Domain file")->required()->type_name("");
  mesh.add_option("-o,--output", options.outputs,
                  fmt::format("File to write: {} or {}; .node brings .ele and .poly; may be given again",
                              meshFormatsWritten(), figureFormats()))
      ->type_name("FILE")
      ->allow_extra_args(false);
  mesh.add_option("--until", texts.stage, "Last stage to run: " + stageNames())->type_name("STAGE");
  addSet(mesh, texts);
  mesh.add_option("--report", options.report, "Write the figures of the run as JSON")->type_name("FILE");
  mesh.add_option("--events", options.events, "Write every decision, one JSON object a line")->type_name("FILE");
  mesh.add_flag("--msh2", options.msh2, "Write .msh files in version 2.2 of the format, not 4.1");
  addQuiet(mesh, options.notices, "Say nothing unless something is wrong");
  return mesh;
}

CLI::App& addCheck(CLI::App& app, CheckCommand& options) {
  CLI::App& check = *app.add_subcommand("check", "Judge a mesh file: the bounds of the paper, and whether it is valid");
  check.add_option("MESH", options.mesh, "Mesh file: " + meshFormatsRead())->required()->type_name("");
  check.add_option("--domain", options.domain, "Domain file that the mesh must fill")->type_name("FILE");
  return check;
}

CLI::App& addFigure(CLI::App& app, FigureCommand& options, Texts& texts) {
  CLI::App& figure = *app.add_subcommand("figure", "Draw any stage of a run without a display");
  figure.add_option("DOMAIN", options.domain, "Domain file")->required()->type_name("");
  figure.add_option("-o,--output", options.outputs, "File to write: .svg or .png; may be given again")
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false);
  figure.add_option("--stage", texts.stage, "Draw the state at the end of this stage: " + stageNames())
      ->type_name("STAGE");
  addSet(figure, texts);
  figure
      .add_option("--cells", texts.cells,
                  "Draw the quadtree, at any stage, coloured by density rank or by type of cell: rank, type")
      ->check(CLI::IsMember({"rank", "type"}))
      ->type_name("COLOURING");
  figure.add_option("--box", texts.box, "Draw the part of the plane between two opposite corners only")
      ->type_name("X0,Y0,X1,Y1");
  figure.add_option("--width", options.width, "Width in pixels")->check(CLI::Range(64, 16384))->capture_default_str();
  figure.add_option("--height", options.height, "Height in pixels")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  figure.add_flag("--dark", options.dark, "Light lines on a dark ground");
  addQuiet(figure, options.notices, "Say nothing unless something is wrong");
  return figure;
}

CLI::App& addDebug(CLI::App& app, DebugCommand& options, Texts& texts) {
  CLI::App& debug = *app.add_subcommand("debug", "Go anywhere in a run, stop on a condition, and ask why");
  debug.add_option("DOMAIN", options.domain, "Domain file")->required()->type_name("");
  addSet(debug, texts);
  debug
      .add_option("--goto", texts.place,
                  "Where to begin: start, end, tick=N, event=N or stage=S; the end, or the start with --break")
      ->type_name("PLACE");
  CLI::Option& breaks = *debug
                             .add_option("--break", options.breaks,
                                         "Go on to the first decision that meets this condition; may be given again")
                             ->type_name("CONDITION")
                             ->allow_extra_args(false);
  debug.add_flag("--back", options.back, "With --break: go back to the last decision that meets it")->needs(&breaks);
  debug
      .add_flag("--first-violation", options.firstViolation,
                "Go on to where a bound or a rule of validity first breaks")
      ->excludes(&breaks);
  debug
      .add_option("--print", texts.prints,
                  "What to print there: state, quality, worst, events:FROM-TO, why:ELEMENT, whynot:triangle=ID, "
                  "history:ELEMENT or ELEMENT (triangle=ID, vertex=ID, cell=ID, event=N); may be given again")
      ->type_name("WHAT")
      ->allow_extra_args(false);
  debug.add_flag("--json", options.json, "Print one JSON object instead of text");
  debug.add_option("--save-session", options.saveSession, "Write a session file of that place")->type_name("FILE");
  addQuiet(debug, options.notices, "Show no progress");
  return debug;
}

CLI::App& addSweep(CLI::App& app, SweepCommand& options, Texts& texts) {
  CLI::App& sweep = *app.add_subcommand(
      "sweep", "Run step 6 for every pair of omega and theta, not optimised after it, and print a table");
  sweep.add_option("DOMAIN", options.domain, "Domain file")->required()->type_name("");
  addSet(sweep, texts);
  sweep.add_option("--omega", options.omega, "Values of omega, such as 0.05:0.25:5")
      ->required()
      ->type_name("FROM:TO:COUNT");
  sweep.add_option("--theta", options.theta, "Values of theta in degrees, such as 5:10:6")
      ->required()
      ->type_name("FROM:TO:COUNT");
  sweep.add_option("-o,--output", options.output, "CSV file to write instead of the standard output")
      ->type_name("FILE");
  sweep.add_option("-j", options.threads, "Pairs to run at a time; as many as there are cores")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  addQuiet(sweep, options.notices, "Say nothing unless something is wrong");
  return sweep;
}

CLI::App& addReplay(CLI::App& app, ReplayCommand& options) {
  CLI::App& replay = *app.add_subcommand("replay", "Run a session again and check that every stage is as recorded");
  replay.add_option("FILE", options.file, "Session file")->required()->type_name("");
  addQuiet(replay, options.notices, "Show no progress and no notes");
  return replay;
}

ExitCode complain(const Error& error) {
  say("triscope: {}\n", describe(error));
  return ExitCode::usage;
}

}  // namespace

std::variant<Options, ExitCode> parseArguments(int argc, const char* const* argv) {
  CLI::App app{"Triscope shows and steps through the generation of triangle meshes.", "triscope"};
  app.set_version_flag("--version", "triscope " + thisVersion().program, "Print the version and exit");
  app.require_subcommand(0, 1);
  app.footer(exitCodesHelp());

  WindowOptions window;
  MeshCommand mesh;
  CheckCommand check;
  FigureCommand figure;
  DebugCommand debug;
  SweepCommand sweep;
  ReplayCommand replay;
  Texts texts;
  addWindow(app, window);
  const CLI::App& meshCommand = addMesh(app, mesh, texts);
  const CLI::App& checkCommand = addCheck(app, check);
  const CLI::App& figureCommand = addFigure(app, figure, texts);
  const CLI::App& debugCommand = addDebug(app, debug, texts);
  const CLI::App& sweepCommand = addSweep(app, sweep, texts);
  const CLI::App& replayCommand = addReplay(app, replay);
  const CLI::App& settingsCommand = *app.add_subcommand("settings", "List every setting with its range and default");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    if (stop.get_exit_code() == 0) {  // help or version: CLI11 prints it
      app.exit(stop);
      return ExitCode::ok;
    }
    say("triscope: {}\nRun 'triscope --help' for what can be given.\n", stop.what());
    return ExitCode::usage;
  }

  if (meshCommand.parsed()) {
    if (const Status status = applySettings(mesh.settings, texts); !status.ok()) return complain(status.error());
    if (const Status status = applyStage(mesh.until, texts.stage); !status.ok()) return complain(status.error());
    if (mesh.outputs.empty() && mesh.report.empty() && mesh.events.empty())
      return complain(Error{.kind = ErrorKind::usage,
                            .message = "there is nothing to write",
                            .hint = "name a file with -o, --report or --events"});
    return Options{mesh};
  }
  if (checkCommand.parsed()) return Options{check};
  if (figureCommand.parsed()) {
    if (const Status status = applySettings(figure.settings, texts); !status.ok()) return complain(status.error());
    if (const Status status = applyStage(figure.stage, texts.stage); !status.ok()) return complain(status.error());
    if (const Status status = applyBox(figure.box, texts.box); !status.ok()) return complain(status.error());
    if (!texts.cells.empty()) figure.cells = texts.cells == "type" ? CellColoring::type : CellColoring::rank;
    return Options{figure};
  }
  if (debugCommand.parsed()) {
    if (const Status status = applySettings(debug.settings, texts); !status.ok()) return complain(status.error());
    if (const Status status = applyRequests(debug, texts); !status.ok()) return complain(status.error());
    return Options{debug};
  }
  if (sweepCommand.parsed()) {
    if (const Status status = applySettings(sweep.settings, texts); !status.ok()) return complain(status.error());
    return Options{sweep};
  }
  if (replayCommand.parsed()) return Options{replay};
  if (settingsCommand.parsed()) return Options{SettingsCommand{}};
  return Options{window};
}

}  // namespace triscope
