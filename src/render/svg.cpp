#include "render/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "render/stroke.h"

namespace triscope {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string hex(Color c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

/// ` fill="#…" fill-opacity="…"`, the opacity only where it is not 1.
std::string paint(const char* what, Color c) {
  std::string text = fmt::format(" {}=\"{}\"", what, hex(c));
  if (c.a < 255) text += fmt::format(" {}-opacity=\"{:.3g}\"", what, static_cast<double>(c.a) / 255.0);
  return text;
}

// Coordinates in hundredths of a pixel, written as short as they come; relative ones keep their rounding from
// adding up because they are differences of rounded positions.
class PathData {
 public:
  explicit PathData(std::string& out) : out_(out) {}

  void move(Pixel p) {
    out_ += 'M';
    at_ = rounded(p);
    start_ = at_;
    fresh_ = true;
    pair(at_);
    command_ = 'M';
  }
  void line(Pixel p) {
    const Fixed to = rounded(p);
    if (to.x == at_.x && to.y == at_.y) return;
    if (command_ != 'l') {
      out_ += 'l';
      fresh_ = true;
    }
    command_ = 'l';
    pair({to.x - at_.x, to.y - at_.y});
    at_ = to;
  }
  void close() {
    out_ += 'z';
    at_ = start_;
    command_ = 'z';
  }

 private:
  struct Fixed {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };
  static Fixed rounded(Pixel p) {
    const auto fix = [](double v) { return static_cast<std::int64_t>(std::llround(std::clamp(v, -1e7, 1e7) * 100.0)); };
    return {fix(p.x), fix(p.y)};
  }
  void pair(Fixed v) {
    number(v.x);
    number(v.y);
  }
  void number(std::int64_t hundredths) {
    char digits[24];
    char* end = digits + sizeof digits;
    char* first = end;
    std::uint64_t rest = static_cast<std::uint64_t>(hundredths < 0 ? -hundredths : hundredths);
    const std::uint64_t fraction = rest % 100;
    if (fraction % 10 != 0) *--first = static_cast<char>('0' + fraction % 10);
    if (fraction != 0) {
      *--first = static_cast<char>('0' + fraction / 10);
      *--first = '.';
    }
    rest /= 100;
    if (rest == 0 && fraction == 0) *--first = '0';
    while (rest > 0) {
      *--first = static_cast<char>('0' + rest % 10);
      rest /= 10;
    }
    if (hundredths < 0) {
      *--first = '-';
    } else if (!fresh_) {
      out_ += ' ';
    }
    out_.append(first, static_cast<std::size_t>(end - first));
    fresh_ = false;
  }

  std::string& out_;
  Fixed at_;
  Fixed start_;
  bool fresh_ = true;  // right after a letter no separator is needed
  char command_ = ' ';
};

class SvgCanvas final : public Canvas {
 public:
  explicit SvgCanvas(std::string& out) : out_(out) {}

  void beginClip(Rect rect) override {
    ++clips_;
    out_ += fmt::format(
        "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" height=\"{4:.2f}\"/></clipPath>\n"
        "<g clip-path=\"url(#clip{0})\">\n",
        clips_, rect.x, rect.y, rect.width, rect.height);
  }

  void endClip() override { out_ += "</g>\n"; }

  void fillRects(std::span<const FilledRect> rects) override {
    for (std::size_t i = 0; i < rects.size();) {
      // Runs of one colour share a group.
      std::size_t end = i;
      while (end < rects.size() && rects[end].fill == rects[i].fill) ++end;
      out_ += fmt::format("<path{} d=\"", paint("fill", rects[i].fill));
      PathData path(out_);
      for (; i < end; ++i) {
        const Rect& r = rects[i].rect;
        path.move({r.x, r.y});
        path.line({r.x + r.width, r.y});
        path.line({r.x + r.width, r.y + r.height});
        path.line({r.x, r.y + r.height});
        path.close();
      }
      out_ += "\"/>\n";
    }
  }

  void fillTriangles(std::span<const Pixel> points, std::span<const Index3> triangles, std::span<const Color> fills,
                     bool hatched) override {
    if (fills.size() == 1) {
      const std::string fill = hatched ? hatching(fills[0]) : paint("fill", fills[0]);
      // A hair of stroke in the same colour closes the seams that renderers leave between neighbours.
      const std::string seam = hatched || fills[0].a < 255 ? "" : paint("stroke", fills[0]) + " stroke-width=\".4\"";
      out_ += fmt::format("<path{}{} d=\"", fill, seam);
      PathData path(out_);
      for (const Index3& t : triangles) triangle(path, points, t);
      out_ += "\"/>\n";
      return;
    }
    // One path per colour, in the order in which the colours first appear.
    std::vector<Color> colors;
    std::unordered_map<std::uint32_t, std::size_t> indexOf;
    std::vector<std::vector<std::uint32_t>> members;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      std::uint32_t key = 0;
      std::memcpy(&key, &fills[i], sizeof key);
      const auto [found, added] = indexOf.try_emplace(key, colors.size());
      if (added) {
        colors.push_back(fills[i]);
        members.emplace_back();
      }
      members[found->second].push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t c = 0; c < colors.size(); ++c) {
      const std::string seam = colors[c].a < 255 ? "" : paint("stroke", colors[c]) + " stroke-width=\".4\"";
      out_ += fmt::format("<path{}{} d=\"", paint("fill", colors[c]), seam);
      PathData path(out_);
      for (const std::uint32_t i : members[c]) triangle(path, points, triangles[i]);
      out_ += "\"/>\n";
    }
  }

  void stroke(const Paths& paths, const LineStyle& style) override {
    out_ += fmt::format("<path fill=\"none\"{} d=\"", strokeOf(style));
    PathData path(out_);
    for (std::size_t i = 0; i < paths.starts.size(); ++i) {
      const auto points = paths.path(i);
      const bool closed = points.size() > 3 && points.front() == points.back();
      path.move(points[0]);
      for (std::size_t k = 1; k + (closed ? 1 : 0) < points.size(); ++k) path.line(points[k]);
      if (closed) path.close();
    }
    out_ += "\"/>\n";
  }

  void circle(Pixel centre, double radius, const LineStyle& style) override {
    out_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\"{}/>\n", centre.x, centre.y,
                        radius, strokeOf(style));
  }

