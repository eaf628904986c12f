// The program as README.md and its help promise it: exit codes, outputs, the JSON report, silence.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sched.h>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

Json report_of(const Names& arguments) {
  Names with_json = arguments;
  with_json.insert(with_json.end(), {"--json", "-"});
  const ProgramRun run = run_program(with_json);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(run.error, "");
  return Json::accept(run.out) ? Json::parse(run.out) : Json();
}

void expect_common_parts(const Json& report, const std::string& command) {
  EXPECT_EQ(report["command"], command);
  EXPECT_TRUE(report["version"].is_string());
  EXPECT_GE(report["threads"].get<int>(), 1);
  EXPECT_GT(report["timings_s"]["total"].get<double>(), 0);
  EXPECT_GT(report["peak_memory_bytes"].get<double>(), 1e6);
}

TEST(Program, HelpAndVersionGoToStandardOutput) {
  for (const Names& arguments : {Names{"--help"}, Names{"update", "--help"}, Names{"--version"}}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out, "");
    EXPECT_EQ(run.error, "");
  }
}

TEST(Program, WrongCommandLinesAreTwo) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(200));
  const std::string out = folder.file("out.ply");
  expect_error(run_program({}), 2, "--help");
  expect_error(run_program({"frobnicate"}), 2, "frobnicate");
  expect_error(run_program({"reconstruct", cloud}), 2, "output");
  expect_error(run_program({"reconstruct", cloud, "-o", out, "--speed", "9"}), 2, "--speed");
  expect_error(run_program({"reconstruct", cloud, "-o", out, "--rho", "-1"}), 2, "rho");
  expect_error(run_program({"update", cloud, cloud, "-o", out, "--keep-groups", "3,4",
                            "--replace-groups", "4"}),
               2, "group 4 is in --keep-groups and in --replace-groups");
  expect_error(run_program({"reconstruct", cloud, "-o", folder.file("out.docx")}), 2, ".docx");
  expect_error(run_program({"reconstruct", cloud, "-o", out, "--json", out}), 2, "same file");
  expect_error(run_program({"sample", "teapot"}), 2, "teapot");
  EXPECT_EQ(folder.names(), Names{"cloud.xyz"});
}

TEST(Program, StandardInputNeedsALink) {
  const TemporaryFolder folder;
  for (const Names& arguments : {Names{"check", "-"}, Names{"compare", "-", "-"},
                                 Names{"delaunay", "-", "-o", folder.file("a.tet")}}) {
    expect_error(run_program(arguments), 2, "-: a stream needs a name");
  }
  expect_error(run_program({"check", "/dev/stdin"}), 2, "/dev/stdin: a stream needs a name");
  // It would be read until memory is gone.
  std::filesystem::create_symlink("/dev/zero", folder.file("endless.xyz"));
  expect_error(run_program({"check", folder.file("endless.xyz")}), 1, "it is a device");
}

TEST(Program, ReconstructReportsWhatItMeasured) {
  const TemporaryFolder folder;
  const std::string cloud =
      folder.write("cloud.xyz", whole_sphere(500) + point_line(0, 0, 1) + point_line(0, 0, 1));
  const Json report = report_of({"reconstruct", cloud, "-o", folder.file("out.ply")});
  expect_common_parts(report, "reconstruct");
  EXPECT_EQ(report["input"]["points"], 502);
  EXPECT_EQ(report["input"]["duplicates"], 1);
  EXPECT_EQ(report["delaunay"]["points"], 501);
  EXPECT_GT(report["delaunay"]["tetrahedra"], 1000);
  const Json& surface = report["surface"];
  EXPECT_EQ(surface["vertices"], 501);
  EXPECT_EQ(surface["triangles"], 2 * 501 - 4);
  EXPECT_EQ(surface["watertight"], true);
  EXPECT_EQ(surface["edge_manifold"], true);
  EXPECT_EQ(surface["vertex_manifold"], true);
  EXPECT_EQ(surface["components"], 1);
  EXPECT_EQ(surface["euler"], 2);
  EXPECT_EQ(surface["unused_points"], 0);
  for (const char* stage : {"read", "delaunay", "poles", "cocone", "boundary", "tight", "write"}) {
    EXPECT_TRUE(report["timings_s"].contains(stage)) << stage;
  }
  EXPECT_EQ(folder.names(), (Names{"cloud.xyz", "out.ply"}));
}

