#include "io/tetrahedra_file.h"

#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "geom/orient3d.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

// Not in lexicographic order, with duplicates.
const std::vector<Point> input = {{5, 5, 5}, {1, 0, 0},   {0, 0, 0},       {1, 0, 0},
                                  {0, 1, 0}, {0, 0, 1.5}, {0.1, 0.2, 0.3}, {5, 5, 5}};
const std::vector<Point> distinct = {{5, 5, 5}, {1, 0, 0},   {0, 0, 0},
                                     {0, 1, 0}, {0, 0, 1.5}, {0.1, 0.2, 0.3}};

struct Tetrahedra {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> cells;
  friend bool operator==(const Tetrahedra&, const Tetrahedra&) = default;
};

Tetrahedra parse(std::istream& text, std::size_t num_points, std::size_t num_cells,
                 std::size_t first, bool has_references) {
  Tetrahedra result;
  std::string reference;
  for (std::size_t i = 0; i < num_points; ++i) {
    Point p;
    text >> p.x >> p.y >> p.z;
    if (has_references) text >> reference;
    result.points.push_back(p);
  }
  std::string word;
  if (has_references) text >> word >> word;
  for (std::size_t i = 0; i < num_cells; ++i) {
    std::array<std::size_t, 4> cell = {};
    for (std::size_t& v : cell) {
      text >> v;
      v -= first;
    }
    if (has_references) text >> reference;
    result.cells.push_back(cell);
  }
  EXPECT_TRUE(text.good());
  return result;
}

Tetrahedra read_tet(const std::filesystem::path& path) {
  std::istringstream text(content_of(path));
  std::size_t n = 0;
  std::size_t m = 0;
  text >> n >> m;
  return parse(text, n, m, 0, false);
}

// The content of the DataArray called `name`.
std::string array_of(const std::string& xml, const std::string& name) {
  const std::size_t tag = xml.find("Name=\"" + name + "\"");
  const std::size_t begin = xml.find(">\n", tag) + 2;
  return xml.substr(begin, xml.find("\n</DataArray>", begin) - begin);
}

std::string decode_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFF);
    }
  }
  return bytes;
}

template <class T>
std::vector<T> values_of(const std::string& xml, const std::string& name) {
  const std::string bytes = decode_base64(array_of(xml, name));
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  EXPECT_EQ(bytes.size(), length + sizeof length) << name;
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof length, length);
  return values;
}

TEST(TetrahedraFile, TetListsDistinctPointsInInputOrder) {
  const TemporaryFolder folder;
  const Triangulation triangulation = delaunay(input).triangulation;
  write_tetrahedra(folder / "a.tet", triangulation);
  const Tetrahedra read = read_tet(folder / "a.tet");
  EXPECT_EQ(read.points, distinct);
  ASSERT_EQ(read.cells.size(), triangulation.num_finite_cells());
  ASSERT_GT(read.cells.size(), 3U);
  for (std::size_t c = 0; c < read.cells.size(); ++c) {
    const auto& cell = read.cells[c];
    EXPECT_EQ(orient3d(read.points[cell[0]], read.points[cell[1]], read.points[cell[2]],
                       read.points[cell[3]]),
              Sign::positive);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(read.points[cell[static_cast<std::size_t>(i)]],
                triangulation.point(triangulation.vertex(CellId(c), i)));
    }
  }
}

TEST(TetrahedraFile, MeditHoldsTheSameCountedFromOne) {
  const TemporaryFolder folder;
  const Triangulation triangulation = delaunay(input).triangulation;
  write_tetrahedra(folder / "a.tet", triangulation);
  write_tetrahedra(folder / "a.MESH", triangulation);
  std::istringstream text(content_of(folder / "a.MESH"));
  std::string line;
  for (const char* expected : {"MeshVersionFormatted 2", "Dimension 3", "Vertices", "6"}) {
    ASSERT_TRUE(std::getline(text, line));
    EXPECT_EQ(line, expected);
  }
  const Tetrahedra read = parse(text, 6, triangulation.num_finite_cells(), 1, true);
  EXPECT_EQ(read, read_tet(folder / "a.tet"));
  text >> line;
  EXPECT_EQ(line, "End");
}

