// A folder that `cocoon watch` follows, and clouds for it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {

// The south pole's cap: the other end of the sphere.
inline std::string south_cap(std::size_t n, double reach, double bump) {
  std::string text;
  std::istringstream lines(sphere_cap(n, reach, bump));
  double x = 0;
  double y = 0;
  double z = 0;
  while (lines >> x >> y >> z) text += point_line(x, -y, -z);
  return text;
}

inline const std::string north = sphere_cap(4000, 0.8, 0.2);
inline const std::string south = south_cap(4000, 0.8, -0.2);

inline bool wait_for(const std::function<bool()>& condition) {
  for (int i = 0; i < 6000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

struct Watched {
  TemporaryFolder folder;
  std::string drop = folder.file("drop");
  std::string mesh = folder.file("out.ply");
  std::vector<std::string> arguments;

  Watched() {
    std::filesystem::create_directory(drop);
    arguments = {"watch", folder.write("points.xyz", whole_sphere(1500)),
                 drop,    "-o",
                 mesh,    "--poll",
                 "0.02",  "--settle",
                 "0.05",  "--threads",
                 "1"};
  }
  // As a careful scanner does: complete when it appears.
  void put(const std::string& name, const std::string& content) const {
    const std::string part = folder.write("part", content);
    std::filesystem::rename(part, drop + "/" + name);
  }
  std::vector<std::string> once() const {
    std::vector<std::string> once = arguments;
    once.push_back("--once");
    return once;
  }
  // What updates of the program itself give, each by one of the clouds.
  std::string expected(const std::vector<std::string>& clouds) const {
    std::vector<std::vector<std::string>> updates;
    updates.reserve(clouds.size());
    for (const std::string& cloud : clouds) updates.push_back({cloud});
    return expected_of_updates(updates);
  }
  // Each by several clouds together.
  std::string expected_of_updates(const std::vector<std::vector<std::string>>& updates) const {
    std::string model = arguments[1];
    for (std::size_t k = 0; k < updates.size(); ++k) {
      const std::string next = folder.file("expected" + std::to_string(k) + ".ply");
      std::vector<std::string> command = {"update", model};
      for (std::size_t c = 0; c < updates[k].size(); ++c) {
        command.push_back(folder.write("expected" + std::to_string(c) + ".xyz", updates[k][c]));
      }
      command.insert(command.end(), {"-o", next});
      EXPECT_EQ(run_program(command).exit_code, 0);
      model = next;
    }
    return content_of(model);
  }
};

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

// `cocoon watch` while it runs, and how often it has said something.
struct Watching {
  explicit Watching(const std::vector<std::string>& arguments, void (*limit)() = nullptr)
      : program(outputs, arguments, limit) {
    EXPECT_TRUE(has_said(": "));
  }
  bool has_said(const std::string& text, std::size_t times = 1) const {
    return wait_for([&] { return count(content_of(outputs.file("stdout")), text) >= times; });
  }
  std::string end(int signal) const {
    program.send(signal);
    return program.wait().out;
  }
  TemporaryFolder outputs;
  RunningProgram program;
};

}  // namespace cocoon::test