TEST(Program, ResultsDoNotDependOnThreads) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(3000));
  const Json one =
      report_of({"reconstruct", cloud, "-o", folder.file("one.ply"), "--threads", "1"});
  const Json four =
      report_of({"reconstruct", cloud, "-o", folder.file("four.ply"), "--threads", "4"});
  EXPECT_EQ(one["threads"], 1);
  EXPECT_EQ(four["threads"], 4);
  EXPECT_EQ(one["surface"]["hash"], four["surface"]["hash"]);
  EXPECT_EQ(content_of(folder.file("one.ply")), content_of(folder.file("four.ply")));
}

// As by taskset, or in a container with cores of its own.
TEST(Program, TakesNoMoreThreadsThanCoresItMayUse) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(500));
  const std::string out = folder.file("out.ply");
  const RunningProgram program(folder, {"reconstruct", cloud, "-o", out, "--json", "-"}, [] {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
  });
  const ProgramRun run = program.wait();
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(Json::parse(run.out)["threads"], 1);
}

TEST(Program, AllMeshFormatsHoldTheSameSurface) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(300));
  for (const char* name : {"out.ply", "out.OBJ", "out.off"}) {
    report_of({"reconstruct", cloud, "-o", folder.file(name)});
    const Json check = report_of({"check", folder.file(name), "--require", "closed,manifold"});
    EXPECT_EQ(check["surface"]["hash"],
              report_of({"check", folder.file("out.ply")})["surface"]["hash"])
        << name;
  }
}

TEST(Program, OpenCloudsHaveALoop) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cap.xyz", sphere_cap(4000, 0.9));
  const std::string loops = folder.file("loops.obj");
  const Json report =
      report_of({"boundary", cloud, "-o", folder.file("cap.ply"), "--loops", loops});
  expect_common_parts(report, "boundary");
  EXPECT_EQ(report["surface"]["watertight"], false);
  EXPECT_EQ(report["boundary"]["loops"].size(), 1U);
  EXPECT_NEAR(report["boundary"]["loops"][0]["perimeter"].get<double>(),
              2 * std::numbers::pi * std::sin(0.9), 0.5);
  EXPECT_NE(content_of(loops).find("\nl "), std::string::npos);
  const Json cocone =
      report_of({"reconstruct", cloud, "-o", folder.file("same.ply"), "--surface", "cocone"});
  EXPECT_EQ(cocone["surface"]["hash"], report["surface"]["hash"]);
}

TEST(Program, DelaunayInAllFormats) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
  for (const char* name : {"d.tet", "d.vtu", "d.mesh"}) {
    const Json report = report_of({"delaunay", cloud, "-o", folder.file(name)});
    expect_common_parts(report, "delaunay");
    EXPECT_EQ(report["delaunay"]["points"], 5);
    EXPECT_EQ(report["delaunay"]["tetrahedra"], 2);
  }
  EXPECT_EQ(content_of(folder.file("d.tet")).rfind("5 2\n", 0), 0U);
  for (const bool ascii : {false, true}) {
    std::vector<std::string> arguments = {"delaunay", cloud, "-o", folder.file("d.vtu")};
    if (ascii) arguments.emplace_back("--ascii");
    EXPECT_EQ(run_program(arguments).exit_code, 0);
    const std::string vtu = content_of(folder.file("d.vtu"));
    EXPECT_EQ(vtu.find("format=\"ascii\"") != std::string::npos, ascii);
    EXPECT_EQ(vtu.find("format=\"binary\"") != std::string::npos, !ascii);
  }
}

// A square ring: 3 x 3 squares without the one in the middle, as high as they are wide.
constexpr const char* ring_off =
    "OFF\n16 16 0\n"
    "0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n"
    "0 0 1\n3 0 1\n3 3 1\n0 3 1\n1 1 1\n2 1 1\n2 2 1\n1 2 1\n"
    "4 0 4 5 1\n4 1 5 6 2\n4 2 6 7 3\n4 3 7 4 0\n"
    "4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n"
    "4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 0 8 11\n"
    "4 4 12 13 5\n4 5 13 14 6\n4 6 14 15 7\n4 7 15 12 4\n";

TEST(Program, CheckTellsWhereHandlesAre) {
  const TemporaryFolder folder;
  const std::string ring = folder.write("ring.off", ring_off);
  const Json report =
      report_of({"check", ring, "--handles", "5", "--require", "closed,manifold,oriented"});
  EXPECT_EQ(report["surface"]["genus"], 1);
  const Json& handles = report["surface"]["handles"];
  ASSERT_EQ(handles.size(), 1U);
  EXPECT_GE(handles[0]["length"].get<double>(), 2 + 2 * std::sqrt(2));  // up, in, down, out
  EXPECT_GE(handles[0]["edges"], 4);
  EXPECT_EQ(handles[0]["at"].size(), 3U);
  EXPECT_FALSE(report_of({"check", ring})["surface"].contains("handles"));
  const std::string open = folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(report_of({"check", open, "--handles", "5"})["surface"]["handles"].size(), 0U);
}

