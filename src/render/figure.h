// A state as a figure in a file, with defaults that show what each stage does. The paper's figures are one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/method/state.h"
#include "render/view_options.h"

namespace triscope {

struct FigureOptions {
  int width = 1200;  // pixels, of the whole picture
  int height = 900;
  double scale = 1.0;  // of text, lines and marks
  std::string title;
  std::string caption;
  bool legend = true;
  std::optional<Box> region;  // part of the plane to show; the whole domain when absent
};

/// What to show of a state at the end of `stage`.
ViewOptions figureView(Stage stage);
/// "blunt body, after step 1", and one sentence with the figures of the state.
std::string figureTitle(const MeshState& state, Stage stage);
std::string figureCaption(const MeshState& state, Stage stage);

/// The bytes of a picture of the state, as SVG or PNG by the ending of `path`.
/// Errors: usage (another ending, an impossible size).
Result<std::string> figureOf(const std::string& path, const MeshState& state, const ViewOptions& view,
                             const FigureOptions& options);
/// Draws it into a file of that name; written whole or not at all. Errors: also cannot_write.
Status writeFigure(const std::string& path, const MeshState& state, const ViewOptions& view,
                   const FigureOptions& options);

/// One figure of the paper: run the first `decisions` decisions of `stage` (0: all of it), then draw.
struct FigurePreset {
  std::string_view name;    // "1a"
  std::string_view domain;  // name of the sample that it shows
  Stage stage = Stage::finished;
  std::uint64_t decisions = 0;
  std::string_view loop;  // show what lies around this loop only; empty: everything
  CellColoring cells = CellColoring::rank;
  std::string_view caption;  // our words
};
/// In the order in which one run of each domain comes by them.
std::span<const FigurePreset> figurePresets();

/// What is around a loop: its box and a quarter of its size on every side. None when no loop has that name.
std::optional<Box> regionAround(const Domain& domain, std::string_view loop);

}  // namespace triscope
