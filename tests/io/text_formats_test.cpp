// OBJ, OFF and STL beyond the files of tests/data/io.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

std::vector<Triangle> triangles(std::initializer_list<std::array<int, 3>> corners) {
  std::vector<Triangle> result;
  for (const auto& t : corners) result.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  return result;
}

class TextFormats : public testing::Test {
 protected:
  std::string message(const std::string& name, const std::string& content) const {
    const auto path = folder.write(name, content);
    return message_of<FileError>(path, [&] { read_mesh(path); });
  }
  TriangleMesh read(const std::string& name, const std::string& content) const {
    return read_mesh(folder.write(name, content));
  }

  TemporaryFolder folder;
};

TEST_F(TextFormats, ObjCornersAndCommentsAndContinuation) {
  const TriangleMesh mesh = read("a.obj",
                                 "# v 9 9 9\\\nvn 0 0 1\nvt 0 0\nv 0 0 0 # origin\n"
                                 "v 1 0 \\\n0 1.0\nv 0 1 0 0.5 nan 0.5\n"
                                 "f 1/1 2/1/1 3//1 # \\\nf -3 -1 \\\n -2\nf 4 2 1\nv 2 2 2");
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {0, 2, 1}, {3, 1, 0}}));
}

TEST_F(TextFormats, ObjCommentsOnLinesThatContinueOthers) {
  const TriangleMesh mesh = read("a.obj",
                                 "v 0 \\\n0 0 # origin\nv 1 0 0\nv 0 1 0\n"
                                 "f 1 \\\n2 \\\n3 # a comment \\\nf \\\n# 9\nf 3 2 1#\n");
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {2, 1, 0}}));
}

TEST_F(TextFormats, ObjNamesTheLineWhereAStatementBegins) {
  EXPECT_EQ(message("a.obj", "v 0 0 0\n\nv 0 \\\n1 \\\n\n"),
            ":3: a vertex needs three numbers, found the end of the line; correct this line");
  EXPECT_EQ(
      message("a.obj", "v 0 0 0\nf 1 1 -2\n"),
      ":2: face 0 has the corner -1 (both counted from 0), but there are 1 vertices; the file "
      "is damaged or incomplete");
  EXPECT_EQ(message("a.obj", "v 0 0 0\nv 0 inf 0\r\nv 0 0 0\n"),
            ":2: point 1 (counted from 0) has a coordinate that is not a finite number; remove or "
            "repair such points");
  EXPECT_EQ(message("a.obj", "v 0 0 0\nf 1 2x 3\n"),
            ":2: a corner of a face is '2x', not i, i/t, i//n or i/t/n with indices from 1 or -1 "
            "on; correct this line");
}

TEST_F(TextFormats, ObjIsContinuedBeforeBlanksAtTheEndOfALine) {
  const TriangleMesh mesh =
      read("a.obj", "v 0 0 \\ \n0\nv 1 0 0\nv 0 \\\t\r\n1 0\nf 1 2 \\  \n3\n");
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}}));
}

// As programs for Windows write the names of folders.
TEST_F(TextFormats, ObjNamesThatEndWithABackslashTakeNoVertexAway) {
  const TriangleMesh mesh =
      read("a.obj", "o C:\\parts\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng C:\\\nf 1 2 3\n");
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}}));
}

TEST_F(TextFormats, ObjFacesByTheirOldKeyword) {
  const TriangleMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\nfoo 3 2 1\n");
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}}));
}

TEST_F(TextFormats, NotFiniteAsOldLibrariesPrintIt) {
  const std::string not_finite = ": point 0 (counted from 0) has a coordinate that is not a finite";
  EXPECT_TRUE(message("a.obj", "v 0 0 1.#QNAN # c\n").starts_with(":1" + not_finite));
  EXPECT_TRUE(message("a.off", "OFF\n1 0 0\n0 0 -1.#IND\n").starts_with(":3" + not_finite));
}

TEST_F(TextFormats, OffKeepsTheFirstThreeNumbersOfAVertex) {
  for (const char* keyword : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF", "NCOFF", "NSTOFF",
                              "CSTOFF", "NCSTOFF"}) {
    const TriangleMesh mesh = read("a.off", std::string(keyword) +
                                                "\n# counts\n3 1\n0 0 0 9 9 9 9\n1 0 0 9\n0 1 0\n"
                                                "3 2 1 0 0.5 0.5 0.5\n");
    EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << keyword;
    EXPECT_EQ(mesh.triangles.raw(), triangles({{2, 1, 0}})) << keyword;
  }
}

