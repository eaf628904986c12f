// Properties of PLY vertices are kept with name, type and bits, and written again.
#include "io/vertex_properties.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "io/encoding/byte_order.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

using Strings = std::vector<std::string>;

template <class T>
std::string bytes_of(const std::vector<T>& values, bool big_endian = false) {
  std::string bytes;
  for (const T value : values) {
    std::string number;
    append_little_endian(number, value);
    if (big_endian) std::reverse(number.begin(), number.end());
    bytes += number;
  }
  return bytes;
}

// Between and behind the coordinates: the ends of each type, a signaling pattern of bits, lists.
const std::string every_type =
    "element vertex 2\nproperty char a\nproperty float x\nproperty uchar red\n"
    "property float y\nproperty float z\nproperty short c\nproperty ushort d\nproperty int e\n"
    "property uint f\nproperty int64 g\nproperty uint64 h\nproperty float i\nproperty double j\n"
    "property list uchar ushort k\n";

std::string rows_of_every_type(bool big) {
  std::string rows;
  const auto add = [&](auto value) { rows += bytes_of<decltype(value)>({value}, big); };
  for (int row = 0; row < 2; ++row) {
    const bool low = row == 0;
    add(low ? std::numeric_limits<std::int8_t>::min() : std::numeric_limits<std::int8_t>::max());
    add(low ? 1.5F : -2.5F);
    add(low ? std::uint8_t{0} : std::uint8_t{255});
    add(0.25F);
    add(0.125F);
    add(low ? std::numeric_limits<std::int16_t>::min() : std::numeric_limits<std::int16_t>::max());
    add(low ? std::uint16_t{0} : std::uint16_t{65535});
    add(low ? std::numeric_limits<std::int32_t>::min() : std::numeric_limits<std::int32_t>::max());
    add(low ? std::uint32_t{0} : std::uint32_t{0xFFFFFFFF});
    add(low ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max());
    add(low ? std::uint64_t{0} : std::numeric_limits<std::uint64_t>::max());
    add(low ? 0.1F : std::numeric_limits<float>::denorm_min());
    add(low ? -0.0 : std::numeric_limits<double>::max());
    add(low ? std::uint8_t{0} : std::uint8_t{2});
    if (!low) rows += bytes_of<std::uint16_t>({60000, 7}, big);
  }
  return rows;
}

std::string ply(const std::string& format, const std::string& elements, const std::string& body) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

TEST(VertexProperties, EveryTypeKeepsItsBits) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& content) {
    return read_points(folder.write("a.ply", content), {.keep_properties = true});
  };
  const PointCloud little =
      read(ply("binary_little_endian", every_type, rows_of_every_type(false)));
  ASSERT_EQ(little.properties.rows, 2U);
  ASSERT_EQ(little.properties.columns.size(), 11U);
  EXPECT_EQ(little.properties.columns[1].declaration.name, "red");
  EXPECT_EQ(little.properties.columns[1].values, std::string("\0\xFF", 2));
  EXPECT_EQ(little.properties.columns[7].values,
            bytes_of<std::uint64_t>({0, std::numeric_limits<std::uint64_t>::max()}));
  EXPECT_EQ(type_text(little.properties.columns[10].declaration), "list uchar ushort");
  EXPECT_EQ(little.properties.columns[10].ends, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(little.properties.left_out, Strings{});

  const PointCloud big = read(ply("binary_big_endian", every_type, rows_of_every_type(true)));
  EXPECT_EQ(big.properties, little.properties);
  EXPECT_EQ(big.points, little.points);

  for (const bool ascii : {false, true}) {
    const TriangleMesh mesh = {IdVector<VertexId, Point>(little.points), {}};
    write_mesh(folder / "b.ply", mesh, little.properties, {.ascii = ascii});
    MeshReadReport report;
    VertexProperties again;
    EXPECT_EQ(read_mesh(folder / "b.ply", report, again), mesh);
    EXPECT_EQ(again, little.properties) << (ascii ? "ascii" : "binary");
  }
}

