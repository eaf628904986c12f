#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "io/encoding/byte_order.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

const std::string xyz = "property double x\nproperty double y\nproperty double z\n";

template <class T>
void append(std::string& bytes, T value, bool big_endian) {
  std::string number;
  append_little_endian(number, value);
  if (big_endian) std::reverse(number.begin(), number.end());
  bytes += number;
}

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::vector<Triangle> triangles(std::initializer_list<std::array<int, 3>> corners) {
  std::vector<Triangle> result;
  for (const auto& t : corners) result.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  return result;
}

// Each coordinate of another type, in both byte orders; unsigned and signed differ in the top bit.
TEST(Ply, EveryScalarTypeInBothByteOrders) {
  const TemporaryFolder folder;
  for (bool big : {false, true}) {
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const auto read_one = [&](const std::string& type, auto value) {
      std::string file = header(format, "element vertex 1\nproperty " + type +
                                            " x\nproperty uchar y"
                                            "\nproperty " +
                                            type + " z\n");
      append(file, value, big);
      append(file, std::uint8_t{7}, big);
      append(file, value, big);
      const PointCloud cloud = read_points(folder.write("a.ply", file));
      EXPECT_EQ(cloud.points,
                (std::vector<Point>{{static_cast<double>(value), 7, static_cast<double>(value)}}))
          << type << (big ? " big endian" : " little endian");
    };
    for (const char* name : {"char", "int8"}) read_one(name, std::int8_t{-100});
    for (const char* name : {"uchar", "uint8"}) read_one(name, std::uint8_t{200});
    for (const char* name : {"short", "int16"}) read_one(name, std::int16_t{-30000});
    for (const char* name : {"ushort", "uint16"}) read_one(name, std::uint16_t{60000});
    for (const char* name : {"int", "int32"}) read_one(name, std::int32_t{-2000000000});
    for (const char* name : {"uint", "uint32"}) read_one(name, std::uint32_t{4000000000U});
    for (const char* name : {"float", "float32"}) read_one(name, 0.1F);
    for (const char* name : {"double", "float64"}) read_one(name, -1e-300);
    read_one("int64", std::int64_t{-5000000000});
    read_one("uint64", std::uint64_t{5000000000});
  }
}

TEST(Ply, PolygonOfMoreThan255CornersWithWideCountAnd64BitIndices) {
  const TemporaryFolder folder;
  constexpr int n = 300;
  std::string file = header(
      "binary_little_endian",
      "element vertex 300\n" + xyz + "element face 1\nproperty list uint32 int64 vertex_index\n");
  for (int i = 0; i < n; ++i) {
    append(file, std::cos(2 * M_PI * i / n), false);
    append(file, std::sin(2 * M_PI * i / n), false);
    append(file, 0.0, false);
  }
  append(file, std::uint32_t{n}, false);
  for (int i = 0; i < n; ++i) append(file, std::int64_t{i}, false);
  MeshReadReport report;
  const TriangleMesh mesh = read_mesh(folder.write("a.ply", file), report);
  EXPECT_EQ(mesh.triangles.size(), 298U);
  EXPECT_EQ(report.polygons, 1U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
}

// Lists on vertices and other elements, before and behind what is read, are skipped; properties of
// other elements may be called as those of vertices.
TEST(Ply, OtherElementsAndListsAreSkipped) {
  const TemporaryFolder folder;
  const std::string elements =
      "element camera 1\nproperty float x\nproperty list ushort double vertex_indices\n"
      "element vertex 3\nproperty list uchar short tags\n" +
      xyz +
      "element nothing 2000000000\n"
      "element face 1\nproperty list uchar float uv\nproperty list uchar uchar vertex_indices\n"
      "property double x\nelement end 1\nproperty int last\n";
  std::string binary = header("binary_little_endian", elements);
  append(binary, 9.0F, false);
  append(binary, std::uint16_t{2}, false);
  append(binary, 1.0, false);
  append(binary, 2.0, false);
  for (int i = 0; i < 3; ++i) {
    append(binary, static_cast<std::uint8_t>(i), false);
    for (int k = 0; k < i; ++k) append(binary, std::int16_t{10}, false);
    append(binary, i == 1 ? 1.0 : 0.0, false);
    append(binary, i == 2 ? 1.0 : 0.0, false);
    append(binary, 10.0, false);  // its first byte is a LF when big endian, its last here is '@'
  }
  append(binary, std::uint8_t{1}, false);
  append(binary, 0.5F, false);
  for (int byte : {3, 2, 1, 0}) append(binary, static_cast<std::uint8_t>(byte), false);
  append(binary, 1.0, false);
  append(binary, 1, false);
  const std::string text = header("ascii", elements) +
                           "9 2 1 2\n0 0 0 10\n1 10 1 0 10\n2 10 10 0 1 10\n1 0.5 3 2 1 0 1\n1\n";
  for (const std::string& file : {binary, text}) {
    MeshReadReport report;
    const TriangleMesh mesh = read_mesh(folder.write("a.ply", file), report);
    EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 10}, {1, 0, 10}, {0, 1, 10}}));
    EXPECT_EQ(mesh.triangles.raw(), triangles({{2, 1, 0}}));
    EXPECT_EQ(report.trailing_bytes, 0U);
  }
}

