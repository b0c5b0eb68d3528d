// Draws the figures of the paper with this program: make_figures DOMAINS FOLDER
#include <fmt/format.h>

#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/method/pipeline.h"
#include "render/figure.h"

namespace {

using namespace triscope;

bool failed(const Error& error) {
  fmt::print(stderr, "{}\n", describe(error));
  return false;
}

bool beginDomain(const std::string& path, MeshState& state) {
  Result<Domain> domain = readDomain(path);
  if (!domain.ok()) return failed(domain.error());
  Result<MeshState> begun = begin(std::make_shared<const Domain>(*domain), Settings{});
  if (!begun.ok()) return failed(begun.error());
  state = *begun;
  return true;
}

void carryOn(MeshState& state, const FigurePreset& preset) {
  Journal nobody;
  if (preset.decisions == 0) {
    advanceUntil(state, preset.stage, ~0ull, nobody);
    return;
  }
  while (state.stage < preset.stage && advance(state, Grain::stage, nobody)) {
  }
  for (std::uint64_t i = 0; i < preset.decisions; ++i) advance(state, Grain::decision, nobody);
}

bool draw(const MeshState& state, const FigurePreset& preset, const std::string& folder) {
  ViewOptions view = figureView(preset.stage);
  view.cells = preset.cells;
  FigureOptions options;
  options.width = 960;
  options.height = 760;
  options.title = fmt::format("Figure {}", preset.name);
  options.caption = fmt::format("{} {}", preset.caption, figureCaption(state, preset.stage));
  if (!preset.loop.empty()) {
    options.region = regionAround(*state.domain, preset.loop);
    options.height = 560;
  }
  // A vector file of a mesh this large would be larger than the picture.
  const char* ending = state.mesh.liveCount() > 10000 ? "png" : "svg";
  const Status written = writeFigure(fmt::format("{}/figure_{}.{}", folder, preset.name, ending), state, view, options);
  return written.ok() || failed(written.error());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: {} DOMAINS FOLDER\n", argv[0]);
    return 2;
  }
  MeshState state;
  std::string_view domain;
  for (const FigurePreset& preset : figurePresets()) {
    if (preset.domain != domain && !beginDomain(fmt::format("{}/{}.json", argv[1], preset.domain), state)) return 1;
    domain = preset.domain;
    carryOn(state, preset);
    if (!draw(state, preset, argv[2])) return 1;
  }
  return 0;
}