TEST(VertexProperties, AreNotReadUnlessAskedFor) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("a.ply", ply("binary_little_endian", every_type, rows_of_every_type(false)));
  EXPECT_TRUE(read_points(path).properties.columns.empty());
  EXPECT_EQ(read_points(path).properties.rows, 2U);
}

const std::string xyz = "property double x\nproperty double y\nproperty double z\n";

// Bits that text does not keep: which NaN it is. In binary files they are kept.
TEST(VertexProperties, NanPayloadsSurviveInBinary) {
  const TemporaryFolder folder;
  const auto odd_nan = std::bit_cast<double>(std::uint64_t{0x7FF4123456789ABC});
  const std::string body = bytes_of<double>({1, 2, 3, odd_nan});
  const PointCloud cloud = read_points(
      folder.write("a.ply", ply("binary_little_endian",
                                "element vertex 1\n" + xyz + "property double t\n", body)),
      {.keep_properties = true});
  EXPECT_EQ(cloud.properties.columns[0].values, bytes_of<double>({odd_nan}));
}

// What an ascii header promises and a line does not keep: the property goes, the points stay, and
// the reason is told.
TEST(VertexProperties, ValuesThatAreNotOfTheirTypeLeaveThePropertyOut) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& properties, const std::string& body) {
    const PointCloud cloud = read_points(
        folder.write("a.ply", ply("ascii", "element vertex 2\n" + xyz + properties, body)),
        {.keep_properties = true});
    EXPECT_EQ(cloud.points, (std::vector<Point>{{0, 0, 1}, {0, 0, 2}}));
    return cloud.properties;
  };
  const std::string one = "property uchar t\nproperty int u\n";
  const VertexProperties decimals = read(one, "0 0 1 7 1\n0 0 2 7.5 -1\n");
  ASSERT_EQ(decimals.columns.size(), 1U);
  EXPECT_EQ(decimals.columns[0].declaration.name, "u");
  EXPECT_EQ(decimals.columns[0].values, bytes_of<std::int32_t>({1, -1}));
  EXPECT_EQ(decimals.left_out, Strings{"t is no uchar in line 11"});
  EXPECT_EQ(read(one, "0 0 1 256 1\n0 0 2 7 1\n").left_out, Strings{"t is no uchar in line 10"});
  EXPECT_EQ(read(one, "0 0 1 -1 1\n0 0 2 7 x\n").left_out,
            (Strings{"t is no uchar in line 10", "u is no int in line 11"}));

  std::string long_list = "0 0 1 300";
  for (int i = 0; i < 300; ++i) long_list += " 1";
  EXPECT_EQ(read("property list uchar int l\n", long_list + "\n0 0 2 0\n").left_out,
            Strings{"l is no list uchar int in line 9"});
  const VertexProperties twice = read("property int t\nproperty int t\n", "0 0 1 4 5\n0 0 2 6 7\n");
  EXPECT_EQ(twice.left_out, Strings{"t comes a second time"});
  EXPECT_EQ(twice.columns[0].values, bytes_of<std::int32_t>({4, 6}));
}

TEST(VertexProperties, TextIsReadToTheNearestFloat) {
  const TemporaryFolder folder;
  // Just above the middle of two floats, by less than a double can tell.
  const PointCloud cloud = read_points(
      folder.write("a.ply", ply("ascii", "element vertex 3\n" + xyz + "property float t\n",
                                "0 0 1 1.00000005960464477540\n0 0 2 1e99\n0 0 3 nan\n")),
      {.keep_properties = true});
  const std::string& values = cloud.properties.columns[0].values;
  EXPECT_EQ(load_number<float>(values.data(), std::endian::little), std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(load_number<float>(values.data() + 4, std::endian::little),
            std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(load_number<float>(values.data() + 8, std::endian::little)));
}

TEST(VertexProperties, PointsThatAreLeftOutTakeTheirRowAlong) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.ply",
      ply("ascii", "element vertex 3\n" + xyz + "property list uchar int l\nproperty uchar t\n",
          "0 0 1 1 11 1\nnan 0 2 2 21 22 2\n0 0 3 1 31 3\n"));
  const PointCloud cloud = read_points(path, {.skip_non_finite = true, .keep_properties = true});
  EXPECT_EQ(cloud.skipped, (std::vector<std::size_t>{1}));
  EXPECT_EQ(cloud.properties.rows, 2U);
  EXPECT_EQ(cloud.properties.columns[0].values, bytes_of<std::int32_t>({11, 31}));
  EXPECT_EQ(cloud.properties.columns[0].ends, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(cloud.properties.columns[1].values, "\1\3");
  MeshReadReport report;
  VertexProperties properties;
  const TriangleMesh mesh = read_mesh(path, report, properties, {.skip_non_finite = true});
  EXPECT_EQ(mesh.points.raw(), cloud.points);
  EXPECT_EQ(report.skipped, (std::vector<std::size_t>{1}));
  EXPECT_EQ(properties, cloud.properties);
}