TEST_F(TextFormats, OffCountsAreCheckedBeforeAnythingIsReserved) {
  EXPECT_EQ(message("a.off", "OFF\n4000000000000000000 0 0\n0 0 0\n"),
            ":2: announces 4000000000000000000 vertices, but only 6 bytes follow; the file is cut "
            "off or its counts are wrong");
  EXPECT_EQ(message("a.off", "OFF\n1 1 0\n0 0 0\n2000000000 0\n"),
            ":4: a face of 2000000000 corners lacks one; found the end of the line");
  EXPECT_EQ(message("a.off", "nOFF\n4\n1 0 0\n0 0 0 0\n"),
            ":1: 4OFF and nOFF have other than three coordinates a vertex and are not read; write "
            "the mesh as OFF");
  EXPECT_EQ(message("a.off", "FOO\n"),
            ":1: is no OFF file: it begins with neither OFF nor a count; check the extension");
}

TEST_F(TextFormats, StlTextIsReadWhateverItsLinesAndCase) {
  const std::string solid =
      "SOLID a facet in its name\n"
      "Facet Normal nan nan nan Outer Loop Vertex 0 0 0 vertex 1 0 0\n"
      "vertex -0 1 0\nendloop endfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex 0 1 0\nvertex 1 0 0\n"
      "vertex 1 1 0\nvertex 0.5 2 0\nendloop\nendfacet\nendsolid a facet\n";
  const TriangleMesh mesh = read("a.stl", "\n " + solid);
  EXPECT_EQ(mesh.points.raw(),
            (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 2, 0}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST_F(TextFormats, StlTextMayWriteItsEndsInOtherWays) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  for (const char* ends :
       {"end loop\nendfacet\nendsolid\n", "endloop\nend facet\nend solid end\n",
        "endloop endfacet endsolidAssimpScene\n", "END LOOP End\tFacet end Solid name"}) {
    const TriangleMesh mesh = read("a.stl", "solid name\n" + facet + ends);
    EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}})) << ends;
  }
  EXPECT_EQ(message("a.stl", "solid\n" + facet + "end\nfacet\nendfacet\nendsolid\n"),
            ":7: expected vertex or endloop, found 'end'");
  EXPECT_EQ(message("a.stl", "solid\n" + facet + "end vertex 0 0 1\n"),
            ":7: expected vertex or endloop, found 'end'");
  EXPECT_EQ(message("a.stl", "solid\n" + facet + "endloop\nend"),
            ":8: the file ends within a facet; it is cut off");
}

// A name ends where facets begin, or the solid ends.
TEST_F(TextFormats, StlTextMayGoOnBehindANameInItsLine) {
  const std::string facet =
      " facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 "
      "endloop endfacet";
  const std::string other =
      " facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 1 0 vertex 0 0 1 "
      "endloop endfacet";
  for (const std::string& text :
       {"solid one facet" + facet + other + " endsolid one",
        "solid" + facet + "\n" + other + "\nendsolid",
        "solid x" + facet + " endsolid a solid part solid y" + other + " endsolid y\n",
        "solid x" + facet + "\nendsolid x solid y" + other + "\nendsolid y",
        "solid x endsolid x\nsolid y" + facet + other + "\nendsolid y"}) {
    EXPECT_EQ(read("a.stl", text).triangles.raw(), triangles({{0, 1, 2}, {0, 2, 3}})) << text;
  }
  EXPECT_EQ(message("a.stl", "solid x" + facet + "\nendsolid x solid y\n" + other + "\nendsolid\n"),
            ":3: expected solid, found 'facet'");
}

TEST_F(TextFormats, StlTextThatEndsEarlyIsRefused) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\n";
  EXPECT_EQ(message("a.stl", "solid\n" + facet),
            ":8: the file ends without endsolid; it is cut off");
  EXPECT_EQ(message("a.stl", "solid\n" + facet + "facet normal 0 0"),
            ":9: the file ends within a facet; it is cut off");
  // Wherever it is cut: between words and within one, but for the end of a number.
  const std::string complete = "solid\n" + facet;
  for (std::size_t size = complete.find("normal"); size + 2 < complete.size(); ++size) {
    EXPECT_TRUE(message("a.stl", complete.substr(0, size))
                    .ends_with(": the file ends within a facet; it is cut off"))
        << size;
  }
  EXPECT_EQ(message("a.stl", complete + "facet normal 0 0 1 outer loop edge 0 0 0\n"),
            ":9: expected vertex or endloop, found 'edge'");
  EXPECT_EQ(message("a.stl",
                    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
                    "endloop\nendfacet\nendsolid\n"),
            ":6: a facet has fewer than three corners");
}

