// Bad input: exit code 1, one line that says what is wrong and where, no output file, nothing left
// behind.
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Names = std::vector<std::string>;

struct BadCloud {
  const char* name;
  std::string content;
  const char* mentions;  // besides the file's name
};

const std::vector<BadCloud>& bad_clouds() {
  static const std::vector<BadCloud> clouds = {
      {"empty.xyz", "", ""},
      {"comments.xyz", "# nothing\n# here\n", ""},
      {"words.xyz", "these are\nno points\n", ""},
      {"nan.xyz", "0 0 0\n1 0 0\nnan 1 0\n0 0 1\n1 1 1\n", ":3"},
      {"inf.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 inf\n", ":4"},
      {"overflow.xyz", "0 0 0\n1 0 0\n0 1e999 0\n0 0 1\n", ":3"},
      {"short-line.xyz", "0 0 0\n1 0\n0 1 0\n0 0 1\n", ":2"},
      {"one.xyz", "1 2 3\n", "only 1 different point: "},
      {"two.xyz", "1 2 3\n4 5 6\n", "give more points"},
      {"three.xyz", "0 0 0\n1 0 0\n0 1 0\n", "different points"},
      {"equal.xyz", "1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n", "only 1 different point: "},
      {"coplanar.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0.5 0.25 0\n", "plane"},
      {"collinear.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n", "off the line"},
      {"truncated.ply",
       "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
       "property double z\nend_header\n0 0 0\n1 0 0\n",
       ""},
      {"truncated-binary.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty double x\n"
       "property double y\nproperty double z\nend_header\nabc",
       ""},
      {"no-header.ply", "0 0 0\n1 0 0\n", ""},
      {"unknown.jpeg", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "jpeg"},
  };
  return clouds;
}

// Runs a command on a bad file in a folder of its own, and checks all that a failure promises.
void expect_refused(const BadCloud& cloud, const std::string& command, const Names& options,
                    const std::string& output) {
  SCOPED_TRACE(command + " " + cloud.name);
  const TemporaryFolder folder;
  const std::string input = folder.write(cloud.name, cloud.content);
  Names arguments = {command, input};
  for (const std::string& option : options) {
    arguments.push_back(option == "OUTPUT" ? folder.file(output) : option);
  }
  const ProgramRun run = run_program(arguments);
  expect_error(run, 1, cloud.name);
  EXPECT_NE(run.error.find(cloud.mentions), std::string::npos) << run.error;
  EXPECT_EQ(folder.names(), Names{cloud.name});
}

TEST(BadInput, Reconstruct) {
  for (const BadCloud& cloud : bad_clouds()) {
    expect_refused(cloud, "reconstruct", {"-o", "OUTPUT"}, "out.ply");
  }
}

TEST(BadInput, Boundary) {
  for (const BadCloud& cloud : bad_clouds()) {
    expect_refused(cloud, "boundary", {"-o", "OUTPUT"}, "out.ply");
  }
}

TEST(BadInput, Delaunay) {
  for (const BadCloud& cloud : bad_clouds()) {
    expect_refused(cloud, "delaunay", {"-o", "OUTPUT"}, "out.tet");
  }
}

TEST(BadInput, MissingFile) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing.xyz");
  const std::string out = folder.file("out.ply");
  expect_error(run_program({"reconstruct", missing, "-o", out}), 1, "missing.xyz");
  expect_error(run_program({"update", missing, missing, "-o", out}), 1, "missing.xyz");
  expect_error(run_program({"check", folder.file("missing.ply")}), 1, "missing.ply");
  expect_error(run_program({"compare", missing, missing}), 1, "missing.xyz");
  expect_error(run_program({"reconstruct", folder.file("nothing"), "-o", out}), 1,
               "nothing: cannot be read (No such file or directory)");
  EXPECT_EQ(folder.names(), Names{});
}

TEST(BadInput, AFolderIsNoFile) {
  const TemporaryFolder folder;
  const TemporaryFolder other;
  expect_error(run_program({"reconstruct", folder.file("."), "-o", other.file("out.ply")}), 1,
               "it is a folder");
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(200));
  std::filesystem::create_directory(folder.file("folder.ply"));
  expect_error(run_program({"reconstruct", cloud, "-o", folder.file("folder.ply")}), 1,
               "folder.ply: is a folder");
  expect_error(run_program({"reconstruct", cloud, "-o", other.file(".")}), 1, "is a folder");
  EXPECT_EQ(other.names(), Names{});
}

