#include "ui/app/exporting.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/file_identity.h"
#include "core/base/output_set.h"
#include "core/io/export.h"
#include "core/io/write_mesh.h"
#include "render/figure.h"
#include "ui/model/export_format.h"

namespace triscope {
namespace {

/// `rows` are those of the sweep that is shown.
Status writeAs(const ExportFormat& format, const std::string& path, const MeshState& state,
               const std::vector<SweepRow>& rows, const ViewOptions& options, const FigureOptions& figure) {
  switch (format.content) {
    case ExportFormat::Content::mesh:
      break;
    case ExportFormat::Content::domain:
      return writeWhole(path, state.domain->text);
    case ExportFormat::Content::picture:
      return writeFigure(path, state, options, figure);
    case ExportFormat::Content::sweep:
      return writeWhole(path, csvOf(rows));
  }
  return writeMesh(path, exportMesh(state, holdsFields(path) ? Fields::yes : Fields::no));
}

}  // namespace

std::string suggestedPath(const Desk& desk, const char* extension) {
  const Domain* const domain = shownDomain(desk);
  std::string name = domain != nullptr && !domain->name.empty() ? domain->name : "mesh";
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '_');
  std::error_code failure;
  return (std::filesystem::current_path(failure) / (name + extension)).string();
}

std::string freePath(const Desk& desk, const char* extension) {
  const std::string wanted = suggestedPath(desk, extension);
  const std::string stem = wanted.substr(0, wanted.size() - std::string_view(extension).size());
  std::error_code failure;
  std::string path = wanted;
  for (int k = 2; std::filesystem::exists(path, failure); ++k) path = fmt::format("{}-{}{}", stem, k, extension);
  return path;
}

void Exporting::writeTo(const std::string& path) {
  if (job_.running()) return;
  const SnapshotPtr now = desk_.session.current();
  const ExportFormat* const format = exportFormatOf(path);  // there is one: the dialog takes no other name
  if (now == nullptr || format == nullptr) return;
  // The domain itself may replace the file that it came from: the dialog has said that there is one.
  std::vector<NamedFile> inputs{{"the session that is open", desk_.ui.document.path}};
  if (format->content != ExportFormat::Content::domain) inputs.push_back(openDomain(desk_));
  std::vector<NamedFile> outputs{{"the export", path}};
  for (const std::string& file : meshFilesOf(path))
    if (file != path) outputs.push_back({"the export as " + path, file});
  if (const Status apart = checkOverwrites(inputs, outputs); !apart) return complain(desk_.ui, apart.error());
  desk_.ui.exporting = true;
  path_ = path;
  desk_.ui.message = "Writing " + path + " …";
  ViewOptions options = desk_.ui.picture();
  options.selection = runOf(desk_).selection();
  FigureOptions figure;
  figure.width = static_cast<int>(desk_.ui.camera.width);
  figure.height = static_cast<int>(desk_.ui.camera.height);
  figure.scale = desk_.ui.scale();
  figure.title = figureTitle(now->state, now->state.stage);
  figure.caption = figureCaption(now->state, now->state.stage);
  figure.region = visibleBox(desk_.ui.camera);
  job_.start(
      [now, path, format, options, figure,
       rows = desk_.ui.sweep.table ? rowsOf(*desk_.ui.sweep.table) : std::vector<SweepRow>()] {
        return writeAs(*format, path, now->state, rows, options, figure);
      },
      desk_.wake);
}

void Exporting::follow() {
  const std::optional<Status> outcome = job_.finished();
  if (!outcome) return;
  desk_.ui.exporting = false;
  if (*outcome) {
    desk_.ui.message = "Wrote " + path_ + ".";
    return;
  }
  desk_.ui.message.clear();
  complain(desk_.ui, outcome->error());
}

}  // namespace triscope
