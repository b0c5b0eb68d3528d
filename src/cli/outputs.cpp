#include "cli/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/interrupt.h"
#include "core/io/atomic_file.h"
#include "core/io/export.h"
#include "core/io/write_mesh.h"
#include "core/pipeline.h"
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
      return Error{.code = ExitCode::usage,
                   .message = "no format is known for this file name",
                   .hint = fmt::format("name it {} or {}", meshFormatsWritten(), figureFormats()),
                   .file = path};
    if (last < Stage::triangulation)
      return Error{.code = ExitCode::usage,
                   .message = fmt::format("there is no mesh yet when the stage {} is over", infoOf(last).key),
                   .hint = fmt::format("run at least --until triangulation, or draw a picture ({})", figureFormats()),
                   .file = path};
  }
  return success();
}

Status probeOutputs(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    const Result<AtomicFile> file = AtomicFile::create(path);  // gone again at the end of this line's scope
    if (!file.ok()) return file.error();
  }
  return success();
}

Status writeOutputs(const std::vector<std::string>& paths, const MeshState& state, Stage last, bool msh2) {
  const bool anyMesh = std::any_of(paths.begin(), paths.end(), isMeshPath);
  const bool anyFields = std::any_of(paths.begin(), paths.end(), holdsFields);
  const MeshFile mesh = anyMesh ? exportMesh(state, anyFields ? Fields::yes : Fields::no) : MeshFile{};
  for (const std::string& path : paths) {
    const Status written =
        isFigurePath(path)
            ? writeFigure(path, state, figureView(last),
                          {.title = figureTitle(state, last), .caption = figureCaption(state, last), .region = {}})
            : writeMesh(path, mesh, {.msh2 = msh2, .cancelled = interrupted});
    if (!written.ok()) return written;
  }
  return success();
}

}  // namespace triscope
