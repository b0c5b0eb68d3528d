// Writing meshes, domains and pictures, on a thread of its own.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/file_identity.h"
#include "core/base/output_set.h"
#include "core/io/export.h"
#include "core/io/write_mesh.h"
#include "render/figure.h"
#include "ui/app/app.h"
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

std::string App::suggestedPath(const char* extension) const {
  std::string name = shownDomain_ && !shownDomain_->name.empty() ? shownDomain_->name : "mesh";
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '_');
  std::error_code failure;
  return (std::filesystem::current_path(failure) / (name + extension)).string();
}

std::string App::freePath(const char* extension) const {
  const std::string wanted = suggestedPath(extension);
  const std::string stem = wanted.substr(0, wanted.size() - std::string_view(extension).size());
  std::error_code failure;
  std::string path = wanted;
  for (int k = 2; std::filesystem::exists(path, failure); ++k) path = fmt::format("{}-{}{}", stem, k, extension);
  return path;
}

void App::exportTo(const std::string& path) {
  if (export_.running()) return;
  const SnapshotPtr now = session_.current();
  const ExportFormat* const format = exportFormatOf(path);  // there is one: the dialog takes no other name
  if (now == nullptr || format == nullptr) return;
  // The domain itself may replace the file that it came from: the dialog has said that there is one.
  std::vector<NamedFile> inputs{{"the session that is open", ui_.document.path}};
  if (format->content != ExportFormat::Content::domain) inputs.push_back(openDomain());
  std::vector<NamedFile> outputs{{"the export", path}};
  for (const std::string& file : meshFilesOf(path))
    if (file != path) outputs.push_back({"the export as " + path, file});
  if (const Status apart = checkOverwrites(inputs, outputs); !apart) return complain(apart.error());
  ui_.exporting = true;
  exportPath_ = path;
  ui_.message = "Writing " + path + " …";
  ViewOptions options = ui_.options;
  options.theme = ui_.look.theme;
  options.selection = view().selection();
  FigureOptions figure;
  figure.width = static_cast<int>(ui_.camera.width);
  figure.height = static_cast<int>(ui_.camera.height);
  figure.scale = ui_.scale();
  figure.title = figureTitle(now->state, now->state.stage);
  figure.caption = figureCaption(now->state, now->state.stage);
  figure.region = visibleBox(ui_.camera);
  export_.start(
      [now, path, format, options, figure,
       rows = ui_.sweep.table ? rowsOf(*ui_.sweep.table) : std::vector<SweepRow>()] {
        return writeAs(*format, path, now->state, rows, options, figure);
      },
      wake_);
}

void App::finishExport() {
  const std::optional<Status> outcome = export_.finished();
  if (!outcome) return;
  ui_.exporting = false;
  if (*outcome) {
    ui_.message = "Wrote " + exportPath_ + ".";
    return;
  }
  ui_.message.clear();
  ui_.error = outcome->error();
  ui_.dialog = Dialog::error;
}

}  // namespace triscope
