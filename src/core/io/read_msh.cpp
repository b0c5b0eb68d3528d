// Gmsh's ASCII formats 2.2 and 4.1 (Gmsh reference manual, "MSH file format"). Sections that say nothing about
// points, triangles, edges and their groups are skipped.
#include <algorithm>
#include <map>

#include "core/io/plane.h"
#include "core/io/read_mesh.h"

namespace triscope {
namespace {

constexpr long long kAnyTag = 0x7fffffffffff;

class MshReader {
 public:
  explicit MshReader(std::string_view text) : in_(text) {}

  Result<MeshFile> read() {
    in_.expect("$MeshFormat");
    const double version = in_.number("the version");
    const long long binary = in_.integer("the file type", 0, 1);
    in_.integer("the size of a number", 1, 64);
    if (!in_.failed() && binary == 1) in_.fail("the file is binary", "save it as ASCII: gmsh FILE -save -bin 0");
    if (!in_.failed() && version != 2.2 && version != 4.1) {
      in_.fail(fmt::format("version {} is not read", version), "save it as 4.1 or 2.2: gmsh FILE -save -format msh41");
    }
    in_.expect("$EndMeshFormat");
    const bool four = version == 4.1;
    while (!in_.failed() && !in_.atEnd()) readSection(four);
    if (!in_.failed() && !hasNodes_) in_.fail("there is no $Nodes section", "the file holds no mesh");
    finish();
    if (in_.failed()) return in_.error();
    return std::move(file_);
  }

 private:
  /// An edge as read: nodes by index, entity or physical tag not yet resolved.
  struct RawEdge {
    int a;
    int b;
    long long tag;
  };

  void readSection(bool four) {
    const std::string section(in_.word());
    if (section.size() < 2 || section[0] != '$') {
      in_.fail("expected a section such as $Nodes", "the file is damaged");
    } else if (section == "$PhysicalNames") {
      readNames();
    } else if (section == "$Entities" && four) {
      readEntities();
    } else if (section == "$Nodes") {
      if (hasNodes_) in_.fail("a second $Nodes section", "write the mesh into one file of its own");
      four ? readNodes4() : readNodes2();
      hasNodes_ = true;
      sortTags();
    } else if (section == "$Elements") {
      if (!hasNodes_) in_.fail("$Elements comes before $Nodes", "write the file anew");
      four ? readElements4() : readElements2();
    } else {
      const std::string end = "$End" + section.substr(1);
      while (!in_.atEnd() && in_.word() != end) {
      }
      return;
    }
    in_.expect("$End" + section.substr(1));
  }

  void readNames() {
    const std::size_t count = in_.count("the number of names", 6);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      const long long dimension = in_.integer("the dimension of a group", 0, 3);
      const long long tag = in_.integer("the tag of a group", -kAnyTag, kAnyTag);
      const std::string_view line = in_.restOfLine();
      const std::size_t begin = line.find('"'), end = line.rfind('"');
      if (begin == std::string_view::npos || end <= begin)
        in_.fail("the name of a group stands in no quotes", "add them");
      if (dimension == 1 && !in_.failed()) names_[tag] = std::string(line.substr(begin + 1, end - begin - 1));
    }
  }

