#include "cli/command_files.h"

#include "cli/outputs.h"

namespace triscope {
namespace {

/// Every file that the names given with -o stand for.
std::vector<NamedFile> outputsOf(const std::vector<std::string>& paths) {
  std::vector<NamedFile> files;
  for (const std::string& path : paths)
    for (const std::string& name : filesOf(path))
      files.push_back({name == path ? std::string("-o") : "-o " + path, name});
  return files;
}

NamedFile domain(const std::string& path) { return {"the domain", path}; }

}  // namespace

Status checkFiles(const CommandFiles& files) {
  for (const NamedFile& output : files.outputs)
    if (output.path == "-")
      return Error{.code = ExitCode::usage,
                   .message = output.what + " takes the name of a file, and '-' is none",
                   .hint = "name a file; ./- is one called so"};
  return checkOverwrites(files.inputs, files.outputs);
}

CommandFiles filesOf(const WindowOptions& options) {
  const bool kept = options.preferences != "none";
  return {{{"the file to open", options.file}},
          {{"--screenshot", options.screenshot},
           {"--state-file", options.stateFile},
           {"--preferences", kept ? options.preferences : std::string()}}};
}

CommandFiles filesOf(const MeshCommand& options) {
  CommandFiles files{{domain(options.domain)}, outputsOf(options.outputs)};
  files.outputs.push_back({"--report", options.report});
  files.outputs.push_back({"--events", options.events});
  return files;
}

CommandFiles filesOf(const CheckCommand& options) { return {{{"the mesh", options.mesh}, domain(options.domain)}, {}}; }

CommandFiles filesOf(const FigureCommand& options) { return {{domain(options.domain)}, outputsOf(options.outputs)}; }

CommandFiles filesOf(const SettingsCommand&) { return {}; }

CommandFiles filesOf(const DebugCommand& options) {
  return {{domain(options.domain)}, {{"--save-session", options.saveSession}}};
}

CommandFiles filesOf(const SweepCommand& options) { return {{domain(options.domain)}, {{"-o", options.output}}}; }

CommandFiles filesOf(const ReplayCommand& options) { return {{{"the session", options.file}}, {}}; }

}  // namespace triscope
