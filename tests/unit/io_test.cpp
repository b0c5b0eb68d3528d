// Mesh files: what is written reads back the same, what is broken is named, nothing is left half written.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/io/mesh_from.h"
#include "core/io/read_mesh.h"
#include "core/io/write_mesh.h"
#include "core/mesh/validate.h"
#include "core/quality/quality.h"

namespace triscope::io_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class MeshFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "triscope-io-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t filesLeft() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }
  static void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  fs::path folder_;
};

/// A square ring: eight points, eight triangles; coordinates that need all their digits.
MeshFile ring() {
  MeshFile file;
  const double s = 1.0 / 3.0;
  file.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-s, -s}, {s, -s}, {s, s}, {-s, 0.1 + 0.2}};
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    file.triangles.push_back({i, next, 4 + i});
    file.triangles.push_back({next, 4 + next, 4 + i});
    file.edges.push_back({i, next, 0});
  }
  for (int i = 0; i < 4; ++i) file.edges.push_back({4 + (i + 1) % 4, 4 + i, 1});
  file.groups = {"outer", "main wing"};
  file.holes = {{0, 0}};
  file.fields = {{"aspect", {2, 2.5, 1e-300, 4, 5, 6, 7, 0.1}}};
  return file;
}

MeshFile onlyTriangles(MeshFile file) {
  return {.points = file.points, .triangles = file.triangles, .edges = {}, .groups = {}, .holes = {}, .fields = {}};
}

TEST_F(MeshFiles, WhatIsWrittenReadsBackTheSame) {
  const MeshFile file = ring();
  MeshFile msh = file;
  msh.holes.clear();
  msh.fields.clear();
  MeshFile vtu = onlyTriangles(file);
  vtu.fields = file.fields;
  MeshFile node = file;
  node.fields.clear();
  node.groups = {"marker 1", "marker 2"};
  MeshFile su2 = msh;
  su2.groups = {"outer", "main_wing"};
  const std::pair<const char*, MeshFile> cases[] = {{"a.msh", msh},
                                                    {"a.vtu", vtu},
                                                    {"a.node", node},
                                                    {"a.su2", su2},
                                                    {"a.off", onlyTriangles(file)},
                                                    {"a.obj", onlyTriangles(file)}};
  for (const auto& [name, expected] : cases) {
    const Status written = writeMesh(path(name), file);
    ASSERT_TRUE(written.ok()) << written.error().message;
    const auto read = readMesh(path(name));
    ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
    EXPECT_EQ(*read, expected) << name;
  }
  ASSERT_TRUE(writeMesh(path("b.msh"), file, {.msh2 = true}).ok());
  EXPECT_TRUE(contents(path("b.msh")).starts_with("$MeshFormat\n2.2 0 8\n"));
  EXPECT_TRUE(contents(path("a.msh")).starts_with("$MeshFormat\n4.1 0 8\n"));
  EXPECT_EQ(*readMesh(path("b.msh")), msh);
  EXPECT_EQ(*readMesh(path("a.ele")), node);
}

TEST_F(MeshFiles, Su2HoldsMarkersByName) {
  ASSERT_TRUE(writeMesh(path("a.su2"), ring()).ok());
  const std::string text = contents(path("a.su2"));
  EXPECT_TRUE(text.starts_with("NDIME= 2\nNELEM= 8\n5 0 1 4 0\n"));
  EXPECT_NE(text.find("NPOIN= 8\n-1 -1 0\n"), std::string::npos);
  EXPECT_NE(text.find("NMARK= 2\nMARKER_TAG= outer\nMARKER_ELEMS= 4\n3 0 1\n"), std::string::npos);
  EXPECT_NE(text.find("MARKER_TAG= main_wing\nMARKER_ELEMS= 4\n3 5 4\n"), std::string::npos);
}

