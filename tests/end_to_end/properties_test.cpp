// Colors and other properties of PLY files go where their vertices go.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "io/encoding/byte_order.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/sample_models.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

// The points as ascii PLY with two properties that number them, from `first` on.
std::string numbered_ply(Points points, int first, const std::string& number_type = "int") {
  std::ostringstream text;
  text.precision(17);
  text << "ply\nformat ascii 1.0\nelement vertex " << points.size()
       << "\nproperty uchar red\nproperty double x\nproperty double y\nproperty double z\n"
       << "property " << number_type << " number\nend_header\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    text << i % 256 << ' ' << p.x << ' ' << p.y << ' ' << p.z << ' ' << first + static_cast<int>(i)
         << '\n';
  }
  return text.str();
}

struct NumberedMesh {
  TriangleMesh mesh;
  std::vector<int> numbers;
  std::vector<int> reds;
};

NumberedMesh read_numbered(const std::string& path) {
  NumberedMesh result;
  MeshReadReport report;
  VertexProperties properties;
  result.mesh = read_mesh(path, report, properties);
  EXPECT_EQ(properties.columns.size(), 2U);
  if (properties.columns.size() != 2) return result;
  EXPECT_EQ(type_text(properties.columns[0].declaration), "uchar");
  EXPECT_EQ(type_text(properties.columns[1].declaration), "int");
  for (std::size_t i = 0; i < properties.rows; ++i) {
    result.reds.push_back(static_cast<std::uint8_t>(properties.columns[0].values[i]));
    result.numbers.push_back(load_number<std::int32_t>(properties.columns[1].values.data() + 4 * i,
                                                       std::endian::little));
  }
  return result;
}

std::vector<Point> sphere_points() {
  std::istringstream text(whole_sphere(1500));
  std::vector<Point> points;
  for (Point p; text >> p.x >> p.y >> p.z;) points.push_back(p);
  return points;
}

