#include "core/io/write_mesh.h"

#include <filesystem>
#include <utility>
#include <vector>

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

std::vector<std::string> meshFilesOf(const std::string& path) {
  std::vector<std::string> files;
  if (const std::vector<Part>* const parts = formatOf(path))
    for (const Part& part : *parts)
      files.push_back(std::filesystem::path(path).replace_extension(part.extension).string());
  return files;
}

bool holdsFields(const std::string& path) {
  const std::vector<Part>* const parts = formatOf(path);
  return parts != nullptr && parts->front().write == writeVtu;
}

Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options, OutputSet& set) {
  const std::vector<Part>* parts = formatOf(path);
  if (parts == nullptr) {
    return Error{.kind = ErrorKind::usage,
                 .message = fmt::format("no mesh format has the extension '{}'",
                                        std::filesystem::path(path).extension().string()),
                 .hint = "known are " + meshFormatsWritten(),
                 .file = path,
                 .loop = {}};
  }
  const std::vector<std::string> files = meshFilesOf(path);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Result<AtomicFile*> target = set.open(files[i]);
    if (!target) return target.error();
    TextSink sink(**target);
    const Writer write = options.msh2 && (*parts)[i].write == writeMsh4 ? writeMsh2 : (*parts)[i].write;
    write(file, sink);
    if (Status finished = sink.finish(); !finished) return finished;
  }
  return success();
}

Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options) {
  OutputSet set;
  if (const Status written = writeMesh(path, file, options, set); !written) return written;
  return set.commit();
}

}  // namespace triscope
