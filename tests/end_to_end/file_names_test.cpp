// Names of files: the same file by two names, inputs named as outputs, and names that cannot be.
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Runs the program in a folder, so that names can be relative.
class RunsInAFolder : public testing::Test {
 protected:
  RunsInAFolder() {
    folder.write("points.xyz", whole_sphere(1500));
    folder.write("cap.xyz", sphere_cap(6000, 0.8, 0.3));
    fs::current_path(folder.file(""));
  }
  ~RunsInAFolder() override { fs::current_path(before_); }

  static void expect_errors(const std::vector<Names>& command_lines, int exit_code,
                            const std::string& message) {
    for (const Names& arguments : command_lines) {
      std::string line;
      for (const std::string& argument : arguments) line += argument + " ";
      SCOPED_TRACE(line);
      expect_error(run_program(arguments), exit_code, message);
    }
  }

  TemporaryFolder folder;

 private:
  fs::path before_ = fs::current_path();
};

using TwoNames = RunsInAFolder;
using InputsAsOutputs = RunsInAFolder;
using LongNames = RunsInAFolder;

TEST_F(TwoNames, OfOneOutputAreRefusedBeforeItExists) {
  fs::create_symlink("w.ply", "link");
  fs::create_directory_symlink(".", "here");
  for (const std::string& name :
       {std::string("./w.ply"), std::string("here/w.ply"),
        std::string("here/../") + fs::current_path().filename().string() + "/w.ply",
        folder.file("w.ply"), std::string("link")}) {
    SCOPED_TRACE(name);
    expect_error(run_program({"update", "points.xyz", "cap.xyz", "-o", "w.ply", "--html", name}), 2,
                 name + ": two outputs cannot be the same file");
    expect_error(run_program({"reconstruct", "points.xyz", "-o", "w.ply", "--json", name}), 2,
                 "same file");
  }
  EXPECT_EQ(folder.names(), (Names{"cap.xyz", "here", "link", "points.xyz"}));
}

// A session takes the files beside it away when it is done.
TEST_F(TwoNames, WhatASessionKeepsBesideItselfIsNoOutput) {
  for (const std::string name : {"./s.session.lock", "s.session.cloud-1"}) {
    SCOPED_TRACE(name);
    expect_error(run_program({"reconstruct", "points.xyz", "-o", "w.ply", "--session", "s.session",
                              "--json", name}),
                 2, name + ": this name is kept for a file of the session s.session");
    expect_error(
        run_program({"update", "--session", "s.session", "cap.xyz", "-o", "w.ply", "--map", name}),
        2, "name another one");
  }
  EXPECT_EQ(folder.names(), (Names{"cap.xyz", "points.xyz"}));
}

// Their names end with numbers: others are left alone.
TEST_F(TwoNames, OnlyWhatIsNumberedIsAFileOfASession) {
  for (const std::string name : {"s.session.cloud-", "s.session.cloud-1.json", "s.session.cloud-x",
                                 "s.session.cloud", "s.session.lock.json"}) {
    SCOPED_TRACE(name);
    const ProgramRun run = run_program(
        {"reconstruct", "points.xyz", "-o", "w.ply", "--session", "s.session", "--json", name});
    EXPECT_EQ(run.exit_code, 0) << run.error;
    EXPECT_TRUE(fs::exists(name));
  }
}