  void marks(std::span<const PlacedMark> marks, Shape shape, Color fill, Color outline) override {
    const std::string edge =
        outline.a > 0 ? paint("stroke", outline) + " stroke-width=\"2\" paint-order=\"stroke\"" : std::string();
    if (shape == Shape::circle) {
      out_ += fmt::format("<g{}{}>\n", paint("fill", fill), edge);
      for (const PlacedMark& mark : marks) {
        out_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", mark.at.x, mark.at.y,
                            0.5 * static_cast<double>(mark.size));
      }
    } else if (shape == Shape::ring) {
      out_ += fmt::format("<g fill=\"none\"{}>\n", paint("stroke", fill));
      for (const PlacedMark& mark : marks) {
        const double size = static_cast<double>(mark.size);
        const double pen = std::max(1.2, 0.18 * size);
        out_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" stroke-width=\"{:.2f}\"/>\n", mark.at.x,
                            mark.at.y, 0.5 * (size - pen), pen);
      }
    } else if (shape == Shape::cross) {
      if (outline.a > 0) crosses(marks, outline, 2.0);
      crosses(marks, fill, 0.0);
      return;
    } else {
      out_ += fmt::format("<g{}{}><path d=\"", paint("fill", fill), edge);
      PathData path(out_);
      for (const PlacedMark& mark : marks) {
        const auto outlinePoints = markOutline(shape);
        for (std::size_t i = 0; i < outlinePoints.size(); ++i) {
          const Pixel p = mark.at + static_cast<double>(mark.size) * outlinePoints[i];
          i == 0 ? path.move(p) : path.line(p);
        }
        path.close();
      }
      out_ += "\"/>";
    }
    out_ += "</g>\n";
  }

  void text(Pixel at, std::string_view text, const TextStyle& style) override {
    const char* anchor = style.anchor == Anchor::left     ? ""
                         : style.anchor == Anchor::centre ? " text-anchor=\"middle\""
                                                          : " text-anchor=\"end\"";
    std::string halo;
    if (style.halo.a > 0) {
      halo = paint("stroke", style.halo) + " stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    }
    out_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\"{}{}{}{}>{}</text>\n", at.x, at.y,
                        style.size, style.weight == Weight::semibold ? " font-weight=\"600\"" : "", anchor,
                        paint("fill", style.color), halo, escaped(text));
  }

 private:
  static void triangle(PathData& path, std::span<const Pixel> points, const Index3& t) {
    path.move(points[t[0]]);
    path.line(points[t[1]]);
    path.line(points[t[2]]);
    path.close();
  }

  static std::string strokeOf(const LineStyle& style) {
    std::string text = fmt::format("{} stroke-width=\"{:.3g}\"", paint("stroke", style.color), style.width);
    const DashPattern pattern = patternOf(style.dash);
    for (int i = 0; i < pattern.count; ++i) {
      text += fmt::format("{}{:.3g}", i == 0 ? " stroke-dasharray=\"" : " ",
                          static_cast<double>(pattern.lengths[static_cast<std::size_t>(i)]) * dashUnit(style.width));
    }
    return pattern.count > 0 ? text + "\"" : text;
  }

  std::string hatching(Color color) {
    ++hatches_;
    out_ += fmt::format(
        "<pattern id=\"hatch{0}\" width=\"4.24\" height=\"4.24\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(45)\"><path d=\"M.6 0v4.24\"{1} stroke-width=\"1.2\"/></pattern>\n",
        hatches_, paint("stroke", color));
    return fmt::format(" fill=\"url(#hatch{})\"", hatches_);
  }

  void crosses(std::span<const PlacedMark> marks, Color color, double grow) {
    const double size = static_cast<double>(marks.front().size);
    out_ += fmt::format("<path fill=\"none\"{} stroke-width=\"{:.3g}\" d=\"", paint("stroke", color),
                        std::max(1.2, 0.18 * size) + grow);
    PathData path(out_);
    const auto corners = markOutline(Shape::cross);
    for (const PlacedMark& mark : marks) {
      const double reach = static_cast<double>(mark.size) + grow;
      path.move(mark.at + reach * corners[0]);
      path.line(mark.at + reach * corners[1]);
      path.move(mark.at + reach * corners[2]);
      path.line(mark.at + reach * corners[3]);
    }
    out_ += "\"/>\n";
  }

  std::string& out_;
  int clips_ = 0;
  int hatches_ = 0;
};

}  // namespace

std::string svg(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.4g}\" height=\"{1:.4g}\" viewBox=\"0 0 {0:.4g} {1:.4g}\" "
      "font-family=\"Inter, 'DejaVu Sans', 'Helvetica Neue', Arial, sans-serif\" stroke-linecap=\"butt\" "
      "stroke-linejoin=\"round\">\n",
      std::ceil(layout.width), std::ceil(layout.height));
  if (!options.title.empty()) out += "<title>" + escaped(options.title) + "</title>\n";
  SvgCanvas canvas(out);
  drawPicture(scene, camera, layout, options, canvas);
  out += "</svg>\n";
  return out;
}

}  // namespace triscope
