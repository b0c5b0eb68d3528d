#include "render/font.h"

#include <array>
#include <cstdint>

#include "render/embedded.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace triscope {
namespace {

struct Font {
  stbtt_fontinfo info{};
  bool usable = false;
  double unitsPerEm = 1.0;
};

Font load(std::string_view name) {
  Font font;
  const auto bytes = findEmbedded(embeddedFonts(), name);
  if (bytes.empty()) return font;
  font.usable = stbtt_InitFont(&font.info, bytes.data(), stbtt_GetFontOffsetForIndex(bytes.data(), 0)) != 0;
  if (font.usable) font.unitsPerEm = 1.0 / static_cast<double>(stbtt_ScaleForMappingEmToPixels(&font.info, 1.0f));
  return font;
}

// The text fonts by weight, then the one that has the signs they lack.
const std::array<Font, 3>& fonts() {
  static const std::array<Font, 3> all{load("Inter-Regular.otf"), load("Inter-SemiBold.otf"),
                                       load("DejaVuSansMono.ttf")};
  return all;
}

struct Glyph {
  const Font* font = nullptr;
  int index = 0;
};

Glyph glyphOf(char32_t code, Weight weight) {
  const Font& first = fonts()[static_cast<std::size_t>(weight)];
  for (const Font* font : {&first, &fonts()[2]}) {
    if (!font->usable) continue;
    const int index = stbtt_FindGlyphIndex(&font->info, static_cast<int>(code));
    if (index != 0) return {font, index};
  }
  return {&first, 0};
}

double advanceOf(const Glyph& glyph) {
  int advance = 0;
  int bearing = 0;
  stbtt_GetGlyphHMetrics(&glyph.font->info, glyph.index, &advance, &bearing);
  return static_cast<double>(advance) / glyph.font->unitsPerEm;
}

double kerning(const Glyph& left, const Glyph& right) {
  if (left.font == nullptr || left.font != right.font) return 0.0;
  return static_cast<double>(stbtt_GetGlyphKernAdvance(&left.font->info, left.index, right.index)) /
         left.font->unitsPerEm;
}

// Pen positions in ems, glyph by glyph; returns the width.
template <class Visit>
double walk(std::string_view text, Weight weight, Visit visit) {
  double x = 0.0;
  Glyph before;
  while (!text.empty()) {
    const Glyph glyph = glyphOf(takeCodePoint(text), weight);
    if (!glyph.font->usable) continue;
    x += kerning(before, glyph);
    visit(glyph, x);
    x += advanceOf(glyph);
    before = glyph;
  }
  return x;
}

void addContours(const Glyph& glyph, Pixel origin, double size, std::vector<std::vector<Pixel>>& contours) {
  stbtt_vertex* vertices = nullptr;
  const int count = stbtt_GetGlyphShape(&glyph.font->info, glyph.index, &vertices);
  const double scale = size / glyph.font->unitsPerEm;
  const auto place = [&](stbtt_vertex_type x, stbtt_vertex_type y) -> Pixel {
    return {origin.x + scale * static_cast<double>(x), origin.y - scale * static_cast<double>(y)};
  };
  constexpr int kPieces = 6;  // chords per curve: within a tenth of a pixel at any size text is drawn
  // TrueType outlines turn the other way round than PostScript ones; make them alike.
  const bool reversed = glyph.font == &fonts()[2];
  const std::size_t firstOfGlyph = contours.size();
  for (int i = 0; i < count; ++i) {
    const stbtt_vertex& v = vertices[i];
    const Pixel to = place(v.x, v.y);
    if (v.type == STBTT_vmove || contours.size() == firstOfGlyph) {
      contours.emplace_back(1, to);
      continue;
    }
    std::vector<Pixel>& contour = contours.back();
    const Pixel from = contour.back();
    const Pixel c0 = place(v.cx, v.cy);
    const Pixel c1 = place(v.cx1, v.cy1);
    for (int k = 1; k < kPieces && v.type != STBTT_vline; ++k) {
      const double t = static_cast<double>(k) / kPieces;
      const double s = 1.0 - t;
      contour.push_back(v.type == STBTT_vcurve
                            ? s * s * from + 2.0 * s * t * c0 + t * t * to
                            : s * s * s * from + 3.0 * s * s * t * c0 + 3.0 * s * t * t * c1 + t * t * t * to);
    }
    contour.push_back(to);
  }
  stbtt_FreeShape(&glyph.font->info, vertices);
  if (!reversed) return;
  for (std::size_t i = firstOfGlyph; i < contours.size(); ++i) {
    contours[i] = std::vector<Pixel>(contours[i].rbegin(), contours[i].rend());
  }
}

}  // namespace

char32_t takeCodePoint(std::string_view& text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
  if (length == 0 || text.size() < length) {
    text.remove_prefix(1);
    return 0xFFFD;
  }
  char32_t code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) {
      text.remove_prefix(1);
      return 0xFFFD;
    }
    code = code << 6u | (byte(i) & 0x3Fu);
  }
  text.remove_prefix(length);
  return code;
}

double textWidth(std::string_view text, double size, Weight weight) {
  return size * walk(text, weight, [](const Glyph&, double) {});
}

std::vector<std::vector<Pixel>> textContours(std::string_view text, Pixel at, double size, Weight weight) {
  std::vector<std::vector<Pixel>> contours;
  walk(text, weight,
       [&](const Glyph& glyph, double x) { addContours(glyph, {at.x + size * x, at.y}, size, contours); });
  return contours;
}

}  // namespace triscope
