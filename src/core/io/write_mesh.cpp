#include "core/io/write_mesh.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "core/io/atomic_file.h"
#include "core/io/mesh_formats.h"

namespace triscope {
namespace {

using Writer = void (*)(const MeshFile&, TextSink&);

/// A file that a format consists of.
struct Part {
  std::string extension;
  Writer write;
};

/// The files of each format, named by the extension of its first.
const std::vector<std::vector<Part>>& formats() {
  static const std::vector<std::vector<Part>> table = {
      {{".msh", writeMsh4}}, {{".vtu", writeVtu}}, {{".node", writeNode}, {".ele", writeEle}, {".poly", writePoly}},
      {{".su2", writeSu2}},  {{".off", writeOff}}, {{".obj", writeObj}},
  };
  return table;
}

const std::vector<Part>* formatOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const auto& parts : formats()) {
    if (parts.front().extension == extension) return &parts;
  }
  return nullptr;
}

}  // namespace

std::string meshFormatsWritten() {
  std::string list;
  for (const auto& parts : formats()) list += (list.empty() ? "" : ", ") + parts.front().extension;
  return list;
}

bool isMeshPath(const std::string& path) { return formatOf(path) != nullptr; }

bool holdsFields(const std::string& path) {
  const std::vector<Part>* const parts = formatOf(path);
  return parts != nullptr && parts->front().write == writeVtu;
}

Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options) {
  const std::vector<Part>* parts = formatOf(path);
  if (parts == nullptr) {
    return Error{.code = ExitCode::usage,
                 .message = fmt::format("no mesh format has the extension '{}'",
                                        std::filesystem::path(path).extension().string()),
                 .hint = "known are " + meshFormatsWritten(),
                 .file = path,
                 .loop = {}};
  }
  std::vector<AtomicFile> written;
  for (const Part& part : *parts) {
    auto target = AtomicFile::create(std::filesystem::path(path).replace_extension(part.extension).string());
    if (!target) return target.error();
    TextSink sink(*target, options.cancelled);
    const Writer write = options.msh2 && part.write == writeMsh4 ? writeMsh2 : part.write;
    write(file, sink);
    if (Status finished = sink.finish(); !finished) {
      Error error = finished.error();
      error.file = path;
      return error;
    }
    if (Status closed = target->close(); !closed) return closed;
    written.push_back(std::move(*target));
  }
  for (AtomicFile& target : written) {
    if (Status committed = target.commit(); !committed) return committed;
  }
  return success();
}

}  // namespace triscope
