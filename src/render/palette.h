// Every colour that Triscope draws with: the themes, the sequential scales and the categories.
#pragma once

#include <array>
#include <string_view>

#include "core/density/quadtree.h"
#include "core/mesh/mesh.h"
#include "core/words/stage.h"
#include "render/color.h"

namespace triscope {

enum class Scale : std::uint8_t { cividis, viridis };
enum class ThemeKind : std::uint8_t { light, dark, high_contrast };
/// As files name them, in their order.
inline constexpr std::array<std::string_view, 3> kThemeNames{"light", "dark", "high contrast"};

/// Colour at t in [0, 1] of a perceptually uniform scale that reads without red-green vision; dark at 0, light at 1.
Color scaleColor(Scale scale, double t);

/// Okabe and Ito's eight colours for categories, told apart under every common colour vision.
namespace okabe {
inline constexpr Color black = rgb(0x000000);
inline constexpr Color orange = rgb(0xE69F00);
inline constexpr Color sky = rgb(0x56B4E9);
inline constexpr Color green = rgb(0x009E73);
inline constexpr Color yellow = rgb(0xF0E442);
inline constexpr Color blue = rgb(0x0072B2);
inline constexpr Color vermillion = rgb(0xD55E00);
inline constexpr Color purple = rgb(0xCC79A7);
}  // namespace okabe

/// What a theme gives: text on background reads at 4.5:1 or better, lines at 3:1 or better.
struct Theme {
  Color background;
  Color surface;     // panels, the legend's box
  Color text;        // on background and on surface
  Color textMuted;   // still 4.5:1
  Color domainFill;  // inside of the domain where nothing else fills it
  Color wire;        // edges of the triangulation
  Color helperWire;  // edges to the helper corners, before carve
  Color cellLine;    // borders of the quadtree
  Color boundary;    // boundary of the domain
  Color front1;
  Color front2;
  Color kept;    // input points and corners
  Color placed;  // boundary points placed by density or by a split
  Color steiner;
  Color fewer;  // vertices of fewer triangles than their angle asks for, and of more
  Color more;
  Color constraint;
  Color obtuse;     // fill of obtuse triangles
  Color overBound;  // fill of a triangle that breaks a bound
  Color created;    // hatch of what the current decision made
  Color removed;    // dotted: what it removed
  Color candidate;  // the candidate point and its circumcircle
  Color refused;    // a point that was refused
  Color worstAspect;
  Color worstArea;
  Color worstEdge;
  Color selection;
  bool dark = false;
};

const Theme& themeOf(ThemeKind kind);

/// Fill of a quadtree cell by density rank: the densest rank stands out from the background in every theme, and the
/// scale is softened toward the background so that lines and marks read on top of it.
Color rankColor(Scale scale, const Theme& theme, int rank, int lowest, int highest);
Color cellTypeColor(const Theme& theme, CellType type);
/// Category colour of a stage, for the timeline.
Color stageColor(const Theme& theme, Stage stage);

/// Relative luminance contrast of two opaque colours, 1 … 21 (WCAG 2).
double contrast(Color a, Color b);

}  // namespace triscope