TEST(Program, CheckCertifiesAndRequires) {
  const TemporaryFolder folder;
  const std::string closed = folder.write("closed.ply", tetrahedron_ply);
  const Json report = report_of({"check", closed, "--self-intersections", "--require",
                                 "closed,manifold,oriented,connected,no-self-intersections"});
  expect_common_parts(report, "check");
  EXPECT_EQ(report["surface"]["triangles"], 4);
  EXPECT_EQ(report["surface"]["genus"], 0);
  EXPECT_EQ(report["surface"]["self_intersections"], 0);
  EXPECT_NEAR(report["surface"]["volume"].get<double>(), 1.0 / 6, 1e-15);

  const std::string open = folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const ProgramRun run = run_program({"check", open, "--require", "closed", "--quiet"});
  expect_error(run, 1, "open.off: not closed (3 open edges");
  const std::string json = folder.file("report.json");
  EXPECT_EQ(run_program({"check", open, "--require", "closed", "--json", json}).exit_code, 1);
  EXPECT_EQ(Json::parse(content_of(json))["failed_requirements"].size(), 1U);
  EXPECT_EQ(run_program({"check", open}).exit_code, 0);

  // The reader leaves it out, but the file has it.
  const std::string bad =
      folder.write("bad.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 1 1 2\n");
  EXPECT_EQ(report_of({"check", bad})["surface"]["repeated_vertex_triangles"], 1);
  expect_error(run_program({"check", bad, "--require", "no-bad-triangles", "--quiet"}), 1,
               "bad.off: fails no-bad-triangles (triangles: 1 with a repeated vertex");
}

TEST(Program, CompareMeasuresBothDirections) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.xyz", "0 0 0\n1 0 0\n");
  const std::string b = folder.write("b.xyz", "0 0 0\n1 0 0\n1 0 2\n");
  const Json report = report_of({"compare", a, b});
  expect_common_parts(report, "compare");
  EXPECT_EQ(report["distance"]["a_to_b"]["max"], 0);
  EXPECT_EQ(report["distance"]["b_to_a"]["max"], 2);
  EXPECT_EQ(report["distance"]["max"], 2);
}

TEST(Program, CompareTellsTheShareWithinATolerance) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.xyz", "0 0 0\n1 0 0\n");
  const std::string b = folder.write("b.xyz", "0 0 0\n1 0 0\n1 0 2\n3 0 0\n");
  EXPECT_FALSE(report_of({"compare", a, b})["distance"].contains("f_score"));
  const Json report = report_of({"compare", a, b, "--tolerance", "0.5"});
  EXPECT_EQ(report["distance"]["a_to_b"]["within"], 1);
  EXPECT_EQ(report["distance"]["b_to_a"]["within"], 0.5);
  EXPECT_NEAR(report["distance"]["f_score"].get<double>(), 2.0 / 3, 1e-15);
  EXPECT_EQ(report["parameters"]["tolerance"], 0.5);
}

TEST(Program, UpdateReplacesWhatLiesUnderTheCloud) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(2000));
  const std::string cloud = folder.write("bump.xyz", sphere_cap(6000, 0.8, 0.3));
  const std::string map = folder.file("map.txt");
  const std::string html = folder.file("report.html");
  const Json report = report_of(
      {"update", model, cloud, "-o", folder.file("new.ply"), "--map", map, "--html", html});
  expect_common_parts(report, "update");
  EXPECT_EQ(report["input"]["points"], 2000);
  EXPECT_EQ(report["surface"]["watertight"], true);
  EXPECT_EQ(report["surface"]["euler"], 2);
  const Json& parameters = report["parameters"];  // of the clouds' surfaces, and of the model's
  EXPECT_EQ(parameters["rho"], 0.3);
  EXPECT_EQ(parameters["radius"], "cocone");
  EXPECT_NEAR(parameters["model"]["rho"].get<double>(), 1 / 1.2, 1e-12);
  EXPECT_EQ(parameters["model"]["radius"], "tangent-plane");
  EXPECT_EQ(parameters["alpha_deg"].dump(), "30.0");
  const Json& update = report["update"];
  EXPECT_EQ(update["loops"], Json::array({1}));
  EXPECT_EQ(update["groups"], 2);
  EXPECT_GT(update["boundary_points"], 20);
  EXPECT_GT(update["overlapping_facets"], 20);
  const Json& angles = update["clouds"][0]["mean_angle_deg"];
  ASSERT_EQ(update["clouds"][0]["replaced_groups"].size(), 1U);
  const std::string replaced = update["clouds"][0]["replaced_groups"][0].dump();
  EXPECT_LT(angles[replaced].get<double>(), 30);
  EXPECT_GT(angles[replaced == "0" ? "1" : "0"].get<double>(), 150);
  EXPECT_EQ(update["clouds"][0]["is_cut"], false);
  EXPECT_EQ(update["updated_points"].get<int>(),
            2000 - update["replaced_points"].get<int>() + report["input"]["clouds"][0].get<int>());
  for (const char* stage : {"boundary_detection", "overlapping_facets",
                            "segmentation_and_selection", "reconstruction"}) {
    EXPECT_GT(report["timings_s"][stage].get<double>(), 0) << stage;
  }
  const std::string lines = content_of(map);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2000);
  EXPECT_EQ(content_of(html).rfind("<!DOCTYPE html>", 0), 0U);
}

