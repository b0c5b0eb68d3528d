#include "ui/model/fonts.h"

#include <cmath>

#include "render/embedded.h"

namespace triscope {
namespace {

// Latin, Greek, and the signs that the texts use: dashes and quotes, sub- and superscripts, arrows, mathematics,
// geometric shapes and ticks.
constexpr ImWchar kRanges[] = {0x0020, 0x017F, 0x0394, 0x03C9, 0x2000, 0x2044, 0x2070, 0x209C, 0x2190, 0x21FF,
                               0x2200, 0x22FF, 0x25A0, 0x25FF, 0x2605, 0x2606, 0x2713, 0x2717, 0};

void add(ImFontAtlas& atlas, const char* file, float pixels, bool merge) {
  const std::span<const unsigned char> bytes = findEmbedded(embeddedFonts(), file);
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.MergeMode = merge;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  // The atlas only reads the data; its interface is not const.
  atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()), pixels, &config,
                             kRanges);
}

ImFont* addWithSymbols(ImFontAtlas& atlas, const char* file, float pixels) {
  add(atlas, file, pixels, false);
  add(atlas, "DejaVuSansMono.ttf", pixels * 0.9f, true);  // the signs that Inter lacks
  return atlas.Fonts.back();
}

}  // namespace

Fonts loadFonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  // A size is that of a line, from ascender to descender: 17 px are letters of 14 px to the em.
  const auto pixels = [scale](float size) { return std::round(size * scale); };
  Fonts fonts;
  fonts.text = addWithSymbols(atlas, "Inter-Regular.otf", pixels(17.0f));
  fonts.small = addWithSymbols(atlas, "Inter-Regular.otf", pixels(15.0f));
  fonts.strong = addWithSymbols(atlas, "Inter-SemiBold.otf", pixels(17.0f));
  fonts.title = addWithSymbols(atlas, "Inter-SemiBold.otf", pixels(21.0f));
  ImGui::GetIO().FontDefault = fonts.text;
  return fonts;
}

}  // namespace triscope