TEST(BadInput, OutputWhereNoFileCanBe) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(200));
  expect_error(run_program({"reconstruct", cloud, "-o", folder.file("no/such/folder/out.ply")}), 1,
               "folder");
  expect_error(run_program({"reconstruct", cloud, "-o", "/proc/nothing-can-be-made-here.ply"}), 1,
               "nothing-can-be-made-here.ply");
  expect_error(run_program({"reconstruct", cloud, "-o", folder.file("out.ply"), "--json",
                            folder.file("no/report.json")}),
               1, "report.json");
  EXPECT_EQ(folder.names(), Names{"cloud.xyz"});
}

TEST(BadInput, AFailedRunLeavesTheOldOutputAsItWas) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const std::string out = folder.write("out.ply", "the old content");
  expect_error(run_program({"reconstruct", cloud, "-o", out}), 1, "flat.xyz");
  EXPECT_EQ(content_of(out), "the old content");
}

TEST(BadInput, NonFinitePointsCanBeLeftOutOnDemand) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("gaps.xyz", "nan nan nan\n" + whole_sphere(200));
  const std::string out = folder.file("out.ply");
  expect_error(run_program({"reconstruct", cloud, "-o", out}), 1,
               "remove or repair such points, or leave them out: --skip-non-finite");
  const ProgramRun run = run_program({"reconstruct", cloud, "-o", out, "--skip-non-finite"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("warning"), std::string::npos);
}

// A cloud in a file that could hold a mesh, where it is the model or what is compared.
TEST(BadInput, NonFinitePointsOfModelsWithoutFacesCanBeLeftOut) {
  const TemporaryFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\n";
  const std::string corners = "0 0 0 1\n1 0 0 2\nnan 5 5 3\n0 1 0 4\n0 0 1 5\n";
  const std::string cloud = folder.write("cloud.ply", header + "end_header\n" + corners);
  const std::string mesh = folder.write(
      "mesh.ply", header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                      corners + "3 0 1 3\n");
  const std::string other = folder.write("other.xyz", "0 0 0\n1 0 0\n");
  const std::string told = "warning: " + cloud + ": 1 point is not finite and was left out\n";
  Names compare = {"compare", cloud, other};
  Names update = {"update", cloud, other, "-o", folder.file("out.ply")};
  for (Names* command : {&compare, &update}) {
    const ProgramRun run = run_program(*command);
    expect_error(run, 1, "point 2 (counted from 0) has a coordinate");
    EXPECT_NE(run.error.find("leave them out: --skip-non-finite"), std::string::npos);
    command->push_back("--skip-non-finite");
  }
  EXPECT_NE(run_program(compare).out.find(told), std::string::npos);
  EXPECT_EQ(run_program(compare).exit_code, 0);
  EXPECT_NE(run_program(update).out.find(told), std::string::npos);  // two points are no cloud
  const ProgramRun run = run_program({"compare", mesh, mesh, "--skip-non-finite"});
  expect_error(run, 1, "point 2");
  EXPECT_EQ(run.error.find("leave them out"), std::string::npos);  // a face needs them
}

// As R writes a table: the first three columns of the rows need not be those of the names.
TEST(BadInput, AColumnThatTheHeaderDoesNotNameIsAWarning) {
  const TemporaryFolder folder;
  const std::string warning = "rows have one column more than the header names";
  const auto told = [&](const std::string& content) {
    const ProgramRun run =
        run_program({"delaunay", folder.write("a.txt", content), "-o", folder.file("out.tet")});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return run.out.find(warning) != std::string::npos;
  };
  EXPECT_TRUE(told("x y z\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"));
  EXPECT_FALSE(told("x y z r\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"));
  EXPECT_FALSE(told("n x y z\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"));
}

TEST(BadInput, TrianglesWithoutAreaAreComparedAsPoints) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n2 0 0\n";
  const std::string flat = folder.write("flat.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n");
  expect_error(run_program({"compare", flat, flat}), 1,
               "leave them out to compare the points alone");
  const std::string cloud = folder.write("cloud.off", "OFF\n3 0 0\n" + points);
  EXPECT_EQ(run_program({"compare", cloud, cloud}).exit_code, 0);
}