// The payload begins with bytes that look like line ends.
TEST(Ply, BinaryBodyThatBeginsWithLineEnds) {
  const TemporaryFolder folder;
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    std::string file = header("binary_little_endian",
                              "element vertex 1\nproperty uchar x\nproperty uchar y\n"
                              "property uchar z\n");
    std::string with_ends;
    for (char c : file) with_ends += c == '\n' ? std::string(line_end) : std::string(1, c);
    const bool cr_only = std::string(line_end) == "\r";
    with_ends += cr_only ? "\r\n\n" : "\n\r\n";
    const std::vector<Point> points = read_points(folder.write("a.ply", with_ends)).points;
    EXPECT_EQ(points, (std::vector<Point>{cr_only ? Point{13, 10, 10} : Point{10, 13, 10}}));
  }
}

TEST(Ply, AsciiNumbersKeepTheirDecimalsWhateverTheirType) {
  const TemporaryFolder folder;
  const std::string file = header("ascii",
                                  "element vertex 3\nproperty int x\nproperty float y\n"
                                  "property uchar z\nelement face 1\n"
                                  "property list uchar float vertex_indices\n") +
                           "1.5 0.1 -3\n1e3 +2 .5\n\n  0 0 1\n3 0 1.0 2e0\n";
  const TriangleMesh mesh = read_mesh(folder.write("a.ply", file));
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{1.5, 0.1, -3}, {1000, 2, 0.5}, {0, 0, 1}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}}));
}

TEST(Ply, TriangleStripsKeepOneOrientation) {
  const TemporaryFolder folder;
  const std::string file = header("ascii", "element vertex 6\n" + xyz +
                                               "element tristrips 1\n"
                                               "property list int int vertex_indices\n") +
                           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 4 -1 3 5 4\n";
  const TriangleMesh mesh = read_mesh(folder.write("a.ply", file));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {3, 5, 4}}));
}