VertexProperty column(const std::string& name, PlyType type, const std::string& values) {
  return {{.name = name, .type = type}, values, {}};
}

TEST(VertexProperties, TablesAreGatheredByName) {
  const std::vector<VertexProperties> tables = {
      {2, {column("red", PlyType::uint8, "\1\2"), column("t", PlyType::uint8, "\3\4")}, {}},
      {1,
       {column("w", PlyType::float32, bytes_of<float>({5})), column("red", PlyType::uint8, "\6")},
       {}},
      {1, {column("t", PlyType::int8, "\7")}, {}}};
  const GatheredProperties gathered =
      gather_properties(tables, std::vector<RowOrigin>{{1, 0}, {0, 1}, {2, 0}, {0, 0}});
  ASSERT_EQ(gathered.properties.rows, 4U);
  ASSERT_EQ(gathered.properties.columns.size(), 3U);
  EXPECT_EQ(gathered.properties.columns[0].values, std::string("\6\2\0\1", 4));
  EXPECT_EQ(gathered.properties.columns[1].values, std::string("\0\4\0\3", 4));
  const std::string& w = gathered.properties.columns[2].values;
  EXPECT_EQ(load_number<float>(w.data(), std::endian::little), 5.0F);
  for (const std::size_t row : {1U, 2U, 3U}) {
    EXPECT_TRUE(std::isnan(load_number<float>(w.data() + 4 * row, std::endian::little)));
  }
  EXPECT_EQ(gathered.missing, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(gathered.conflicts, (std::vector<PropertyConflict>{{1, 2}}));
}

TEST(VertexProperties, AMeshIsNotWrittenWithRowsOfAnother) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = {IdVector<VertexId, Point>(3), {}};
  const VertexProperties two = {2, {column("t", PlyType::uint8, "\1\2")}, {}};
  EXPECT_THROW(write_mesh(folder / "a.ply", mesh, two), FileError);
  EXPECT_EQ(folder.names().size(), 0U);
}

// A reader would refuse them, or take what follows for something else.
TEST(VertexProperties, NamesThatNoHeaderCanHoldAreRefused) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.points.resize(1);
  for (const char* name : {"", "x", "z", "a b", "a\nend_header", "tab\t"}) {
    VertexProperties properties;
    properties.rows = 1;
    properties.columns.push_back(property_of(name, std::vector<double>{1}));
    EXPECT_THROW(write_mesh(folder.file("m.ply"), mesh, properties), FileError) << name;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(VertexProperties, OfTheCallersOwnComeBack) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  for (const Point& p : {Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}}) mesh.points.push_back(p);
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(2)});
  const std::vector<double> heights = {0.1, -2, 1e300};
  const std::vector<std::uint8_t> flags = {0, 1, 255};
  VertexProperties own;
  own.rows = 3;
  own.columns = {property_of("height", heights), property_of("boundary", flags)};
  for (const bool ascii : {false, true}) {
    write_mesh(folder / "a.ply", mesh, own, {.ascii = ascii});
    MeshReadReport report;
    VertexProperties read;
    read_mesh(folder / "a.ply", report, read);
    EXPECT_TRUE(read == own);
    EXPECT_EQ(type_text(read.columns[0].declaration), "double");
    EXPECT_EQ(type_text(read.columns[1].declaration), "uchar");
  }
}

}  // namespace
}  // namespace cocoon