// As many as the model has.
TEST_F(TwoNames, CloudsOfAModelAreOutputs) {
  expect_error(run_program({"sample", "airbag", "-o", "ab", "--json", "ab/cloud-3.xyz"}), 2,
               "ab/cloud-3.xyz: two outputs cannot be the same file");
  const ProgramRun run =
      run_program({"sample", "block", "-o", "b", "--points", "2000", "--json", "b/cloud-2.xyz"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
}

// The report goes there.
TEST_F(TwoNames, StandardOutputIsNoOutputBesideTheReport) {
  fs::create_symlink("/dev/stdout", "w.ply");
  expect_error(run_program({"reconstruct", "points.xyz", "-o", "w.ply", "--json", "-"}), 2,
               "w.ply: two outputs cannot be the same file");
}

// Sequences that set colors, titles and more.
TEST_F(LongNames, ControlBytesDoNotReachTheTerminal) {
  const std::string name = "red\x1b[31m.ply";
  const ProgramRun run = run_program({"reconstruct", "points.xyz", "-o", name});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_TRUE(fs::exists(name));
  EXPECT_EQ(run.out.find('\x1b'), std::string::npos);
  EXPECT_NE(run.out.find("-> red?[31m.ply\n"), std::string::npos) << run.out;
  expect_error(run_program({"reconstruct", "points.xyz", "-o", "no\x1b/\n" + name}), 1,
               "no?/?red?[31m.ply: there is no folder no?; make it first");
  expect_error(run_program({"reconstruct", "points.xyz", "-o", "\x7f.doc"}), 2, "?.doc: unknown");
}

TEST_F(InputsAsOutputs, AreRefused) {
  ASSERT_EQ(run_program({"reconstruct", "points.xyz", "-o", "m.ply"}).exit_code, 0);
  fs::create_symlink("cap.xyz", "link");
  const std::vector<Names> command_lines = {
      {"update", "m.ply", "cap.xyz", "-o", "w.ply", "--map", "cap.xyz"},
      {"update", "m.ply", "cap.xyz", "-o", "w.ply", "--map", "m.ply"},
      {"update", "m.ply", "cap.xyz", "-o", "w.ply", "--html", "./cap.xyz"},
      {"update", "m.ply", "cap.xyz", "-o", "w.ply", "--html", "link"},
      {"update", "m.ply", "cap.xyz", "-o", "w.ply", "--json", "m.ply"},
      {"update", "points.xyz", "m.ply", "-o", "m.ply"},
      {"update", "--session", "points.xyz", "points.xyz", "-o", "w.ply"},
      {"reconstruct", "points.xyz", "-o", "w.ply", "--session", "points.xyz"},
      {"reconstruct", "points.xyz", "-o", "w.ply", "--json", "points.xyz"},
      {"boundary", "points.xyz", "-o", "w.ply", "--json", "points.xyz"},
      {"delaunay", "points.xyz", "-o", "w.tet", "--json", "points.xyz"},
      {"check", "m.ply", "--json", "m.ply"},
      {"compare", "points.xyz", "m.ply", "--json", "m.ply"},
      {"watch", "m.ply", ".", "-o", "w.ply", "--once", "--session", "m.ply"},
  };
  const Names before = folder.names();
  const std::string points = content_of("points.xyz");
  const std::string model = content_of("m.ply");
  expect_errors(command_lines, 2, "is an input and would be overwritten");
  EXPECT_EQ(folder.names(), before);
  EXPECT_EQ(content_of("points.xyz"), points);
  EXPECT_EQ(content_of("m.ply"), model);
}

TEST_F(InputsAsOutputs, AMeshMayTakeThePlaceOfItsModel) {
  ASSERT_EQ(run_program({"reconstruct", "points.xyz", "-o", "m.ply"}).exit_code, 0);
  EXPECT_EQ(run_program({"update", "m.ply", "cap.xyz", "-o", "./m.ply"}).exit_code, 0);
  EXPECT_EQ(run_program({"reconstruct", "m.ply", "-o", "m.ply"}).exit_code, 0);
  EXPECT_EQ(run_program({"reconstruct", "m.ply", "-o", "m.ply", "--densify", "1"}).exit_code, 0);
  fs::create_symlink("m.ply", "m.obj");
  expect_error(run_program({"reconstruct", "m.ply", "-o", "m.obj"}), 2,
               "m.obj: is an input and would be overwritten");
}

// Of a scan nothing else may be left.
TEST_F(InputsAsOutputs, AMeshDoesNotTakeThePlaceOfAScan) {
  const std::string scan =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  folder.write("scan.ply", scan);
  fs::create_symlink("scan.ply", "again.ply");
  const std::vector<Names> command_lines = {
      {"reconstruct", "scan.ply", "-o", "scan.ply"},
      {"reconstruct", "scan.ply", "-o", "again.ply"},
      {"boundary", "scan.ply", "-o", "./scan.ply"},
      {"update", "scan.ply", "cap.xyz", "-o", "scan.ply"},
  };
  expect_errors(command_lines, 2, "is an input without faces, whose points would be overwritten");
  EXPECT_EQ(content_of("scan.ply"), scan);
}

TEST_F(LongNames, AreToldInOneLine) {
  const std::string name(256, 'n');
  const std::string mesh = name + ".ply";
  const std::vector<Names> command_lines = {
      {"reconstruct", "points.xyz", "-o", mesh},
      {"reconstruct", "points.xyz", "-o", "w.ply", "--json", name},
      {"reconstruct", "points.xyz", "-o", "w.ply", "--session", name},
      {"reconstruct", "points.xyz", "-o", name + "/w.ply"},
      {"boundary", "points.xyz", "-o", "w.ply", "--loops", name + ".obj"},
      {"update", "points.xyz", "cap.xyz", "-o", "w.ply", "--map", name},
      {"update", "points.xyz", "cap.xyz", "-o", "w.ply", "--html", name},
      {"update", "--session", name, "cap.xyz", "-o", "w.ply"},
      {"watch", "points.xyz", name, "-o", "w.ply", "--once"},
      {"watch", "points.xyz", ".", "-o", std::string(245, 'n') + ".ply", "--once"},
      {"watch", "points.xyz", ".", "-o", std::string(240, 'n') + ".ply", "--once"},
      {"demo", "-o", name},
      {"sample", "block", "-o", name, "--points", "600", "--cloud-points", "900"},
  };
  const Names before = folder.names();
  expect_errors(command_lines, 1, "this name is too long; use one of at most 255 bytes");
  EXPECT_EQ(folder.names(), before);
  expect_error(run_program({"check", mesh}), 1, "File name too long");

  const std::string longest = std::string(251, 'n') + ".ply";
  EXPECT_EQ(run_program({"reconstruct", "points.xyz", "-o", longest}).exit_code, 0);
}

TEST_F(LongNames, LoopsOfLinksAreToldInOneLine) {
  fs::create_symlink("loop.ply", "loop.ply");
  expect_error(run_program({"reconstruct", "points.xyz", "-o", "loop.ply"}), 1,
               "loop.ply: is a loop of symbolic links");
  expect_error(run_program({"watch", "points.xyz", "loop.ply", "-o", "w.ply", "--once"}), 1,
               "loop.ply: is a loop of symbolic links");
}

}  // namespace
}  // namespace cocoon::test
