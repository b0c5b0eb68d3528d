#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/method/method.h"

namespace triscope {
namespace {

// Ten equally spaced samples of each published map; straight lines between them stay within 2/255 of it.
constexpr std::array<Color, 10> kCividis{rgb(0x00224E), rgb(0x123570), rgb(0x3B496C), rgb(0x575D6D), rgb(0x707173),
                                         rgb(0x8A8678), rgb(0xA59C74), rgb(0xC3B369), rgb(0xE1CC55), rgb(0xFEE838)};
constexpr std::array<Color, 10> kViridis{rgb(0x440154), rgb(0x482878), rgb(0x3E4989), rgb(0x31688E), rgb(0x26828E),
                                         rgb(0x1F9E89), rgb(0x35B779), rgb(0x6ECE58), rgb(0xB5DE2B), rgb(0xFDE725)};

Theme lightTheme() {
  Theme t;
  t.background = rgb(0xFFFFFF);
  t.surface = rgb(0xF6F7F9);
  t.text = rgb(0x16191D);
  t.textMuted = rgb(0x565D66);
  t.domainFill = rgb(0xF1F4F8);
  t.wire = rgb(0x4A5A6B);
  t.helperWire = rgb(0xB9C1CA);
  t.cellLine = rgb(0x7D8894);
  t.boundary = rgb(0x10141A);
  t.front1 = okabe::blue;
  t.front2 = okabe::vermillion;
  t.kept = rgb(0x10141A);
  t.placed = rgb(0x10141A);
  t.steiner = okabe::green;
  t.fewer = rgb(0x8C2D8C);
  t.more = rgb(0x6E6000);
  t.constraint = okabe::vermillion;
  t.obtuse = rgb(0xF3B27A);
  t.overBound = rgb(0xE4572E);
  t.created = okabe::green;
  t.removed = rgb(0xB03A00);
  t.candidate = rgb(0x7A3EB1);
  t.refused = okabe::vermillion;
  t.worstAspect = rgb(0xB23A00);
  t.worstArea = okabe::blue;
  t.worstEdge = rgb(0x007A5A);
  t.selection = rgb(0xB8338A);
  return t;
}

Theme darkTheme() {
  Theme t;
  t.background = rgb(0x14171C);
  t.surface = rgb(0x1D2128);
  t.text = rgb(0xECEFF3);
  t.textMuted = rgb(0xA3ACB8);
  t.domainFill = rgb(0x1B2027);
  t.wire = rgb(0x8496AA);
  t.helperWire = rgb(0x414B57);
  t.cellLine = rgb(0x55606D);
  t.boundary = rgb(0xF4F6F8);
  t.front1 = okabe::sky;
  t.front2 = okabe::orange;
  t.kept = rgb(0xF4F6F8);
  t.placed = rgb(0xF4F6F8);
  t.steiner = rgb(0x35C79A);
  t.fewer = okabe::purple;
  t.more = okabe::yellow;
  t.constraint = okabe::orange;
  t.obtuse = rgb(0x8A5A24);
  t.overBound = rgb(0xD1452A);
  t.created = rgb(0x35C79A);
  t.removed = okabe::orange;
  t.candidate = rgb(0xC9A0FF);
  t.refused = rgb(0xFF8A4C);
  t.worstAspect = rgb(0xFF8A4C);
  t.worstArea = okabe::sky;
  t.worstEdge = rgb(0x35C79A);
  t.selection = rgb(0xF09CCB);
  t.dark = true;
  return t;
}

Theme highContrastTheme() {
  Theme t;
  t.background = rgb(0x000000);
  t.surface = rgb(0x000000);
  t.text = rgb(0xFFFFFF);
  t.textMuted = rgb(0xE6E6E6);
  t.domainFill = rgb(0x000000);
  t.wire = rgb(0xD0D0D0);
  t.helperWire = rgb(0x707070);
  t.cellLine = rgb(0x9A9A9A);
  t.boundary = rgb(0xFFFFFF);
  t.front1 = rgb(0x66CCFF);
  t.front2 = rgb(0xFFB000);
  t.kept = rgb(0xFFFFFF);
  t.placed = rgb(0xFFFFFF);
  t.steiner = rgb(0x40E0A0);
  t.fewer = rgb(0xFF9FDF);
  t.more = rgb(0xFFF060);
  t.constraint = rgb(0xFFB000);
  t.obtuse = rgb(0x9A5A00);
  t.overBound = rgb(0xE03020);
  t.created = rgb(0x40E0A0);
  t.removed = rgb(0xFFB000);
  t.candidate = rgb(0xD0B0FF);
  t.refused = rgb(0xFF7050);
  t.worstAspect = rgb(0xFF7050);
  t.worstArea = rgb(0x66CCFF);
  t.worstEdge = rgb(0x40E0A0);
  t.selection = rgb(0xFFA0E0);
  t.dark = true;
  return t;
}

double linear(std::uint8_t channel) {
  const double c = static_cast<double>(channel) / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(Color c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); }

}  // namespace

Color scaleColor(Scale scale, double t) {
  const std::span<const Color, 10> stops = scale == Scale::viridis ? kViridis : kCividis;
  const double at = std::clamp(t, 0.0, 1.0) * 9.0;
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), 8);
  return mix(stops[i], stops[i + 1], at - static_cast<double>(i));
}

const Theme& themeOf(ThemeKind kind) {
  static const std::array<Theme, 3> themes{lightTheme(), darkTheme(), highContrastTheme()};
  return themes[static_cast<std::size_t>(kind)];
}

Color rankColor(Scale scale, const Theme& theme, int rank, int lowest, int highest) {
  const double span = std::max(1, highest - lowest);
  const double t = std::clamp(static_cast<double>(rank - lowest) / span, 0.0, 1.0);
  return mix(theme.background, scaleColor(scale, theme.dark ? 1.0 - t : t), theme.dark ? 0.8 : 0.72);
}

Color cellTypeColor(const Theme& theme, CellType type) {
  const double strength = theme.dark ? 0.55 : 0.5;
  switch (type) {
    case CellType::outside:
      return mix(theme.background, theme.cellLine, 0.18);
    case CellType::boundary:
      return mix(theme.background, okabe::orange, strength + 0.2);
    case CellType::adjacent_boundary:
      return mix(theme.background, okabe::sky, strength);
    case CellType::white:
      break;
  }
  return theme.background;
}

Color stageColor(const Theme& theme, Stage stage) {
  // The paper's sections have a colour each; lighter to darker within.
  const StageInfo& info = infoOf(stage);
  if (stage == Stage::repair) return mix(theme.background, okabe::vermillion, info.shade);
  switch (info.group) {
    case StageGroup::density:
      return mix(theme.background, okabe::purple, info.shade);
    case StageGroup::boundary:
      return mix(theme.background, okabe::orange, info.shade);
    case StageGroup::fronts:
      return mix(theme.background, okabe::sky, info.shade);
    case StageGroup::filling:
    case StageGroup::rounds:
      return mix(theme.background, okabe::blue, info.shade);
    case StageGroup::refinement:
      return mix(theme.background, okabe::green, info.shade);
    case StageGroup::optimisation:
      return mix(theme.background, mix(okabe::green, okabe::yellow, 0.4), info.shade);
    case StageGroup::end:
      break;
  }
  return mix(theme.text, okabe::green, info.shade);  // apart from step 6, and from any background
}

double contrast(Color a, Color b) {
  const double la = luminance(a);
  const double lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace triscope