// An edge of its rim is a seam.
TEST(Program, TheReportOfTheDemoSaysThatTheCutDecided) {
  const TemporaryFolder folder;
  const Json cloud = report_of({"demo", "-o", folder.file("demo")})["update"]["clouds"][0];
  EXPECT_EQ(cloud["seam_edges"], 1);
  EXPECT_EQ(cloud["is_cut"], true);
}

// The first point is inside the sphere, the second is given again, as the last.
TEST(Program, TheMapHasALineForEachPointOfTheModel) {
  const TemporaryFolder folder;
  const std::string sphere = whole_sphere(2000);
  const std::string last = sphere.substr(sphere.rfind('\n', sphere.size() - 2) + 1);
  const std::string model = folder.write("model.xyz", "0 0 0\n" + last + sphere);
  const std::string cloud = folder.write("bump.xyz", sphere_cap(6000, 0.8, 0.3));
  const std::string map = folder.file("map.txt");
  report_of({"update", model, cloud, "-o", folder.file("new.ply"), "--map", map});
  std::istringstream lines(content_of(map));
  const std::vector<int> places{std::istream_iterator<int>(lines), {}};
  ASSERT_EQ(places.size(), 2002U);
  EXPECT_EQ(places[0], -1);
  EXPECT_NE(places[1], -1);
  EXPECT_EQ(places.back(), places[1]);
  EXPECT_EQ(std::set<int>(places.begin(), places.end()).count(0), 1U);
}

// STL has corners, not vertices with numbers.
TEST(Program, ThereIsNoMapOfAMeshWithoutNumbers) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(2000));
  const std::string cloud = folder.write("bump.xyz", sphere_cap(6000, 0.8, 0.3));
  const Names update = {"update", model, cloud, "-o", folder.file("new.STL")};
  Names with_map = update;
  with_map.insert(with_map.end(), {"--map", folder.file("map.txt")});
  expect_error(run_program(with_map), 2, "new.STL: STL does not keep the numbers of vertices");
  EXPECT_EQ(folder.names(), (Names{"bump.xyz", "model.xyz"}));
  EXPECT_EQ(run_program(update).exit_code, 0);
}

TEST(Program, UpdateMayOverwriteItsOwnModel) {
  const TemporaryFolder folder;
  const std::string model = folder.file("model.ply");
  const std::string points = folder.write("points.xyz", whole_sphere(2000));
  const std::string cloud = folder.write("bump.xyz", sphere_cap(6000, 0.8, 0.3));
  report_of({"reconstruct", points, "-o", model});
  const Json first = report_of({"update", model, cloud, "-o", folder.file("new.ply")});
  const Json second = report_of({"update", model, cloud, "-o", model});
  EXPECT_EQ(first["surface"]["hash"], second["surface"]["hash"]);
  EXPECT_EQ(content_of(model), content_of(folder.file("new.ply")));
}

// Clouds of a model with more of them would be taken for those of this one.
TEST(Program, SampleTellsOfCloudsThatAreLeft) {
  const TemporaryFolder folder;
  const Names few = {"--points", "600", "--cloud-points", "900", "-o", folder.file("")};
  const auto sample = [&](const std::string& model) {
    Names arguments = {"sample", model};
    arguments.insert(arguments.end(), few.begin(), few.end());
    return report_of(arguments)["warnings"];
  };
  EXPECT_EQ(sample("airbag").size(), 0U);
  const Json warnings = sample("block");
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[1].get<std::string>().find("cloud-3.xyz: is left"), std::string::npos);
}