// Lines of the map are those of the file, whatever was left out of it.
TEST(BadInput, TheMapHasALineForEachPointThatIsLeftOut) {
  const TemporaryFolder folder;
  const std::string cap = folder.write("cap.xyz", sphere_cap(2000, 0.8, 0.3));
  const std::string points = whole_sphere(500);
  const std::size_t second = points.find('\n') + 1;
  const std::string text = folder.write(
      "text.xyz", points.substr(0, second) + "nan 0 0\n" + points.substr(second) + "0 0 inf\n");
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 502\nproperty double x\n"
      "property double y\nproperty double z\nend_header\n";
  const std::string ply = folder.write("cloud.ply", header + content_of(text));
  const auto map_of = [&](const std::string& model) {
    const std::string map = folder.file("map.txt");
    const ProgramRun run = run_program({"update", model, cap, "-o", folder.file("out.ply"), "--map",
                                        map, "--skip-non-finite", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return content_of(map);
  };
  std::string expected = map_of(folder.write("clean.xyz", points));
  expected.insert(expected.find('\n') + 1, "-1\n");
  expected += "-1\n";
  EXPECT_EQ(map_of(text), expected);
  EXPECT_EQ(map_of(ply), expected);
}

// The report is of all files, not of the last one.
TEST(BadInput, LeftOutPointsOfAllFilesAreCounted) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(500) + "nan 0 0\n0 inf 0\n");
  const std::string cap = folder.write("cap.xyz", sphere_cap(2000, 0.8, 0.3) + "0 0 nan\n");
  const ProgramRun run = run_program(
      {"update", model, cap, "-o", folder.file("out.ply"), "--skip-non-finite", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(nlohmann::json::parse(run.out)["input"]["skipped_non_finite"], 3);
}

// Where a file and its own counts disagree, but nothing is missing, the user is told.
TEST(BadInput, MoreThanAFileAnnouncesIsAWarning) {
  const TemporaryFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\n";
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string counted = folder.write("scan.pts", "3\n" + corners);
  const std::string behind = folder.write("scan.ply", header + "end_header\n" + corners + "1 1 1");
  const std::string mesh = folder.write(
      "mesh.ply", header + "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
                      corners + faces + "3 0 1 2");
  const auto expect_warning = [](const std::vector<std::string>& arguments,
                                 const std::string& warning) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    EXPECT_NE(run.out.find("warning: " + warning + "\n"), std::string::npos) << run.out;
  };
  const std::string out = folder.file("out.tet");
  expect_warning({"delaunay", counted, "-o", out},
                 counted + ": announces 3 points, but 4 follow; all of them were read");
  expect_warning({"delaunay", behind, "-o", out},
                 behind + ": 5 bytes were not read, behind what its header announces");
  expect_warning({"check", mesh},
                 mesh + ": 7 bytes were not read, behind what its header announces");
  const std::string mesh_header =
      header + "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + corners;
  const std::string lines =
      folder.write("lines.ply", mesh_header + "3 0 2 1 3\n3 0 1 3\n" + "3 0 3 2 1\n3 1 2 3\n");
  expect_warning({"check", lines}, lines + ":14: this line and 1 more have more values than the " +
                                       "header announces; the last ones were not read");
  const std::string line =
      folder.write("line.ply", header + "end_header\n0 0 0\n1 0 0 5\n" + "0 1 0\n0 0 1\n");
  expect_warning({"delaunay", line, "-o", out},
                 line +
                     ":9: this line has more values than the header announces; the last ones "
                     "were not read");
}

// Far from the origin floats are too far apart; text has all digits.
TEST(BadInput, AMeshThatTheOutputCannotKeepIsAWarning) {
  const TemporaryFolder folder;
  const std::string near = folder.write("near.xyz", whole_sphere(300));
  const std::string far = folder.write("far.xyz", far_from_origin(whole_sphere(300)));
  const auto told = [&](std::vector<std::string> arguments) {
    const std::string json = folder.file("report.json");
    arguments.insert(arguments.end(), {"--json", json});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    const nlohmann::json report = nlohmann::json::parse(content_of(json));
    const bool is_chosen = run.out.find("in floats vertices move") != std::string::npos;
    const bool warned =
        is_chosen || run.out.find("in the floats of binary STL vertices move") != std::string::npos;
    EXPECT_EQ(warned, report.contains("rounding")) << run.out;
    const std::string way_out = is_chosen ? "leave --float out" : "--ascii";
    EXPECT_EQ(warned, report["warnings"].dump().find(way_out) != std::string::npos);
    return warned;
  };
  const std::string stl = folder.file("out.stl");
  EXPECT_TRUE(told({"reconstruct", far, "-o", stl}));
  EXPECT_FALSE(told({"reconstruct", far, "-o", stl, "--ascii"}));
  EXPECT_FALSE(told({"reconstruct", far, "-o", folder.file("out.ply")}));
  EXPECT_TRUE(told({"reconstruct", far, "-o", folder.file("out.ply"), "--float"}));
  EXPECT_FALSE(told({"reconstruct", near, "-o", folder.file("out.ply"), "--float"}));
  EXPECT_FALSE(told({"reconstruct", near, "-o", stl}));
}

TEST(BadInput, ColumnsWithoutNamesThatTellAreANote) {
  const TemporaryFolder folder;
  const std::string rows = "1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n5,0,2,2\n";
  const std::string out = folder.file("out.tet");
  const std::string unknown = folder.write("unknown.csv", "id,a,b,c\n" + rows);
  EXPECT_NE(run_program({"delaunay", unknown, "-o", out})
                .out.find("note: " + unknown +
                          ": no columns are named x, y, z; taken are the first "
                          "three: id, a, b\n"),
            std::string::npos);
  const std::string known = folder.write("known.csv", "id,Points:0,Points:1,Points:2\n" + rows);
  const ProgramRun run = run_program({"delaunay", known, "-o", out, "--json", "-"});
  EXPECT_EQ(run.out.find("note"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(run.out)["input"]["coordinate_columns"].dump(),
            R"(["Points:0","Points:1","Points:2"])");
}

TEST(BadInput, RowsAndColumnsThatAreCountedAreAWarning) {
  const TemporaryFolder folder;
  std::ostringstream numbered;
  std::ostringstream named;
  named << "0,1,2\n";
  for (int i = 1; i < 12; ++i) {
    numbered << i << ' ' << i % 3 << ' ' << i % 4 << ' ' << i % 5 << ".5\n";
    named << i % 3 << ',' << i % 4 << ',' << i % 5 << ".5\n";
  }
  const auto reads = [&](const std::string& name, const std::string& content) {
    return run_program({"delaunay", folder.write(name, content), "-o", folder.file("out.tet")}).out;
  };
  EXPECT_NE(reads("a.xyz", numbered.str()).find("the first column counts the rows"),
            std::string::npos);
  EXPECT_NE(reads("a.csv", named.str()).find("the first row, 0 1 2, was read as a point"),
            std::string::npos);
  EXPECT_EQ(reads("b.xyz", "n x y z\n" + numbered.str()).find("warning"), std::string::npos);
}

TEST(BadInput, BytesBehindBinaryStlAreAWarning) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(100));
  const std::string mesh = folder.file("mesh.stl");
  ASSERT_EQ(run_program({"reconstruct", cloud, "-o", mesh}).exit_code, 0);
  std::ofstream(mesh, std::ios::app) << '\n';
  const ProgramRun run = run_program({"check", mesh, "--require", "closed"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("warning: " + mesh + ": 1 byte was not read"), std::string::npos)
      << run.out;
}

TEST(BadInput, MeshWithoutTriangles) {
  const TemporaryFolder folder;
  const std::string points =
      folder.write("points.ply",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                   "property float z\nend_header\n0 0 0\n");
  expect_error(run_program({"check", points}), 1, "points.ply");
}

TEST(BadInput, CloudThatDoesNotTouchTheModel) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  std::string far_away;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j)
      far_away += point_line(50 + 0.05 * i, 0.05 * j, 0.001 * (i * j % 7));
  }
  const std::string cloud = folder.write("far.xyz", far_away);
  expect_error(run_program({"update", model, cloud, "-o", folder.file("out.ply")}), 1, "far.xyz");
  EXPECT_EQ(folder.names(), (Names{"far.xyz", "model.xyz"}));
}

