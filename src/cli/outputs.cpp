#include "cli/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/io/export.h"
#include "core/io/write_mesh.h"
#include "core/method/pipeline.h"
#include "render/figure.h"

namespace triscope {

std::string figureFormats() { return ".svg, .png"; }

bool isFigurePath(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension == ".svg" || extension == ".png";
}

Status checkOutputs(const std::vector<std::string>& paths, Stage last) {
  for (const std::string& path : paths) {
    if (isFigurePath(path)) continue;
    if (!isMeshPath(path))
      return Error{.kind = ErrorKind::usage,
                   .message = "no format is known for this file name",
                   .hint = fmt::format("name it {} or {}", meshFormatsWritten(), figureFormats()),
                   .file = path};
    if (last < Stage::triangulation)
      return Error{.kind = ErrorKind::usage,
                   .message = fmt::format("there is no mesh yet when the stage {} is over", infoOf(last).key),
                   .hint = fmt::format("run at least --until triangulation, or draw a picture ({})", figureFormats()),
                   .file = path};
  }
  return success();
}

std::vector<std::string> filesOf(const std::string& path) {
  return isMeshPath(path) ? meshFilesOf(path) : std::vector<std::string>{path};
}

Status openOutputs(const std::vector<std::string>& paths, OutputSet& set) {
  for (const std::string& path : paths) {
    for (const std::string& name : filesOf(path))
      if (const Result<AtomicFile*> file = set.open(name); !file.ok()) return file.error();
  }
  return success();
}

Status writeOutputs(const std::vector<std::string>& paths, const MeshState& state, Stage last,
                    const MeshWriteOptions& options, OutputSet& set) {
  const bool anyMesh = std::any_of(paths.begin(), paths.end(), isMeshPath);
  const bool anyFields = std::any_of(paths.begin(), paths.end(), holdsFields);
  const MeshFile mesh = anyMesh ? exportMesh(state, anyFields ? Fields::yes : Fields::no) : MeshFile{};
  for (const std::string& path : paths) {
    if (isMeshPath(path)) {
      if (const Status written = writeMesh(path, mesh, options, set); !written.ok()) return written;
      continue;
    }
    const Result<std::string> picture =
        figureOf(path, state, figureView(last),
                 {.title = figureTitle(state, last), .caption = figureCaption(state, last), .region = {}});
    if (!picture.ok()) return picture.error();
    if (const Status written = set.write(path, *picture); !written.ok()) return written;
  }
  return success();
}

}  // namespace triscope
