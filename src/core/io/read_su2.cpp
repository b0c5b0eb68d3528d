// SU2's native format: "KEY= value" lines, some followed by that many lines of numbers; '%' starts a comment. Triangles
// and the markers' lines are taken; what other keys say is passed over.
#include <algorithm>

#include "core/base/text_scanner.h"
#include "core/io/read_mesh.h"

namespace triscope {
namespace {

constexpr long long kPoint = 1;  // VTK's cell types
constexpr long long kLine = 3;
constexpr long long kTriangle = 5;

class Su2Reader {
 public:
  explicit Su2Reader(std::string_view text) : in_(text, '%') {}

  Result<MeshFile> read() {
    while (!in_.failed() && !in_.atEnd()) readKey();
    if (!in_.failed()) checkIndices();
    if (in_.failed()) return in_.error();
    return std::move(file_);
  }

 private:
  /// The value of "KEY= value", "KEY=value" or "KEY = value"; `first` is the word that begins with the key.
  TextScanner valueAfter(std::string_view first) {
    const std::size_t line = in_.line();
    const std::string_view rest = in_.restOfLine();
    const std::size_t begin = first.find('=');
    if (begin == std::string_view::npos) {
      const std::size_t equals = rest.find('=');
      if (equals == std::string_view::npos) {
        in_.fail("expected KEY= and a value", "correct the file or write it anew");
        return TextScanner({});
      }
      return TextScanner(rest.substr(equals + 1), '%', line);
    }
    // The value begins in the same word or after it; both are one stretch of the text.
    const std::size_t length = static_cast<std::size_t>(rest.data() + rest.size() - first.data());
    return TextScanner(std::string_view(first.data(), length).substr(begin + 1), '%', line);
  }

  long long integerOf(TextScanner& value, std::string_view what, long long lowest, long long highest) {
    const long long number = value.integer(what, lowest, highest);
    if (value.failed()) failWith(value);
    return number;
  }

  /// How many lines follow; a false claim reserves no memory.
  std::size_t countOf(TextScanner& value, std::string_view what, std::size_t bytes) {
    const auto count = static_cast<std::size_t>(integerOf(value, what, 0, TextScanner::kMost));
    if (in_.failed() || count <= in_.rest().size() / bytes + 1) return count;
    in_.fail(fmt::format("{} is {}, more than the rest of the file can hold", what, count), "the file is cut short");
    return 0;
  }

  void expectOnly(TextScanner& value, std::string_view what, long long only, std::string hint) {
    const long long number = integerOf(value, what, 0, TextScanner::kMost);
    if (!in_.failed() && number != only) in_.fail(fmt::format("{} is {}", what, number), std::move(hint));
  }

  void failWith(const TextScanner& value) {
    Error error = value.error();
    const std::size_t colon = error.message.find(": ");  // the scanner of the file says the line again
    in_.fail(colon == std::string::npos ? error.message : error.message.substr(colon + 2), error.hint);
  }

  void readKey() {
    const std::string_view word = in_.word();
    const std::string_view key = word.substr(0, word.find('='));
    TextScanner value = valueAfter(word);
    if (in_.failed()) return;
    if (key == "NDIME") expectOnly(value, "the number of dimensions", 2, "only plane meshes are read");
    if (key == "NZONE") expectOnly(value, "the number of zones", 1, "write each zone into a file of its own");
    if (key == "NPOIN") readPoints(countOf(value, "the number of points", 4));
    if (key == "NELEM") readTriangles(countOf(value, "the number of elements", 8));
    if (key == "MARKER_TAG") file_.groups.emplace_back(value.word());
    if (key == "MARKER_ELEMS") readEdges(countOf(value, "the number of elements of the marker", 4));
  }

  void readPoints(std::size_t count) {
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      const double x = in_.number("x"), y = in_.number("y");
      in_.restOfLine();  // the number of the point may follow
      file_.points.push_back({x, y});
    }
  }

  int pointNumber() { return static_cast<int>(in_.integer("the number of a point", 0, TextScanner::kMost)); }

  void readTriangles(std::size_t count) {
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      const long long type = in_.integer("the type of an element", 0, 255);
      if (type == kTriangle) {
        std::array<int, 3> t{};
        for (int& v : t) v = pointNumber();
        file_.triangles.push_back(t);
      } else if (!in_.failed() && type != kLine) {
        in_.fail(fmt::format("elements of VTK's type {} are not read", type), "only triangles are, beside lines");
      }
      in_.restOfLine();  // the number of the element may follow
    }
  }

  void readEdges(std::size_t count) {
    if (!in_.failed() && file_.groups.empty()) in_.fail("MARKER_ELEMS without a MARKER_TAG", "the file is damaged");
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      const long long type = in_.integer("the type of an element", 0, 255);
      if (type == kLine) {
        const int a = pointNumber(), b = pointNumber();
        file_.edges.push_back({a, b, static_cast<int>(file_.groups.size()) - 1});
      } else if (!in_.failed() && type != kPoint) {
        in_.fail(fmt::format("a marker has an element of VTK's type {}", type), "markers of a plane mesh are lines");
      }
      in_.restOfLine();
    }
  }

  /// Points may come after what names them.
  void checkIndices() {
    if (file_.points.empty()) return in_.fail("there are no points", "the file holds no mesh");
    const auto check = [&](int v) {
      if (static_cast<std::size_t>(v) < file_.points.size()) return;
      in_.fail(fmt::format("an element has the corner {}, but the points are 0 to {}", v, file_.points.size() - 1),
               "the file is damaged");
    };
    for (const auto& t : file_.triangles) std::for_each(t.begin(), t.end(), check);
    for (const MeshFile::Edge& edge : file_.edges) {
      check(edge.a);
      check(edge.b);
    }
  }

  TextScanner in_;
  MeshFile file_;
};

}  // namespace

Result<MeshFile> parseSu2(std::string_view text) { return Su2Reader(text).read(); }

}  // namespace triscope
