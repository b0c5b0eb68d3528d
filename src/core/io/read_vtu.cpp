// VTK's XML unstructured grid with ASCII arrays, as ParaView, meshio and Triscope write it. A scan for the tags that
// matter, not an XML parser: one piece, triangles; vertices and lines are passed over.
#include <algorithm>

#include "core/io/plane.h"
#include "core/io/read_mesh.h"

namespace triscope {
namespace {

/// A start tag, with where the text between it and its end begins and ends.
struct Element {
  std::string_view attributes;
  std::string_view content;
  std::size_t line = 1;
};

/// The value of an attribute, "" when there is none.
std::string_view attribute(std::string_view attributes, std::string_view name) {
  for (std::size_t at = attributes.find(name); at != std::string_view::npos; at = attributes.find(name, at + 1)) {
    const std::size_t equals = at + name.size();
    const bool whole = at > 0 && std::isspace(static_cast<unsigned char>(attributes[at - 1])) != 0;
    if (!whole || equals + 1 >= attributes.size() || attributes[equals] != '=') continue;
    const char quote = attributes[equals + 1];
    if (quote != '"' && quote != '\'') continue;
    const std::size_t end = attributes.find(quote, equals + 2);
    if (end == std::string_view::npos) return {};
    return attributes.substr(equals + 2, end - equals - 2);
  }
  return {};
}

class VtuReader {
 public:
  explicit VtuReader(std::string_view text) : text_(text) {}

  Result<MeshFile> read() {
    const auto grid = first({{}, text_, 1}, "UnstructuredGrid");
    if (!grid) return problem(1, "there is no <UnstructuredGrid>", "only .vtu files of unstructured grids are read");
    const auto piece = first(*grid, "Piece");
    if (!piece) return problem(grid->line, "there is no <Piece>", "the file holds no mesh");
    const auto points = first(*piece, "Points");
    const auto cells = first(*piece, "Cells");
    if (!points || !cells) return problem(piece->line, "<Points> or <Cells> is missing", "the file is damaged");

    const auto coordinates = first(*points, "DataArray");
    if (!coordinates) return problem(points->line, "<Points> holds no <DataArray>", "the file is damaged");
    if (auto failed = readPoints(*coordinates)) return *failed;
    if (auto failed = readCells(*cells)) return *failed;
    if (const auto data = first(*piece, "CellData")) {
      if (auto failed = readFields(*data)) return *failed;
    }
    return std::move(file_);
  }

 private:
  using Failure = std::optional<Error>;

  static Error problem(std::size_t line, std::string_view message, std::string hint) {
    return {.message = fmt::format("line {}: {}", line, message), .hint = std::move(hint), .file = {}, .loop = {}};
  }

  /// How far a search through a text has come, and how many line ends it has passed.
  struct Place {
    std::size_t offset = 0;
    std::size_t lines = 0;
    void moveTo(std::size_t next, std::string_view text) {
      const std::string_view passed = text.substr(offset, next - offset);
      lines += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
      offset = next;
    }
  };

  /// The next element of that name in `parent` after `place`, which moves past it.
  static std::optional<Element> next(const Element& parent, std::string_view name, Place& place) {
    const std::string_view text = parent.content;
    const std::string open = "<" + std::string(name);
    std::size_t tag = place.offset;
    for (;; tag += open.size()) {
      tag = text.find(open, tag);
      if (tag == std::string_view::npos) return std::nullopt;
      const char after = tag + open.size() < text.size() ? text[tag + open.size()] : '\0';
      if (after == '>' || after == '/' || std::isspace(static_cast<unsigned char>(after)) != 0) break;
    }
    const std::size_t close = text.find('>', tag);
    if (close == std::string_view::npos) return std::nullopt;
    place.moveTo(close + 1, text);
    Element element;
    element.line = parent.line + place.lines;
    element.attributes = text.substr(tag + open.size(), close - tag - open.size());
    if (element.attributes.ends_with('/')) return element;
    const std::string shut = "</" + std::string(name);
    const std::size_t end = text.find(shut, close);
    if (end == std::string_view::npos) return std::nullopt;
    element.content = text.substr(close + 1, end - close - 1);
    place.moveTo(end + shut.size(), text);
    return element;
  }
  static std::optional<Element> first(const Element& parent, std::string_view name) {
    Place start;
    return next(parent, name, start);
  }