TEST(Ply, NonFiniteCoordinatesAreNamedOrSkippedOnDemand) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.ply", header("ascii", "element vertex 4\n" + xyz) + "0 0 0\nnan 0 0\n1 2 3\n0 1e999 0\n");
  EXPECT_EQ(
      message_of<FileError>(path, [&] { read_points(path); }),
      ":9: point 1 (counted from 0) has a coordinate that is not a finite number, and so have "
      "1 more; remove or repair such points");
  EXPECT_THROW(read_mesh(path), FileError);
  const PointCloud cloud = read_points(path, {.skip_non_finite = true});
  EXPECT_EQ(cloud.points, (std::vector<Point>{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(cloud.skipped, (std::vector<std::size_t>{1, 3}));
}

TEST(Ply, RefusesWhatIsAmbiguousOrDamaged) {
  const TemporaryFolder folder;
  const std::string vertex = "element vertex 1\n" + xyz;
  const std::string face = "element face 1\n";
  const auto message = [&](const std::string& content) {
    const auto path = folder.write("a.ply", content);
    return message_of<FileError>(path, [&] { read_mesh(path); });
  };
  EXPECT_EQ(message(header("ascii", vertex + face +
                                        "property list uchar int vertex_index\n"
                                        "property list uchar int vertex_indices\n") +
                    "0 0 0\n0 0\n"),
            ":7: element 'face' repeats its list vertex_indices; write the file anew with one of "
            "each");
  EXPECT_EQ(message(header("ascii", vertex + face + "property int vertex_index\n") + "0 0 0\n0\n"),
            ":7: property 'vertex_index' must be a list");
  EXPECT_EQ(message(header("ascii", vertex + face + "property int color\n") + "0 0 0\n0\n"),
            ":7: element 'face' lacks its list vertex_indices; write the file anew with one of "
            "each");
  EXPECT_EQ(message(header("ascii", vertex + face + "property list uchar int vertex_index\n") +
                    "0 0 0\n3 0 0.5 0\n"),
            ":11: expected a whole number, found '0.5'; does the line match the header?");
  EXPECT_EQ(message(header("ascii", vertex + face + "property list uchar int vertex_index\n") +
                    "0 0 0\n2000000000 0\n"),
            ":11: a list of 2000000000 values does not fit its line; the file is damaged");
  EXPECT_EQ(message("ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n"),
            ":3: a second format line; the header is damaged");
  EXPECT_EQ(message("ply\nformat ascii 1.0\nproperty int x\nend_header\n"),
            ":3: a property before the first element");
  EXPECT_EQ(message("ply\nformat ascii 1.0\nelement\nend_header\n"),
            ":3: an element needs a name and a count from 0 to 2^63 - 1; correct this line");
  EXPECT_EQ(message("ply\nformat ascii 1.0\nelement 1\nend_header\n"),
            ":3: an element needs a name and a count from 0 to 2^63 - 1; correct this line");
  EXPECT_EQ(message(" ply\nformat ascii 1.0\nend_header\n"),
            ":1: is no PLY file: its first line is not 'ply'; check the extension");
}

TEST(Ply, BlankLinesAreSkippedAndSurplusValuesCounted) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("a.ply", header("ascii", "\nelement vertex 3\n" + xyz + " \t\nelement face 2\n" +
                                                "property list uchar int vertex_index\n\n") +
                                "0 0 0\n\n1 0 0 7\n0 1 0\n\n3 0 1 2\n3 2 1 0 8 9\n");
  MeshReadReport report;
  const TriangleMesh mesh = read_mesh(path, report);
  EXPECT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(report.surplus_lines, 2U);
  EXPECT_EQ(report.first_surplus_line, 15U);
  const PointCloud cloud = read_points(path);
  EXPECT_EQ(cloud.surplus_lines, 2U);
  EXPECT_EQ(cloud.first_surplus_line, 15U);
}

// As librealsense writes them.
TEST(Ply, AsciiElementsMayHaveSeveralLines) {
  const TemporaryFolder folder;
  const std::string start =
      header("ascii", "element vertex 3\n" + xyz +
                          "property float nx\nproperty list uchar int l\nproperty uchar red\n"
                          "element face 1\nproperty list uchar int vertex_indices\n"
                          "property int flags\n");
  const std::string body = "0 0 0 \n0.5 0\n7 \n1 0 0\n\n0.5 2 1\n2 8\n0\n1 0 0.5 0 9\n3 0 1 2\n4\n";
  const auto path = folder.write("a.ply", start + body);
  MeshReadReport report;
  VertexProperties properties;
  const TriangleMesh mesh = read_mesh(path, report, properties);
  EXPECT_EQ(mesh.points.raw(), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles.raw(), triangles({{0, 1, 2}}));
  EXPECT_EQ(read_mesh(path).points.raw(), mesh.points.raw());
  EXPECT_EQ(report.surplus_lines, 0U);
  ASSERT_EQ(properties.columns.size(), 3U);
  EXPECT_EQ(properties.columns[2].values, "\7\10\11");

  // A line that lacks values is not completed by another element.
  const auto message = [&](const std::string& rows) {
    const auto damaged = folder.write("b.ply", header("ascii", "element vertex 2\n" + xyz) + rows);
    return message_of<FileError>(damaged, [&] { read_points(damaged); });
  };
  const std::string short_line =
      ": expected a number, found the end of the line; does the line "
      "match the header?";
  EXPECT_EQ(message("0.5 0.5\n1 2 3\n"), ":8" + short_line);
  EXPECT_EQ(message("0 0 0\n1 2\n\n"), ":9" + short_line);
  EXPECT_EQ(message("0 0\nx\n1 2 3\n"), ":8" + short_line);
}

}  // namespace
}  // namespace cocoon