TEST(Properties, ReconstructCarriesTheRowOfTheFirstOfEqualPoints) {
  const TemporaryFolder folder;
  std::vector<Point> points = sphere_points();
  const std::size_t distinct = points.size();
  for (std::size_t i = 0; i < 100; ++i) points.push_back(points[i]);
  const std::string cloud = folder.write("cloud.ply", numbered_ply(points, 0));
  for (const std::string command : {"reconstruct", "boundary"}) {
    const ProgramRun run =
        run_program({command, cloud, "-o", folder.file("out.ply"), "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.error;
    const Json report = Json::parse(run.out);
    EXPECT_EQ(report["properties"], Json::parse(R"([{"name":"red","type":"uchar","missing":0},
                              {"name":"number","type":"int","missing":0}])"));
    const NumberedMesh out = read_numbered(folder.file("out.ply"));
    ASSERT_GT(out.numbers.size(), distinct / 2);
    for (const VertexId v : out.mesh.points.ids()) {
      const auto number = static_cast<std::size_t>(out.numbers[v.index()]);
      ASSERT_LT(number, distinct);
      EXPECT_EQ(out.mesh.points[v], points[number]);
      EXPECT_EQ(out.reds[v.index()], static_cast<int>(number % 256));
    }
  }
}

// In the place of a property of that name.
TEST(Properties, BoundaryLabelsTheBoundarySamples) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cap.xyz", sphere_cap(800, 0.6));
  const std::string out = folder.file("out.ply");
  for (const std::string& input : {cloud, out}) {
    const ProgramRun run =
        run_program({"boundary", input, "-o", out, "--label-samples", "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.error;
    MeshReadReport report;
    VertexProperties properties;
    const TriangleMesh mesh = read_mesh(out, report, properties);
    ASSERT_EQ(properties.columns.size(), 1U);
    EXPECT_EQ(properties.columns[0].declaration.name, "boundary_sample");
    const std::string& flags = properties.columns[0].values;
    ASSERT_EQ(flags.size(), mesh.points.size());
    const auto count = std::count(flags.begin(), flags.end(), '\1');
    EXPECT_GT(count, 10);
    EXPECT_EQ(count + std::count(flags.begin(), flags.end(), '\0'),
              static_cast<std::ptrdiff_t>(flags.size()));
    EXPECT_LE(count, Json::parse(run.out)["boundary"]["samples"].get<int>());
  }
}

double coordinate_of(const VertexProperty& column, std::size_t row) {
  return load_number<double>(column.values.data() + sizeof(double) * row, std::endian::little);
}

// Points outside, on and inside a tetrahedron, and the same beside the points alone.
TEST(Properties, CompareWritesDistancesAndTheirColors) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.xyz", "-2 1 1\n0 1 1\n1 1 1\n");
  const std::string b = folder.write(
      "b.off", "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const std::string out = folder.file("out.ply");
  const ProgramRun run =
      run_program({"compare", a, b, "-o", out, "--tolerance", "2", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(Json::parse(run.out)["deviation"], Json::parse(R"({"signed":true,"full_color":2.0})"));
  MeshReadReport report;
  VertexProperties properties;
  read_mesh(out, report, properties);
  ASSERT_EQ(properties.columns.size(), 4U);
  EXPECT_EQ(properties.columns[0].declaration.name, "distance");
  EXPECT_EQ(coordinate_of(properties.columns[0], 0), 2);
  EXPECT_EQ(coordinate_of(properties.columns[0], 1), 0);
  EXPECT_EQ(coordinate_of(properties.columns[0], 2), -1);
  const auto channel = [&](std::size_t column) { return properties.columns[column].values; };
  EXPECT_EQ(channel(1), "\xff\xff\x80");  // red
  EXPECT_EQ(channel(2), std::string("\0\xff\x80", 3));
  EXPECT_EQ(channel(3), std::string("\0\xff\xff", 3));

  const ProgramRun unsigned_run = run_program({"compare", a, a, "-o", out, "--json", "-"});
  ASSERT_EQ(unsigned_run.exit_code, 0) << unsigned_run.error;
  EXPECT_EQ(Json::parse(unsigned_run.out)["deviation"],
            Json::parse(R"({"signed":false,"full_color":0.0})"));
}

// As compare measures them: any size, any difference in size.
TEST(Properties, DistancesAreThoseOfCompareAtAnyScale) {
  const TemporaryFolder folder;
  const std::string tetrahedron =
      "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string body = folder.write("body.off", tetrahedron);
  const std::string huge = folder.write("huge.xyz", "1e300 0 0\n3e300 0 0\n");
  const std::string tiny = folder.write("tiny.xyz", "1e-170 0 0\n3e-170 0 0\n");
  const std::string origin = folder.write("origin.xyz", "0 0 0\n");
  const std::string out = folder.file("out.ply");
  for (const auto& [a, b, largest] : {std::tuple{huge, body, 3e300}, std::tuple{huge, tiny, 3e300},
                                      std::tuple{tiny, origin, 3e-170}}) {
    const ProgramRun run = run_program({"compare", a, b, "-o", out, "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.error;
    const Json told = Json::parse(run.out);
    EXPECT_NEAR(told["distance"]["a_to_b"]["max"].get<double>() / largest, 1, 1e-9);
    MeshReadReport report;
    VertexProperties properties;
    read_mesh(out, report, properties);
    EXPECT_NEAR(coordinate_of(properties.columns.at(0), 1) / largest, 1, 1e-9);
    EXPECT_GT(told["deviation"]["full_color"].get<double>(), largest);
  }
}

TEST(Properties, FloatsAreWrittenOnDemand) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(500));
  const std::string out = folder.file("out.ply");
  for (const bool is_float : {false, true}) {
    std::vector<std::string> arguments = {"reconstruct", cloud, "-o", out};
    if (is_float) arguments.push_back("--float");
    ASSERT_EQ(run_program(arguments).exit_code, 0);
    const std::string header = content_of(out).substr(0, 200);
    EXPECT_EQ(header.find("property float x\n") != std::string::npos, is_float);
    const TriangleMesh mesh = read_mesh(out);
    const bool are_floats = std::all_of(mesh.points.begin(), mesh.points.end(), [](const Point& p) {
      return static_cast<double>(static_cast<float>(p.x)) == p.x;
    });
    EXPECT_EQ(are_floats, is_float);
  }
}

TEST(Properties, OtherFormatsAreWrittenWithout) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.ply", numbered_ply(sphere_points(), 0));
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", folder.file("out.obj"), "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_FALSE(Json::parse(run.out).contains("properties"));
}

// A model given as points, as a mesh, and a cloud with, without and with other properties.
TEST(Properties, UpdateCarriesThoseOfModelAndCloud) {
  const TemporaryFolder folder;
  const SampleModel block = sample_model("block");
  const std::vector<Point>& added = block.clouds.front();
  constexpr int first_of_cloud = 1000000;
  const std::string points = folder.write("points.ply", numbered_ply(block.initial, 0));
  const std::string cloud = folder.write("cloud.ply", numbered_ply(added, first_of_cloud));
  const std::string bare = folder.file("bare.xyz");
  write_points(bare, added);
  const std::string other = folder.write("other.ply", numbered_ply(added, 0, "float"));
  const std::string mesh = folder.file("mesh.ply");
  ASSERT_EQ(run_program({"reconstruct", points, "-o", mesh}).exit_code, 0);

  const auto update = [&](const std::string& model, const std::string& with) {
    const ProgramRun run =
        run_program({"update", model, with, "-o", folder.file("out.ply"), "--json", "-"});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return Json::parse(run.out);
  };
  for (const std::string& model : {points, mesh}) {
    const Json report = update(model, cloud);
    EXPECT_EQ(report["properties"][1]["missing"], 0);
    const NumberedMesh out = read_numbered(folder.file("out.ply"));
    std::size_t from_cloud = 0;
    for (const VertexId v : out.mesh.points.ids()) {
      const int number = out.numbers[v.index()];
      const bool is_added = number >= first_of_cloud;
      from_cloud += is_added ? 1U : 0U;
      const auto index = static_cast<std::size_t>(is_added ? number - first_of_cloud : number);
      EXPECT_EQ(out.mesh.points[v], is_added ? added[index] : block.initial[index]);
    }
    EXPECT_GT(from_cloud, 1000U);
    EXPECT_GT(out.numbers.size() - from_cloud, 1000U);
  }

  const Json without = update(mesh, bare);
  const NumberedMesh out = read_numbered(folder.file("out.ply"));
  const auto zeros =
      static_cast<std::size_t>(std::count(out.numbers.begin(), out.numbers.end(), 0));
  const std::size_t missing = without["properties"][1]["missing"];
  EXPECT_GT(missing, 1000U);
  EXPECT_LE(zeros - missing, 1U);  // the model's point 0, if it is kept
  EXPECT_NE(without["warnings"].dump().find("no value"), std::string::npos);

  const Json conflict = update(mesh, other);
  EXPECT_EQ(conflict["properties_left_out"],
            Json::array({other + ": number is no int as in the files before"}));
  EXPECT_EQ(conflict["properties"][0]["missing"], 0);
  EXPECT_EQ(conflict["properties"][1]["missing"], missing);
}

}  // namespace
}  // namespace cocoon::test