  void readEntities() {
    const std::size_t counts[4] = {in_.count("points", 8), in_.count("curves", 8), in_.count("surfaces", 8),
                                   in_.count("volumes", 8)};
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < counts[dimension] && !in_.failed(); ++i) {
        const long long tag = in_.integer("the tag of an entity", -kAnyTag, kAnyTag);
        for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) in_.number("the box of an entity");
        const std::size_t physicals = in_.count("the number of physical tags", 2);
        for (std::size_t p = 0; p < physicals && !in_.failed(); ++p) {
          const long long physical = in_.integer("a physical tag", -kAnyTag, kAnyTag);
          if (dimension == 1 && p == 0) physicalOfCurve_[tag] = physical < 0 ? -physical : physical;
        }
        if (dimension == 0) continue;
        const std::size_t bounding = in_.count("the number of bounding entities", 2);
        for (std::size_t b = 0; b < bounding && !in_.failed(); ++b) in_.integer("a bounding entity", -kAnyTag, kAnyTag);
      }
    }
  }

  void addNode(std::size_t index) {
    const double x = in_.number("x"), y = in_.number("y"), z = in_.number("z");
    plane_.take(z, in_);
    file_.points[index] = {x, y};
  }

  void readNodes2() {
    const std::size_t count = in_.count("the number of nodes", 8);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      tags_.emplace_back(in_.integer("the tag of a node", 0, kAnyTag), static_cast<int>(i));
      file_.points.emplace_back();
      addNode(i);
    }
  }

  void readNodes4() {
    const std::size_t blocks = in_.count("the number of blocks", 8);
    const std::size_t total = in_.count("the number of nodes", 8);
    in_.integer("the smallest tag", 0, kAnyTag);
    in_.integer("the largest tag", 0, kAnyTag);
    for (std::size_t block = 0; block < blocks && !in_.failed(); ++block) {
      in_.integer("the dimension of an entity", 0, 3);
      in_.integer("the tag of an entity", -kAnyTag, kAnyTag);
      const long long parametric = in_.integer("whether parameters follow", 0, 1);
      const std::size_t count = in_.count("the number of nodes in a block", 8);
      if (parametric == 1) in_.fail("nodes with parameters are not read", "save without parametric coordinates");
      const std::size_t first = file_.points.size();
      for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
        tags_.emplace_back(in_.integer("the tag of a node", 0, kAnyTag), static_cast<int>(first + i));
        file_.points.emplace_back();
      }
      for (std::size_t i = 0; i < count && !in_.failed(); ++i) addNode(first + i);
    }
    if (!in_.failed() && file_.points.size() != total) {
      in_.fail(fmt::format("{} nodes were announced, {} found", total, file_.points.size()), "the file is damaged");
    }
  }

  void sortTags() {
    std::sort(tags_.begin(), tags_.end());
    for (std::size_t i = 1; i < tags_.size() && !in_.failed(); ++i) {
      if (tags_[i].first == tags_[i - 1].first) {
        in_.fail(fmt::format("two nodes have the tag {}", tags_[i].first), "the file is damaged");
      }
    }
  }

  int node() {
    const long long tag = in_.integer("the tag of a node", 0, kAnyTag);
    const auto found = std::lower_bound(tags_.begin(), tags_.end(), std::pair(tag, -1));
    if (found != tags_.end() && found->first == tag) return found->second;
    in_.fail(fmt::format("there is no node {}", tag), "the file is damaged");
    return 0;
  }

  /// Reads the nodes of one element; what is no point, edge or triangle is an error.
  void element(long long type, long long tag) {
    if (type == 15) {  // a point
      node();
    } else if (type == 1) {
      const int a = node(), b = node();
      edges_.push_back({a, b, tag});
    } else if (type == 2) {
      const int a = node(), b = node(), c = node();
      file_.triangles.push_back({a, b, c});
    } else {
      in_.fail(fmt::format("elements of Gmsh's type {} are not read", type),
               "only points, 2-node edges and 3-node triangles are: mesh in the plane with order 1");
    }
  }

  void readElements2() {
    const std::size_t count = in_.count("the number of elements", 6);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
      in_.integer("the tag of an element", 0, kAnyTag);
      const long long type = in_.integer("the type of an element", 1, 200);
      const std::size_t tags = in_.count("the number of tags", 2);
      long long physical = 0;
      for (std::size_t t = 0; t < tags && !in_.failed(); ++t) {
        const long long tag = in_.integer("a tag", -kAnyTag, kAnyTag);
        if (t == 0) physical = tag;
      }
      element(type, physical);
    }
  }

  void readElements4() {
    const std::size_t blocks = in_.count("the number of blocks", 8);
    in_.count("the number of elements", 4);
    in_.integer("the smallest tag", 0, kAnyTag);
    in_.integer("the largest tag", 0, kAnyTag);
    for (std::size_t block = 0; block < blocks && !in_.failed(); ++block) {
      in_.integer("the dimension of an entity", 0, 3);
      const long long entity = in_.integer("the tag of an entity", -kAnyTag, kAnyTag);
      const long long type = in_.integer("the type of an element", 1, 200);
      const std::size_t count = in_.count("the number of elements in a block", 4);
      const auto physical = physicalOfCurve_.find(entity);
      for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
        in_.integer("the tag of an element", 0, kAnyTag);
        element(type, physical != physicalOfCurve_.end() ? physical->second : -entity);
      }
    }
  }

  /// Groups in the order of their tags: named ones by name, others by number; curves without a group come first.
  void finish() {
    std::map<long long, int> groups;
    for (const RawEdge& edge : edges_) groups.emplace(edge.tag, 0);
    for (auto& [tag, group] : groups) {
      group = static_cast<int>(file_.groups.size());
      const auto name = names_.find(tag);
      file_.groups.push_back(name != names_.end() ? name->second
                             : tag < 0            ? fmt::format("curve {}", -tag)
                                                  : fmt::format("group {}", tag));
    }
    for (const RawEdge& edge : edges_) file_.edges.push_back({edge.a, edge.b, groups.at(edge.tag)});
  }

  TextScanner in_;
  PlaneCheck plane_;
  MeshFile file_;
  bool hasNodes_ = false;
  std::map<long long, std::string> names_;          // of physical curves
  std::map<long long, long long> physicalOfCurve_;  // entity to physical tag
  std::vector<std::pair<long long, int>> tags_;     // node tag and index, sorted
  std::vector<RawEdge> edges_;
};

}  // namespace

Result<MeshFile> parseMsh(std::string_view text) { return MshReader(text).read(); }

}  // namespace triscope