  static Failure checkAscii(const Element& array) {
    const std::string_view format = attribute(array.attributes, "format");
    if (format == "ascii" || format.empty()) return std::nullopt;
    return problem(array.line, fmt::format("the data are {}", format.substr(0, 20)), "save the file with ASCII data");
  }

  Failure readPoints(const Element& array) {
    if (auto failed = checkAscii(array)) return failed;
    if (attribute(array.attributes, "NumberOfComponents") != "3") {
      return problem(array.line, "points need three components", "correct the file or write it anew");
    }
    TextScanner in(array.content, 0, array.line);
    PlaneCheck plane;
    while (!in.failed() && !in.atEnd()) {
      const double x = in.number("x"), y = in.number("y");
      plane.take(in.number("z"), in);
      file_.points.push_back({x, y});
    }
    return in.failed() ? Failure(in.error()) : std::nullopt;
  }

  static Failure readIntegers(const Element& array, long long highest, std::vector<long long>& values) {
    if (auto failed = checkAscii(array)) return failed;
    TextScanner in(array.content, 0, array.line);
    while (!in.failed() && !in.atEnd()) values.push_back(in.integer("a value", 0, highest));
    return in.failed() ? Failure(in.error()) : std::nullopt;
  }

  Failure readCells(const Element& cells) {
    std::vector<long long> corners, ends, types;
    Place place;
    while (const auto array = next(cells, "DataArray", place)) {
      const std::string_view name = attribute(array->attributes, "Name");
      Failure failed;
      if (name == "connectivity")
        failed = readIntegers(*array, static_cast<long long>(file_.points.size()) - 1, corners);
      if (name == "offsets") failed = readIntegers(*array, static_cast<long long>(TextScanner::kMost) * 4, ends);
      if (name == "types") failed = readIntegers(*array, 255, types);
      if (failed) return failed;
    }
    if (ends.size() != types.size() ||
        (ends.empty() ? !corners.empty() : ends.back() != static_cast<long long>(corners.size()))) {
      return problem(cells.line, "connectivity, offsets and types do not fit together", "the file is damaged");
    }
    for (std::size_t i = 0, begin = 0; i < types.size(); ++i) {
      const auto end = static_cast<std::size_t>(ends[i]);
      if (end < begin || end > corners.size())
        return problem(cells.line, "the offsets do not increase", "the file is damaged");
      isTriangle_.push_back(types[i] == 5);
      if (types[i] == 5) {
        if (end - begin != 3) return problem(cells.line, "a triangle without three corners", "the file is damaged");
        file_.triangles.push_back({static_cast<int>(corners[begin]), static_cast<int>(corners[begin + 1]),
                                   static_cast<int>(corners[begin + 2])});
      } else if (types[i] != 1 && types[i] != 3) {
        return problem(cells.line, fmt::format("cells of VTK's type {} are not read", types[i]),
                       "only triangles are, beside points and lines");
      }
      begin = end;
    }
    return std::nullopt;
  }

  /// Arrays of one number per cell; others are passed over.
  Failure readFields(const Element& data) {
    Place place;
    while (const auto array = next(data, "DataArray", place)) {
      const std::string_view components = attribute(array->attributes, "NumberOfComponents");
      if ((!components.empty() && components != "1") || checkAscii(*array)) continue;
      TextScanner in(array->content, 0, array->line);
      MeshFile::Field field{std::string(attribute(array->attributes, "Name")), {}};
      for (const bool triangle : isTriangle_) {
        const double value = in.number("a value");
        if (triangle) field.values.push_back(value);
        if (in.failed()) return in.error();
      }
      file_.fields.push_back(std::move(field));
    }
    return std::nullopt;
  }

  std::string_view text_;
  MeshFile file_;
  std::vector<bool> isTriangle_;  // per cell of the file
};

}  // namespace

Result<MeshFile> parseVtu(std::string_view text) { return VtuReader(text).read(); }

}  // namespace triscope