TEST_F(MeshFiles, Su2IsReadInAnyOrderAndSpacing) {
  const auto file = parseSu2(
      "% a mesh\nNZONE=1\nNDIME = 2 % plane\nNMARK=1\nMARKER_TAG=wall\nMARKER_ELEMS= 2\n3 0 1\n1 0\n"
      "NPOIN= 4 4\n0 0\n1 0 1\n1 1 2\n0 1 3\nNCORNERS= 0\nNELEM= 3\n5 0 1 2\n3 0 1\n5 0 2 3 1\n");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file->points.size(), 4u);
  EXPECT_EQ(file->triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(file->edges, (std::vector<MeshFile::Edge>{{0, 1, 0}}));
  EXPECT_EQ(file->groups, std::vector<std::string>{"wall"});
}

TEST_F(MeshFiles, Su2SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no points"},
      {"NDIME= 3\n", "line 1: the number of dimensions is 3"},
      {"NDIME= 2\nNZONE= 2\n", "line 2: the number of zones is 2"},
      {"nonsense\n", "line 1: expected KEY="},
      {"NPOIN= 400000000\n0 0\n", "more than the rest of the file can hold"},
      {"NPOIN= x\n", "line 1: expected a whole number"},
      {"NPOIN= 1\n0 y\n", "line 2: expected a number for y"},
      {"NPOIN= 3\n0 0\n1 0\n0 1\nNELEM= 1\n9 0 1 2 3\n", "type 9 are not read"},
      {"NPOIN= 3\n0 0\n1 0\n0 1\nNELEM= 1\n5 0 1 3\n", "the corner 3, but the points are 0 to 2"},
      {"NPOIN= 3\n0 0\n1 0\n0 1\n5 0 1 2\n", "line 5: expected KEY="},
      {"NPOIN= 1\n0 0\nMARKER_ELEMS= 1\n3 0 0\n", "without a MARKER_TAG"}};
  for (const auto& [text, part] : cases) {
    const auto file = parseSu2(text);
    ASSERT_FALSE(file.ok()) << text;
    EXPECT_NE(file.error().message.find(part), std::string::npos) << file.error().message;
    EXPECT_FALSE(file.error().hint.empty());
  }
}

TEST_F(MeshFiles, VtuHoldsTheLoopOfEachPoint) {
  ASSERT_TRUE(writeMesh(path("a.vtu"), ring()).ok());
  EXPECT_NE(contents(path("a.vtu")).find("Name=\"boundary\" format=\"ascii\">\n1\n1\n1\n1\n2\n2\n2\n2\n</DataArray>"),
            std::string::npos);
}

TEST_F(MeshFiles, TheSameMeshGivesTheSameBytes) {
  for (const char* name : {"a.msh", "a.vtu", "a.node", "a.su2", "a.off", "a.obj"}) {
    ASSERT_TRUE(writeMesh(path(name), ring()).ok());
    const std::string first = contents(path(name));
    ASSERT_TRUE(writeMesh(path(name), ring()).ok());
    EXPECT_EQ(contents(path(name)), first) << name;
    EXPECT_FALSE(first.empty());
  }
  EXPECT_EQ(filesLeft(), 8u);  // with .ele and .poly, and no temporary file
}

TEST_F(MeshFiles, AnUnknownExtensionNamesTheKnownOnes) {
  const Status written = writeMesh(path("a.stl"), ring());
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::usage);
  EXPECT_EQ(written.error().message, "no mesh format has the extension '.stl'");
  EXPECT_EQ(written.error().hint, "known are .msh, .vtu, .node, .su2, .off, .obj");
  EXPECT_EQ(readMesh(path("a.stl")).error().hint, "known are .msh, .vtu, .node, .ele, .su2, .off, .obj");
  EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(MeshFiles, AllFilesOfAFormatOrNone) {
  put(path("a.node"), "old");
  fs::create_directory(path("a.poly"));  // the last of the three cannot be written
  const Status written = writeMesh(path("a.node"), ring());
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::cannot_write);
  EXPECT_EQ(contents(path("a.node")), "old");
  EXPECT_EQ(filesLeft(), 2u);
}

