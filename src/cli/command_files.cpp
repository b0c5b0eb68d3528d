#include "cli/command_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/outputs.h"
#include "core/base/temporary_name.h"

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

/// The regular file that a standard stream leads into, when it is one of these; none where the stream was named.
const NamedFile* ledInto(int stream, const CommandFiles& files) {
  const std::string there = fmt::format("/proc/self/fd/{}", stream);
  for (const NamedFile& input : files.inputs)
    if (!input.path.empty() && sameFile(there, input.path)) return &input;
  for (const NamedFile& output : files.outputs)
    if (!output.path.empty() && !descriptorNamed(output.path) && sameFile(there, output.path)) return &output;
  return nullptr;
}

Status checkStreams(const CommandFiles& files) {
  const NamedFile* const answers = ledInto(STDOUT_FILENO, files);
  const NamedFile* const messages = ledInto(STDERR_FILENO, files);
  // The message about it would be the first to go there.
  if (messages != nullptr && answers != nullptr) ::close(STDERR_FILENO);
  if (messages != nullptr && answers == nullptr) ::dup2(STDOUT_FILENO, STDERR_FILENO);
  const NamedFile* const file = answers != nullptr ? answers : messages;
  if (file == nullptr) return success();
  return Error{.kind = ErrorKind::usage,
               .message = fmt::format("the standard {} is led into {}", answers != nullptr ? "output" : "error output",
                                      file->what),
               .hint = "lead it into another file",
               .file = file->path};
}

NamedFile domain(const std::string& path) { return {"the domain", path}; }

}  // namespace

Status checkFiles(const CommandFiles& files) {
  for (const NamedFile& output : files.outputs)
    if (output.path == "-")
      return Error{.kind = ErrorKind::usage,
                   .message = output.what + " takes the name of a file, and '-' is none",
                   .hint = "name a file; ./- is one called so"};
  if (Status streams = checkStreams(files); !streams.ok()) return streams;
  for (const NamedFile& input : files.inputs) keepFromClearing(input.path);
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

CommandFiles filesOf(const CheckCommand& options) {
  CommandFiles files{{domain(options.domain)}, {}};
  for (const std::string& name : filesOf(options.mesh)) files.inputs.push_back({"the mesh", name});
  return files;
}

CommandFiles filesOf(const FigureCommand& options) { return {{domain(options.domain)}, outputsOf(options.outputs)}; }

CommandFiles filesOf(const SettingsCommand&) { return {}; }

CommandFiles filesOf(const DebugCommand& options) {
  return {{domain(options.domain)}, {{"--save-session", options.saveSession}}};
}

CommandFiles filesOf(const SweepCommand& options) { return {{domain(options.domain)}, {{"-o", options.output}}}; }

CommandFiles filesOf(const ReplayCommand& options) { return {{{"the session", options.file}}, {}}; }

}  // namespace triscope