TEST(TetrahedraFile, VtuHoldsTheSameInBase64AndAsText) {
  const TemporaryFolder folder;
  const Triangulation triangulation = delaunay(input).triangulation;
  write_tetrahedra(folder / "a.tet", triangulation);
  write_tetrahedra(folder / "a.vtu", triangulation);
  const Tetrahedra expected = read_tet(folder / "a.tet");
  const std::string xml = content_of(folder / "a.vtu");
  std::vector<double> coordinates;
  for (const Point& p : expected.points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> ends;
  for (const auto& cell : expected.cells) {
    corners.insert(corners.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }
  EXPECT_EQ(values_of<double>(xml, "Points"), coordinates);
  EXPECT_EQ(values_of<std::int64_t>(xml, "connectivity"), corners);
  EXPECT_EQ(values_of<std::int64_t>(xml, "offsets"), ends);
  EXPECT_EQ(values_of<std::uint8_t>(xml, "types"),
            std::vector<std::uint8_t>(expected.cells.size(), 10));

  write_tetrahedra(folder / "b.vtu", triangulation, {.ascii = true});
  std::istringstream text(array_of(content_of(folder / "b.vtu"), "connectivity"));
  for (std::int64_t corner : corners) {
    std::int64_t read = -1;
    text >> read;
    EXPECT_EQ(read, corner);
  }
}

TEST(TetrahedraFile, LargeArraysJoinWithoutPaddingInside) {
  const TemporaryFolder folder;
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) {
    points.push_back({static_cast<double>(i * 7919 % 3001), static_cast<double>(i * i % 2999),
                      static_cast<double>(i * 104729 % 2801)});
  }
  const Triangulation triangulation = delaunay(points).triangulation;
  write_tetrahedra(folder / "a.vtu", triangulation);
  const std::string xml = content_of(folder / "a.vtu");
  EXPECT_EQ(values_of<double>(xml, "Points").size(), 3 * triangulation.num_vertices());
  EXPECT_EQ(values_of<std::int64_t>(xml, "connectivity").size(),
            4 * triangulation.num_finite_cells());
  EXPECT_EQ(values_of<std::int64_t>(xml, "offsets").back(),
            static_cast<std::int64_t>(4 * triangulation.num_finite_cells()));
}

TEST(TetrahedraFile, VtuHoldsValuesOfVerticesAndCells) {
  const TemporaryFolder folder;
  const Triangulation triangulation = delaunay(input).triangulation;
  std::vector<double> heights;
  for (const VertexId v : triangulation.vertices()) heights.push_back(triangulation.point(v).z);
  std::vector<double> numbers;
  for (const CellId c : triangulation.finite_cells()) numbers.push_back(c.value);
  write_tetrahedra(folder / "a.vtu", triangulation, {{{"height", heights}}, {{"number", numbers}}});
  const std::string xml = content_of(folder / "a.vtu");
  EXPECT_EQ(values_of<double>(xml, "number"), numbers);
  // Points are written in the order of the input, and so are their values.
  const std::vector<double> points = values_of<double>(xml, "Points");
  const std::vector<double> written = values_of<double>(xml, "height");
  ASSERT_EQ(written.size(), triangulation.num_vertices());
  for (std::size_t i = 0; i < written.size(); ++i) EXPECT_EQ(written[i], points[3 * i + 2]);
  EXPECT_NE(xml.find("<PointData>"), std::string::npos);
  EXPECT_NE(xml.find("</CellData>\n</Piece>"), std::string::npos);
}

TEST(TetrahedraFile, RefusesValuesThatDoNotFit) {
  const TemporaryFolder folder;
  const Triangulation triangulation = delaunay(input).triangulation;
  const std::vector<double> few(triangulation.num_vertices() - 1, 0);
  const std::vector<double> all(triangulation.num_cells(), 0);
  EXPECT_THROW(write_tetrahedra(folder / "a.vtu", triangulation, {{{"few", few}}, {}}), InputError);
  EXPECT_THROW(write_tetrahedra(folder / "a.vtu", triangulation, {{}, {{"all", all}}}), InputError);
  const std::span<const double> fit = std::span(all).first(triangulation.num_finite_cells());
  EXPECT_THROW(write_tetrahedra(folder / "a.vtu", triangulation, {{}, {{"a<b", fit}}}), InputError);
  EXPECT_THROW(write_tetrahedra(folder / "a.mesh", triangulation, {{}, {{"a", fit}}}), InputError);
  EXPECT_EQ(folder.names().size(), 0U);
}

TEST(TetrahedraFile, RefusesOtherExtensions) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_tetrahedra(folder / "a.ply", Triangulation()), FileError);
  EXPECT_EQ(folder.names().size(), 0U);
}

}  // namespace
}  // namespace cocoon