TEST_F(MeshFiles, AFolderThatIsMissingIsSaid) {
  const Status written = writeMesh(path("none/a.msh"), ring());
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::cannot_write);
  EXPECT_EQ(written.error().file, path("none/a.msh"));
  EXPECT_NE(written.error().hint.find("does not exist"), std::string::npos);
  EXPECT_EQ(readMesh(path("none/a.msh")).error().kind, ErrorKind::no_input);
  EXPECT_EQ(readMesh(folder_.string() + "/.msh").error().kind, ErrorKind::usage);
}

struct Broken {
  const char* what;
  Result<MeshFile> (*parse)(std::string_view);
  const char* text;
  const char* message;  // part of it
};

Result<MeshFile> parseNode(std::string_view text) { return parseTriangle(text, "1 3 0\n1 1 2 3\n", ""); }
Result<MeshFile> parseEle(std::string_view text) { return parseTriangle("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", text, ""); }
Result<MeshFile> parsePoly(std::string_view text) {
  return parseTriangle("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "1 3 0\n1 1 2 3\n", text);
}

#define MSH2 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
#define MSH4 "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
#define GRID(points, connectivity, offsets, types)                                                       \
  "<VTKFile><UnstructuredGrid><Piece>\n<Points><DataArray NumberOfComponents='3'>" points                \
  "</DataArray></Points>\n"                                                                              \
  "<Cells><DataArray Name='connectivity'>" connectivity "</DataArray><DataArray Name='offsets'>" offsets \
  "</DataArray><DataArray Name='types'>" types "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"

const Broken kBroken[] = {
    {"empty", parseMsh, "", "the file ends where $MeshFormat was expected"},
    {"other", parseMsh, "solid\n", "line 1: expected '$MeshFormat'"},
    {"binary", parseMsh, "$MeshFormat\n4.1 1 8\n", "line 2: the file is binary"},
    {"version", parseMsh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n", "version 4 is not read"},
    {"no nodes", parseMsh, MSH2, "there is no $Nodes section"},
    {"count", parseMsh, MSH2 "$Nodes\n999999999999\n", "line 5: the number of nodes is 999999999999, outside"},
    {"claim", parseMsh, MSH2 "$Nodes\n9999999\n1 0 0 0\n", "more than the rest of the file can hold"},
    {"not a number", parseMsh, MSH2 "$Nodes\n1\n1 0 x 0\n", "line 6: expected a number for y, found 'x'"},
    {"nan", parseMsh, MSH2 "$Nodes\n1\n1 0 nan 0\n", "found 'nan'"},
    {"cut", parseMsh, MSH2 "$Nodes\n2\n1 0 0 0\n2 1 0 0", "the file ends where $EndNodes"},
    {"twin", parseMsh, MSH2 "$Nodes\n2\n7 0 0 0\n7 1 0 0\n$EndNodes\n", "two nodes have the tag 7"},
    {"space", parseMsh, MSH2 "$Nodes\n2\n1 0 0 0\n2 1 0 3\n$EndNodes\n", "line 7: the mesh leaves the plane"},
    {"no node", parseMsh, MSH2 "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 1 0 1 2\n", "there is no node 2"},
    {"quads", parseMsh, MSH2 "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 3 0 1 1 1 1\n", "Gmsh's type 3"},
    {"early", parseMsh, MSH2 "$Elements\n1\n", "$Elements comes before $Nodes"},
    {"parametric", parseMsh, MSH4 "$Nodes\n1 1 1 1\n2 1 1 1\n1\n0 0 0 0 0\n", "parameters are not read"},
    {"total", parseMsh, MSH4 "$Nodes\n1 2 1 2\n2 1 0 1\n1\n0 0 0\n$EndNodes\n", "2 nodes were announced, 1 found"},
    {"no grid", parseVtu, "<VTKFile/>", "there is no <UnstructuredGrid>"},
    {"no piece", parseVtu, "<UnstructuredGrid>\n</UnstructuredGrid>", "there is no <Piece>"},
    {"appended", parseVtu,
     "<UnstructuredGrid><Piece><Points><DataArray NumberOfComponents='3' "
     "format='appended'/></Points><Cells></Cells></Piece></UnstructuredGrid>",
     "the data are appended"},
    {"corner", parseVtu, GRID("0 0 0 1 0 0 0 1 0", "0 1 3", "3", "5"), "a value is 3, outside 0 to 2"},
    {"offsets", parseVtu, GRID("0 0 0 1 0 0 0 1 0", "0 1 2", "4", "5"), "do not fit together"},
    {"backwards", parseVtu, GRID("0 0 0 1 0 0 0 1 0", "0 1 2 0 1 2", "7 6", "5 5"), "the offsets do not increase"},
    {"two corners", parseVtu, GRID("0 0 0 1 0 0 0 1 0", "0 1", "2", "5"), "a triangle without three corners"},
    {"polygons", parseVtu, GRID("0 0 0 1 0 0 0 1 0", "0 1 2", "3", "7"), "VTK's type 7"},
    {"cut", parseVtu, GRID("0 0", "", "", ""), "line 2: the file ends where z was expected"},
    {"space", parseNode, "1 3 0 0\n1 0 0 0\n", ".node file, line 1: expected '2'"},
    {"order", parseNode, "2 2 0 0\n1 0 0\n3 0 1\n", "not numbered in order"},
    {"start", parseNode, "1 2 0 0\n5 0 0\n", "neither 0 nor 1"},
    {"none", parseNode, "0 2 0 0\n", "there are no nodes"},
    {"corner", parseEle, "1 3 0\n1 0 1 3\n", ".ele file, line 2: the number of a node is 3, outside 0 to 2"},
    {"six", parseEle, "1 6 0\n1 0 1 2 0 1 2\n", "six nodes"},
    {"own nodes", parsePoly, "4 2 0 0\n", ".poly file, line 1: it lists nodes"},
    {"segment", parsePoly, "0 2 0 1\n1 1\n1 1 9 1\n0\n", "the number of a node is 9"},
    {"word", parseOff, "NOFF\n", "expected 'OFF'"},
    {"quad", parseOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n", "line 6: a face has 4 corners"},
    {"index", parseOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "the number of a point is -1"},
    {"quad", parseObj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 1\n", "line 4: a face has more than three corners"},
    {"later", parseObj, "v 0 0 0\nf 1 2 3\n", "names a point that does not come before it"},
    {"zero", parseObj, "v 0 0 0\nf 0 1 1\n", "names a point that does not come before it"},
    {"none", parseObj, "# nothing\n", "there are no points"},
};

TEST(BrokenMeshFiles, AreRefusedWithTheLineAndTheReason) {
  for (const Broken& broken : kBroken) {
    const auto read = broken.parse(broken.text);
    ASSERT_FALSE(read.ok()) << broken.what << ": " << broken.message;
    EXPECT_NE(read.error().message.find(broken.message), std::string::npos)
        << broken.what << ": " << read.error().message;
    EXPECT_FALSE(read.error().hint.empty()) << broken.what;
    EXPECT_EQ(read.error().kind, ErrorKind::bad_data);
  }
}

TEST(BrokenMeshFiles, EveryPrefixIsReadOrRefused) {
  const std::string text = MSH4
      "$PhysicalNames\n1\n1 1 \"rim\"\n$EndPhysicalNames\n$Entities\n0 1 1 0\n1 0 0 0 1 1 0 1 1 0\n1 0 0 0 1 1 0 0 1 "
      "1\n"
      "$EndEntities\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n$Elements\n2 2 1 2\n1 1 1 1\n"
      "1 1 2\n2 1 2 1\n2 1 2 3\n$EndElements\n";
  ASSERT_TRUE(parseMsh(text).ok());
  EXPECT_EQ(parseMsh(text)->groups, std::vector<std::string>{"rim"});
  for (std::size_t n = 0; n < text.size(); ++n) {
    const auto read = parseMsh(text.substr(0, n));
    if (read) continue;
    EXPECT_FALSE(read.error().message.empty());
  }
}

TEST(ReadMesh, GmshFilesWithOtherSectionsAndScatteredTags) {
  const auto read = parseMsh(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nanything $Nodes\n$EndComments\n"
      "$Nodes\n3\n100 0 0 5\n7 1 0 5\n50 0 1 5\n$EndNodes\n"
      "$Elements\n3\n1 15 2 0 1 100\n2 1 2 9 4 100 7\n3 2 2 0 1 100 7 50\n$EndElements\n");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
  EXPECT_EQ(read->edges, (std::vector<MeshFile::Edge>{{0, 1, 0}}));
  EXPECT_EQ(read->groups, std::vector<std::string>{"group 9"});
}

TEST(ReadMesh, ObjCountsBackFromTheLastPoint) {
  const auto read = parseObj("o thing\nv 0 0 0\nv 1 0 0 1.0\nvn 0 0 1\nv 0 1 0\nf -3//1 2/1 3/1/1\n");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
}

TEST(MeshFrom, AFileMakesASoundMesh) {
  MeshFile file = ring();
  const auto mesh = meshFrom(file);
  ASSERT_TRUE(mesh.ok());
  for (const Violation& v : validate(*mesh)) EXPECT_EQ(v.what, triscope::Broken::delaunay) << v.message;
  const Quality q = measure(*mesh);
  EXPECT_EQ(q.vertices, 8u);
  EXPECT_EQ(q.triangles, 8u);
  EXPECT_EQ(q.boundaryVertices, 8u);
  EXPECT_EQ(mesh->edges.size(), 8u);
  EXPECT_EQ(mesh->edges[EdgeId(5)].curve, 1u);
}

TEST(MeshFrom, BordersNeedNotBeListed) {
  const auto mesh = meshFrom(onlyTriangles(ring()));
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->edges.size(), 8u);
  for (const Violation& v : validate(*mesh)) EXPECT_EQ(v.what, triscope::Broken::delaunay) << v.message;
}

TEST(MeshFrom, SaysWhatItChanged) {
  MeshFile file = ring();
  std::swap(file.triangles[0][1], file.triangles[0][2]);
  file.points.push_back({9, 9});
  file.edges.push_back({0, 2, 0});
  std::vector<std::string> notes;
  const auto mesh = meshFrom(file, &notes);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(notes, (std::vector<std::string>{"1 triangle clockwise in the file, turned round",
                                             "1 point used by no triangle, left out",
                                             "1 edge listed in the file but no edge of a triangle, left out"}));
  EXPECT_EQ(measure(*mesh).vertices, 8u);
  notes.clear();
  ASSERT_TRUE(meshFrom(ring(), &notes).ok());
  EXPECT_TRUE(notes.empty());
}

TEST(MeshFrom, RefusesWhatIsNoPlaneMesh) {
  EXPECT_EQ(meshFrom(MeshFile{}).error().message, "there are no triangles");
  MeshFile file = onlyTriangles(ring());
  file.triangles.push_back({0, 0, 1});
  EXPECT_EQ(meshFrom(file).error().message, "triangle 8 has the corners 0, 0, 1");
  file.triangles.back() = {0, 1, 6};
  const auto sameSide = meshFrom(file);
  ASSERT_FALSE(sameSide.ok());
  EXPECT_EQ(sameSide.error().message, "triangles 0 and 8 lie on the same side of edge 0-1");
  EXPECT_EQ(sameSide.error().at, (Point{0, -1}));
  file.triangles.back() = {1, 4, 6};
  EXPECT_EQ(meshFrom(file).error().message, "edge 1-4 belongs to 3 triangles");
}

}  // namespace
}  // namespace triscope::io_test
