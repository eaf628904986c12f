// Every file of tests/data/io is read as its row in expectations.txt says.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "io/mesh_file.h"
#include "io/point_file.h"

namespace cocoon {
namespace {

const std::filesystem::path folder = std::filesystem::path(COCOON_TEST_DATA) / "io";

std::map<std::string, std::string> read_expectations() {
  std::map<std::string, std::string> expectations;
  std::ifstream file(folder / "expectations.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t blank = line.find(' ');
    expectations[line.substr(0, blank)] = line.substr(blank + 1);
  }
  return expectations;
}

std::string outcome_of(const std::filesystem::path& path) {
  std::ostringstream outcome;
  try {
    if (has_mesh_extension(path)) {
      MeshReadReport report;
      const TriangleMesh mesh = read_mesh(path, report);
      outcome << "load " << mesh.points.size() << ' ' << report.faces << ' '
              << mesh.triangles.size();
    } else {
      const std::size_t count = read_points(path).points.size();
      outcome << "load " << count;
    }
  } catch (const FileError& error) {
    outcome << "reject " << std::string(error.what()).substr(path.string().size());
  }
  return outcome.str();
}

TEST(Expectations, EveryFileIsReadAsListed) {
  const std::map<std::string, std::string> expectations = read_expectations();
  ASSERT_GT(expectations.size(), 200U);
  for (const auto& [name, expected] : expectations) {
    ASSERT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_EQ(outcome_of(folder / name), expected) << name;
  }
}

TEST(Expectations, EveryFileIsListed) {
  const std::map<std::string, std::string> expectations = read_expectations();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || name == "expectations.txt" || name == ".gitattributes")
      continue;
    EXPECT_EQ(expectations.count(name), 1U) << name;
  }
}

// A mesh file read as points gives the same vertices, and is refused for the same reason.
TEST(Expectations, PointsOfMeshFilesAreTheirVertices) {
  for (const auto& [name, expected] : read_expectations()) {
    const std::filesystem::path path = folder / name;
    if (!has_mesh_extension(path)) continue;
    if (expected.starts_with("load")) {
      EXPECT_EQ(read_points(path).points, read_mesh(path).points.raw()) << name;
    } else {
      EXPECT_THROW(read_points(path), FileError) << name;
    }
  }
}

// One model in three encodings.
TEST(Expectations, EncodingsOfOneModelAgree) {
  const TriangleMesh little = read_mesh(folder / "ply/happly__platonic_shelf.ply");
  EXPECT_EQ(little, read_mesh(folder / "ply/happly__platonic_shelf_big_endian.ply"));
  const TriangleMesh text = read_mesh(folder / "ply/happly__platonic_shelf_ascii.ply");
  EXPECT_EQ(little.triangles, text.triangles);
  ASSERT_EQ(little.points.size(), text.points.size());
  for (VertexId v : text.points.ids()) {
    EXPECT_LT(distance(little.points[v], text.points[v]), 1e-4);  // the text has 6 digits
  }
}

}  // namespace
}  // namespace cocoon