// As a binary file may begin.
TEST_F(TextFormats, BinaryStlThatBeginsWithSolidIsNoText) {
  std::string damaged = "solid by another program";
  damaged.resize(80, ' ');
  damaged += std::string("\2\0\0\0", 4) + std::string(50, '\0');  // of two facets one
  EXPECT_EQ(message("a.stl", damaged),
            ": is no STL file, or damaged: as binary STL it announces 2 facets, which take 184 "
            "bytes, but has 134; check the extension, or get a whole copy");
}

// As long as they cannot be a facet that was not counted.
TEST_F(TextFormats, BytesBehindTheFacetsOfBinaryStlAreCounted) {
  std::string facet(50, '\0');
  facet[24 + 3] = facet[36 + 7] = '\x3f';  // 0.5
  const std::string header(80, ' ');
  const std::string one = header + std::string("\1\0\0\0", 4) + facet;
  for (const std::size_t behind : {0U, 1U, 49U}) {
    MeshReadReport report;
    const TriangleMesh mesh =
        read_mesh(folder.write("a.stl", one + facet.substr(0, behind)), report);
    EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}})) << behind;
    EXPECT_EQ(report.trailing_bytes, behind);
  }
  const std::string refused = ": is no STL file, or damaged: as binary STL it announces ";
  EXPECT_EQ(
      message("a.stl", one + facet),
      refused +
          "1 facets, which take 134 bytes, but has 184; check the extension, or get a whole copy");
  EXPECT_EQ(
      message("a.stl", header + std::string(4, '\0') + " "),
      refused +
          "0 facets, which take 84 bytes, but has 85; check the extension, or get a whole copy");
}

TEST_F(TextFormats, BinaryStlOfWhatIsNotFiniteIsRefused) {
  std::string facet(50, '\0');
  facet[24 + 3] = '\x7f';  // of the second corner x: infinite
  facet[24 + 2] = '\x80';
  EXPECT_TRUE(message("a.stl", std::string(80, ' ') + std::string("\1\0\0\0", 4) + facet)
                  .starts_with(": point 1 (counted from 0) has a coordinate that is not a finite"));
}

TEST_F(TextFormats, OffFacesHaveNoNegativeNumberOfCorners) {
  EXPECT_TRUE(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 1 2\n")
                  .starts_with(":6: a face begins with its number of corners"));
}

TEST_F(TextFormats, DegenerateFacesAreLeftOutAndCounted) {
  MeshReadReport report;
  const TriangleMesh mesh =
      read_mesh(folder.write("a.off",
                             "OFF\n4 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0\n2 0 1\n3 0 1 1\n"
                             "4 0 1 2 3\n5 0 1 1 2 3\nleft over\n"),
                report);
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(report.faces, 5U);
  EXPECT_EQ(report.polygons, 2U);
  EXPECT_EQ(report.short_faces, 2U);
  EXPECT_EQ(report.degenerate_triangles, 2U);
  EXPECT_EQ(report.trailing_bytes, 9U);
}

TEST_F(TextFormats, CommentsBehindTheLastFaceAreNotLeftOver) {
  const std::string tetrahedron =
      "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  MeshReadReport report;
  read_mesh(folder.write("a.off", tetrahedron + "# done\n\n  # really\n"), report);
  EXPECT_EQ(report.trailing_bytes, 0U);
  read_mesh(folder.write("a.off", tetrahedron + "# more\n3 0 1 2\n"), report);
  EXPECT_EQ(report.trailing_bytes, 7U);
}

TEST_F(TextFormats, FilesThatAreMissingOrFoldersAreRefused) {
  const auto missing = folder / "missing.ply";
  EXPECT_EQ(message_of<FileError>(missing, [&] { read_mesh(missing); }),
            ": cannot be read (No such file or directory); check the name and the permissions");
  const auto directory = folder / "d.ply";
  std::filesystem::create_directory(directory);
  EXPECT_EQ(message_of<FileError>(directory, [&] { read_mesh(directory); }),
            ": cannot be read (it is a folder); check the name and the permissions");
}

TEST_F(TextFormats, WhatStandsForAFileIsNamed) {
  EXPECT_EQ(message("a.stl", "\x1F\x8B\x08" + std::string(90, 'a')),
            ": is packed (gzip); unpack it first");
  EXPECT_EQ(message("a.ply", std::string("\xFD"
                                         "7zXZ\0",
                                         6) +
                                 "a"),
            ": is packed (xz); unpack it first");
  EXPECT_EQ(message("a.obj", "PK\3\4"), ": is packed (zip); unpack it first");
  EXPECT_EQ(message("a.off", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"),
            ": is a pointer of Git LFS, not the file itself; run 'git lfs pull'");
}

TEST_F(TextFormats, NulBytesAreNoText) {
  EXPECT_EQ(message("a.obj", std::string("v 0 0 0\n\0", 9)),
            ": byte 8 is NUL, so this is no text file; check the extension");
}

}  // namespace
}  // namespace cocoon
