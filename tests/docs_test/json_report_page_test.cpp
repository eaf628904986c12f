// docs/json_report.md has every member of the reports that commands write, and no other.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path root = COCOON_SOURCE_DIR;

std::set<std::string> documented() {
  const std::string page = content_of((root / "docs/json_report.md").string());
  const std::regex pattern("`([a-z_A-Z0-9]+(?:\\[\\]|/[a-z_A-Z0-9]+)*)`");
  std::set<std::string> paths;
  for (std::sregex_iterator it(page.begin(), page.end(), pattern), end; it != end; ++it) {
    const std::string path = (*it)[1];
    if (path.find('/') != std::string::npos || path.ends_with("[]")) paths.insert(path);
  }
  for (const char* path : {"command", "version", "threads", "peak_memory_bytes"}) {
    if (page.find(std::string("`").append(path) + '`') != std::string::npos) paths.insert(path);
  }
  return paths;
}

// The paths of all members; of an array without elements its own with "[]".
void add_paths(const Json& value, const std::string& path, std::set<std::string>& paths) {
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) {
      const bool is_named_freely = path == "timings_s" || path.ends_with("mean_angle_deg");
      const std::string shown = path == "timings_s" ? "STAGE" : "GROUP";
      const std::string last = is_named_freely && name != "total" ? shown : name;
      add_paths(member, path.empty() ? last : path + "/" + last, paths);
    }
  } else if (value.is_array()) {
    for (const Json& element : value) add_paths(element, path + "[]", paths);
    if (value.empty()) paths.insert(path + "[]");
  } else {
    paths.insert(path);
  }
}

// Those of `reconstruct` and `boundary`: the page says how options are named there.
bool is_threshold(const std::string& path, const std::string& help) {
  const std::string section = "parameters/";
  if (!path.starts_with(section)) return false;
  std::string name = path.substr(section.size());
  if (name.ends_with("_deg")) name.resize(name.size() - 4);
  std::replace(name.begin(), name.end(), '_', '-');
  return help.find(std::string("--").append(name) + ' ') != std::string::npos;
}

class JsonReportPage : public testing::Test {
 protected:
  void expect_documented(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProgramRun run = run_program(arguments);
    ASSERT_EQ(run.exit_code, 0) << arguments[0] << ": " << run.error;
    std::set<std::string> paths;
    add_paths(Json::parse(run.out), "", paths);
    for (std::string path : paths) {
      if (path.starts_with("input/a/") || path.starts_with("input/b/")) path.erase(5, 2);
      const auto next = page_.lower_bound(path);
      const bool has_none = path.ends_with("[]") && next != page_.end() && next->starts_with(path);
      EXPECT_TRUE(page_.contains(path) || has_none || is_threshold(path, help_))
          << arguments[0] << ": " << path;
    }
  }

  std::string file(const std::string& name) const { return folder_.file(name); }

  const TemporaryFolder folder_;
  const std::set<std::string> page_ = documented();
  const std::string help_ =
      run_program({"reconstruct", "--help"}).out + run_program({"boundary", "--help"}).out;
  const std::string cloud_ = folder_.write("cloud.xyz", whole_sphere(3000));
  const std::string cap_ = folder_.write("cap.xyz", sphere_cap(12000, 0.9, 0.2));
};

TEST_F(JsonReportPage, HasWhatReconstructionsReport) {
  expect_documented({"reconstruct", cloud_, "-o", file("m.ply"), "--verify", "--manifold"});
  expect_documented({"reconstruct", folder_.write("noisy.xyz", whole_sphere(800) + crumb()), "-o",
                     file("r.ply"), "--noise", "robust", "--thin", "0.01"});
  expect_documented({"reconstruct", folder_.write("far.xyz", far_from_origin(whole_sphere(800))),
                     "-o", file("far.stl")});
  expect_documented({"boundary", cap_, "-o", file("cap.ply")});
  expect_documented({"reconstruct", file("m.ply"), "-o", file("d.ply"), "--densify", "0.1"});
}

TEST_F(JsonReportPage, HasWhatUpdatesReport) {
  const std::string updated = file("u.ply");
  const std::string headed = folder_.write("headed.txt", "x y z\n" + sphere_cap(12000, 0.9, 0.2));
  expect_documented({"update", cloud_, headed, "-o", updated, "--noise", "robust"});
  expect_documented(
      {"update", cloud_, headed, "-o", updated, "--keep-groups", "0", "--replace-groups", "1"});
  expect_documented({"update", cloud_, cap_, headed, "-o", updated, "--thin", "0.01"});
  fs::create_directory(file("scans"));
  fs::copy(cap_, file("scans/cap.xyz"));
  expect_documented({"watch", cloud_, file("scans"), "-o", file("w.ply"), "--once", "--settle", "0",
                     "--thin", "0.01", "--noise", "robust"});
}

TEST_F(JsonReportPage, HasWhatOtherCommandsReport) {
  const std::string mesh = file("m.ply");
  ASSERT_EQ(run_program({"reconstruct", cloud_, "-o", mesh}).exit_code, 0);
  expect_documented({"check", mesh, "--handles", "3", "--self-intersections"});
  expect_documented({"compare", mesh, cloud_, "--tolerance", "0.1", "-o", file("deviation.ply")});
  expect_documented({"delaunay", cloud_, "-o", file("d.tet"), "--threads", "1", "--verify"});
}

// So that nothing stays on the page that the program no longer has.
TEST_F(JsonReportPage, NamesWhatTheProgramWrites) {
  std::string sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / "app")) {
    if (entry.path().extension() == ".cpp") sources += content_of(entry.path().string());
  }
  EXPECT_GT(page_.size(), 200U);
  for (std::string path : page_) {
    if (path.ends_with("/STAGE") || path.ends_with("/GROUP")) continue;
    if (path.ends_with("[]")) path.resize(path.size() - 2);
    const std::string name = path.substr(path.rfind('/') + 1);
    EXPECT_NE(sources.find(name + "\""), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace cocoon::test