TEST(Program, SampleWritesTheModelAndItsTruth) {
  const TemporaryFolder folder;
  const Json report = report_of({"sample", "block", "-o", folder.file("block"), "--points", "600",
                                 "--cloud-points", "900", "--seed", "5"});
  EXPECT_EQ(report["sample"]["points"], 600);
  EXPECT_EQ(report["sample"]["clouds"], Json::array({900}));
  EXPECT_EQ(run_program(
                {"check", folder.file("block/truth.ply"), "--require", "closed,manifold,oriented"})
                .exit_code,
            0);
  const std::string initial = content_of(folder.file("block/initial.xyz"));
  EXPECT_EQ(std::count(initial.begin(), initial.end(), '\n'), 600);
  const std::string replaced = content_of(folder.file("block/replaced.txt"));
  EXPECT_EQ(std::count(replaced.begin(), replaced.end(), '\n'),
            report["sample"]["replaced_points"]);
}

// The report is the last of the outputs; none appears, so none may be told of.
TEST(Program, OutputsThatDoNotAppearAreNotSaid) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(800));
  const std::string cap = folder.write("cap.xyz", sphere_cap(6000, 0.8, 0.3));
  const std::vector<Names> command_lines = {
      {"reconstruct", cloud, "-o", folder.file("out.ply")},
      {"boundary", cap, "-o", folder.file("out.ply")},
      {"delaunay", cloud, "-o", folder.file("out.tet")},
      {"update", cloud, cap, "-o", folder.file("out.ply"), "--verbose"},
      {"sample", "block", "-o", folder.file(""), "--points", "600", "--cloud-points", "900"},
  };
  for (const Names& arguments : command_lines) {
    SCOPED_TRACE(arguments[0]);
    ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    EXPECT_NE(run.out.find(" -> " + folder.file("")), std::string::npos) << run.out;
    for (const char* name : {"out.ply", "out.tet"}) std::filesystem::remove(folder.file(name));
    const Names before = folder.names();
    Names failing = arguments;
    failing.insert(failing.end(), {"--json", "/dev/full"});
    run = run_program(failing);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.error.find("/dev/full: cannot be written"), std::string::npos) << run.error;
    EXPECT_EQ(run.out.find("->"), std::string::npos) << run.out;
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(Program, QuietIsSilent) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(300));
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", folder.file("out.ply"), "--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.error, "");
}

TEST(Program, ProgressIsShownOnlyOnDemandWhenThereIsNoTerminal) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(300));
  EXPECT_EQ(run_program({"reconstruct", cloud, "-o", folder.file("out.ply")}).error, "");
  const ProgramRun run =
      run_program({"reconstruct", cloud, "-o", folder.file("out.ply"), "--progress"});
  EXPECT_NE(run.error.find("delaunay"), std::string::npos);
  EXPECT_EQ(run.error.find('\r'), std::string::npos);
}

// Once the points are read, triangulating many takes long enough to be interrupted.
void interrupt_after_reading(const RunningProgram& program, int signal) {
  for (int i = 0; i < 6000 && program.error_so_far().find("read: done") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  program.send(signal);
}

TEST(Program, InterruptLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(400000));
  const std::string out = folder.write("out.ply", "the old content");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder outputs;
    const RunningProgram program(outputs, {"reconstruct", cloud, "-o", out, "--progress"});
    interrupt_after_reading(program, signal);
    const ProgramRun run = program.wait();
    EXPECT_EQ(run.signal, signal) << run.exit_code << run.error;
    EXPECT_NE(run.error.find("\ncocoon: cancelled during delaunay"), std::string::npos)
        << run.error;
    EXPECT_EQ(content_of(out), "the old content");
    EXPECT_EQ(folder.names(), (Names{"cloud.xyz", "out.ply"}));
  }
}

// As under nohup, or in the background of a script.
TEST(Program, SignalsThatAreIgnoredWhenItStartsStaySo) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("cloud.xyz", whole_sphere(20000));
  const auto ignore = [] {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder outputs;
    const std::string out = folder.file("out.ply");
    const RunningProgram program(outputs, {"reconstruct", cloud, "-o", out, "--progress"}, ignore);
    interrupt_after_reading(program, signal);
    const ProgramRun run = program.wait();
    EXPECT_EQ(run.exit_code, 0) << run.signal << run.error;
    EXPECT_TRUE(std::filesystem::remove(out));
  }
}

}  // namespace
}  // namespace cocoon::test