TEST(BadInput, CloudThatIsClosed) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  const std::string cloud = folder.write("ball.xyz", whole_sphere(800));
  expect_error(run_program({"update", model, cloud, "-o", folder.file("out.ply")}), 1, "ball.xyz");
  EXPECT_EQ(folder.names(), (Names{"ball.xyz", "model.xyz"}));
}

TEST(BadInput, DamagedModel) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cap.xyz", sphere_cap(3000, 0.8, 0.3));
  std::string text = tetrahedron_ply;
  text.replace(text.find("3 1 2 3"), 7, "3 1 2 9");  // a corner that is no vertex
  const std::string model = folder.write("model.ply", text);
  expect_error(run_program({"update", model, cloud, "-o", folder.file("out.ply")}), 1, "model.ply");
  EXPECT_EQ(folder.names(), (Names{"cap.xyz", "model.ply"}));
}

// Of scanners' formats the way out is named.
TEST(BadInput, FormatsThatAreNotReadAreNamed) {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& name) {
    const ProgramRun run =
        run_program({"reconstruct", folder.write(name, "LASF"), "-o", folder.file("m.ply")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.error.find("is not known; use .xyz"), std::string::npos) << run.error;
    return run.error.find("CloudCompare") != std::string::npos;
  };
  EXPECT_TRUE(told("scan.las"));
  EXPECT_TRUE(told("scan.E57"));
  EXPECT_FALSE(told("scan.docx"));
  for (const char* name : {"scan.xyz.gz", "scan.ZIP", "mesh.ply.zst"}) {
    expect_error(run_program({"reconstruct", folder.write(name, "PK"), "-o", folder.file("m.ply")}),
                 1, "unpack it first");
  }
}

}  // namespace
}  // namespace cocoon::test
