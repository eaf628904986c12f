// Sessions and the watched folder, as a user runs them.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace {

using cocoon::test::content_of;
using cocoon::test::crumb;
using cocoon::test::expect_error;
using cocoon::test::north;
using cocoon::test::ProgramRun;
using cocoon::test::run_program;
using cocoon::test::RunningProgram;
using cocoon::test::south;
using cocoon::test::TemporaryFolder;
using cocoon::test::wait_for;
using cocoon::test::Watched;
using cocoon::test::whole_sphere;

TEST(Session, UpdatesAsTheMeshAloneDoes) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.xyz", whole_sphere(2000));
  const std::string a = folder.write("a.xyz", north);
  const std::string b = folder.write("b.xyz", south);
  ASSERT_EQ(run_program({"reconstruct", points, "-o", folder.file("model.ply"), "--session",
                         folder.file("s.session")})
                .exit_code,
            0);
  for (const std::string& cloud : {a, b}) {
    const ProgramRun plain =
        run_program({"update", folder.file("model.ply"), cloud, "-o", folder.file("plain.ply"),
                     "--map", folder.file("plain.map")});
    ASSERT_EQ(plain.exit_code, 0) << plain.error;
    const ProgramRun live = run_program({"update", "--session", folder.file("s.session"), cloud,
                                         "-o", folder.file("live.ply"), "--map",
                                         folder.file("live.map"), "--json", folder.file("r.json")});
    ASSERT_EQ(live.exit_code, 0) << live.error;
    EXPECT_EQ(content_of(folder.file("plain.ply")), content_of(folder.file("live.ply")));
    EXPECT_EQ(content_of(folder.file("plain.map")), content_of(folder.file("live.map")));
    const auto report = nlohmann::json::parse(content_of(folder.file("r.json")));
    EXPECT_EQ(report["command"], "update");
    EXPECT_TRUE(report["surface"]["watertight"]);
    EXPECT_GT(report["update"]["replaced_points"], 100);
    std::filesystem::rename(folder.file("plain.ply"), folder.file("model.ply"));
  }
}

// Hollows that the first reconstruction kept.
TEST(Session, KeepsHollows) {
  const TemporaryFolder folder;
  std::istringstream lines(whole_sphere(2000));
  std::ostringstream points;
  double x = 0;
  double y = 0;
  double z = 0;
  while (lines >> x >> y >> z) {
    points << x << ' ' << y << ' ' << z << '\n' << x / 2 << ' ' << y / 2 << ' ' << z / 2 << '\n';
  }
  const std::string file = folder.write("points.xyz", points.str());
  const std::string cloud = folder.write("a.xyz", north);
  const std::string mesh = folder.file("model.ply");
  const std::string session = folder.file("s.session");
  ASSERT_EQ(
      run_program({"reconstruct", file, "-o", mesh, "--cavities", "--session", session}).exit_code,
      0);
  ASSERT_EQ(run_program({"update", mesh, cloud, "-o", folder.file("plain.ply")}).exit_code, 0);
  const ProgramRun live = run_program(
      {"update", "--session", session, cloud, "-o", folder.file("live.ply"), "--json", "-"});
  ASSERT_EQ(live.exit_code, 0) << live.error;
  EXPECT_EQ(content_of(folder.file("plain.ply")), content_of(folder.file("live.ply")));
  EXPECT_NE(live.out.find("\"components\": 2"), std::string::npos) << live.out;
}

// Updates judge all samples by the usual rho, those of the model, too.
TEST(Session, KeepsNothingThatWasFoundByAnotherRho) {
  const TemporaryFolder folder;
  const std::string part = folder.file("part");
  ASSERT_EQ(
      run_program({"sample", "golf-club", "--points", "3000", "--cloud-points", "1500", "-o", part})
          .exit_code,
      0);
  const std::string mesh = folder.file("model.ply");
  const std::string session = folder.file("s.session");
  ASSERT_EQ(run_program({"reconstruct", part + "/initial.xyz", "--rho", "0.1", "-o", mesh,
                         "--session", session})
                .exit_code,
            0);
  const std::string cloud = part + "/cloud-1.xyz";
  const std::string plain = folder.file("plain.ply");
  const std::string live = folder.file("live.ply");
  ASSERT_EQ(run_program({"update", mesh, cloud, "-o", plain}).exit_code, 0);
  ASSERT_EQ(run_program({"update", "--session", session, cloud, "-o", live}).exit_code, 0);
  EXPECT_EQ(content_of(plain), content_of(live));
}

TEST(Session, RefusesWhatDoesNotFit) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.xyz", whole_sphere(300));
  const std::string cloud = folder.write("a.xyz", north);
  const std::string mesh = folder.file("m.ply");
  const std::string session = folder.file("s");
  expect_error(
      run_program({"reconstruct", points, "-o", mesh, "--surface", "cocone", "--session", session}),
      2, "--session");
  expect_error(run_program({"update", "--session", session, cloud, "-o", mesh}), 1, "s");
  ASSERT_EQ(run_program({"reconstruct", points, "-o", mesh, "--session", session}).exit_code, 0);
  expect_error(run_program({"update", "--session", session, cloud, "-o", mesh, "--alpha", "20"}), 2,
               "leave out --alpha");
  for (const char* mode : {"paper", "robust"}) {
    expect_error(run_program({"update", "--session", session, cloud, "-o", mesh, "--mode", mode}),
                 2, "leave out --alpha");
  }
  expect_error(run_program({"update", "--session", session, "-o", mesh}), 2, "CLOUD");
  expect_error(run_program({"update", mesh, "-o", mesh}), 2, "CLOUD");
  expect_error(run_program({"update", "--session", session, cloud, "-o", session}), 2, "output");
  // A refused cloud leaves the session as it was.
  const std::string before = content_of(session);
  const std::string updated = folder.file("updated.ply");
  expect_error(run_program({"update", "--session", session, mesh, cloud, "-o", updated}), 1,
               mesh + " is no cloud but the model itself");
  expect_error(run_program({"update", mesh, points, "-o", updated}), 1, "the model itself");
  const std::string far = folder.write("far.xyz", "9 9 9\n9 9 8\n9 8 9\n8 9 9\n8 8 8\n");
  expect_error(run_program({"update", "--session", session, far, "-o", mesh}), 1, "cannot update");
  EXPECT_EQ(content_of(session), before);
}

TEST(Session, DamagedFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.xyz", whole_sphere(100));
  const std::string cloud = folder.write("a.xyz", north);
  const std::string session = folder.file("s");
  ASSERT_EQ(run_program({"reconstruct", points, "-o", folder.file("m.ply"), "--session", session})
                .exit_code,
            0);
  const std::string good = content_of(session);
  const auto refused = [&](std::string bytes) {
    folder.write("bad", bytes);
    expect_error(
        run_program({"update", "--session", folder.file("bad"), cloud, "-o", folder.file("x.ply")}),
        1, "bad: ");
    EXPECT_EQ(content_of(folder.file("bad")), bytes);
  };
  for (const std::size_t at :
       {std::size_t{3}, std::size_t{9}, std::size_t{50}, good.size() / 2, good.size() - 1}) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 4);
    refused(bad);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{16}, std::size_t{88},
                                 good.size() - 8, good.size() - 1}) {
    refused(good.substr(0, size));
  }
  refused(good + "01234567");
}

TEST(Watch, AppliesWhatIsThereAndGoesOn) {
  const Watched watched;
  watched.put("1.xyz", north);
  const ProgramRun first = run_program(watched.once());
  ASSERT_EQ(first.exit_code, 0) << first.error;
  EXPECT_NE(first.out.find("1.xyz: "), std::string::npos);
  EXPECT_NE(first.out.find("1 cloud applied"), std::string::npos) << first.out;
  watched.put("2.xyz", south);
  const ProgramRun second = run_program(watched.once());
  ASSERT_EQ(second.exit_code, 0) << second.error;
  EXPECT_NE(second.out.find("resumed with 1 cloud applied"), std::string::npos) << second.out;
  EXPECT_NE(second.out.find("1 cloud applied, 0 refused, 1 known"), std::string::npos);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north, south}));
}

TEST(Watch, KeepsGoingOnBadFilesAndStopsOnASignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Watched watched;
    const TemporaryFolder outputs;
    const RunningProgram program(outputs, watched.arguments);
    const auto said = [&](const std::string& text) {
      return wait_for(
          [&] { return content_of(outputs.file("stdout")).find(text) != std::string::npos; });
    };
    ASSERT_TRUE(said("triangles"));
    watched.put("bad.xyz", "1 2 3\nfour five six\n");
    ASSERT_TRUE(said("bad.xyz: not applied"));
    watched.put(".hidden.xyz", south);
    watched.put("notes.md", "nothing for us");
    watched.put("few.xyz", "0 0 0\n1 0 0\n");
    ASSERT_TRUE(said("few.xyz: not applied"));
    watched.put("good.xyz", north);
    ASSERT_TRUE(said("good.xyz: "));
    program.send(signal);
    const ProgramRun run = program.wait();
    EXPECT_EQ(run.exit_code, 0) << run.error;
    EXPECT_EQ(run.error, "");
    EXPECT_NE(run.out.find("1 cloud applied, 2 refused"), std::string::npos) << run.out;
    EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));
    EXPECT_TRUE(std::filesystem::exists(watched.drop + "/bad.xyz"));
  }
}

// A session resumes with the model that it began with, which therefore stays.
TEST(Watch, DoesNotReplaceItsModel) {
  const Watched watched;
  const std::string mesh = watched.folder.file("model.ply");
  ASSERT_EQ(run_program({"reconstruct", watched.arguments[1], "-o", mesh}).exit_code, 0);
  expect_error(run_program({"watch", mesh, watched.drop, "-o", mesh, "--once"}), 2,
               "is an input and would be overwritten");
}

TEST(Watch, RefusesItsModelAsACloud) {
  const Watched watched;
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  const std::string before = content_of(watched.mesh);
  watched.put("copy.ply", before);
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("copy.ply: not applied: it is the model itself"), std::string::npos)
      << run.out;
  EXPECT_EQ(content_of(watched.mesh), before);
}

// Nobody else may use the session meanwhile: what one wrote the other would overwrite.
TEST(Watch, HoldsItsSession) {
  const Watched watched;
  const TemporaryFolder outputs;
  const RunningProgram program(outputs, watched.arguments);
  ASSERT_TRUE(wait_for(
      [&] { return content_of(outputs.file("stdout")).find("triangles") != std::string::npos; }));
  const std::string session = watched.mesh + ".session";
  const std::string updated = watched.folder.file("updated.ply");
  const std::string cloud = watched.folder.write("south.xyz", south);
  const std::string model = watched.arguments[1];
  const std::string link = watched.folder.file("link");
  std::filesystem::create_symlink(session, link);
  expect_error(run_program({"update", "--session", link, cloud, "-o", updated}), 1,
               link + ": is in use by another run");
  for (const std::vector<std::string>& arguments :
       {watched.once(),
        std::vector<std::string>{"update", "--session", session, cloud, "-o", updated},
        std::vector<std::string>{"reconstruct", model, "--session", session, "-o", updated}}) {
    expect_error(run_program(arguments), 1, session + ": is in use by another run");
  }
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 0);
  const ProgramRun run = run_program({"update", "--session", session, cloud, "-o", updated});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_FALSE(std::filesystem::exists(session + ".lock"));
}

// What is doubtful is told of the model, and once of what clouds made of it.
TEST(Watch, TellsFindings) {
  const auto tells_of_parts = [](const std::string& text) {
    const std::string line = "\nwarning: 1 small part beside the main surface;";
    std::size_t count = 0;
    for (std::size_t at = text.find(line); at != text.npos; at = text.find(line, at + 1)) ++count;
    return count;
  };
  const Watched doubtful;
  doubtful.folder.write("points.xyz", whole_sphere(2000) + crumb());
  EXPECT_EQ(tells_of_parts(run_program(doubtful.once()).out), 1U);

  const Watched watched;
  const TemporaryFolder outputs;
  const RunningProgram program(outputs, watched.arguments);
  const auto out = [&] { return content_of(outputs.file("stdout")); };
  watched.put("1.xyz", north + crumb());
  EXPECT_TRUE(wait_for([&] { return tells_of_parts(out()) == 1; })) << out();
  EXPECT_LT(out().find("1.xyz: "), out().find("small part")) << out();
  watched.put("2.xyz", south);
  EXPECT_TRUE(wait_for([&] { return out().find("2.xyz: ") != std::string::npos; })) << out();
  program.send(SIGTERM);
  const ProgramRun run = program.wait();
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(tells_of_parts(run.out), 1U) << run.out;
}

// Its own mesh, report and model, with the endings of clouds, are none.
TEST(Watch, DoesNotTakeItsOwnFilesForClouds) {
  const Watched watched;
  watched.put("1.xyz", north);
  watched.put("model.xyz", whole_sphere(1500));
  const std::string mesh = watched.drop + "/live.ply";
  for (int run_number = 0; run_number < 2; ++run_number) {
    const ProgramRun run =
        run_program({"watch", watched.drop + "/model.xyz", watched.drop, "-o", mesh, "--settle",
                     "0.05", "--poll", "0.02", "--json", watched.drop + "/report.txt", "--once"});
    ASSERT_EQ(run.exit_code, 0) << run.error;
    EXPECT_EQ(run.out.find("not applied"), std::string::npos) << run.out;
    const char* counts[] = {"1 cloud applied, 0 refused, 0 known from before",
                            "0 clouds applied, 0 refused, 1 known from before"};
    EXPECT_NE(run.out.find(counts[run_number]), std::string::npos) << run.out;
  }
  EXPECT_EQ(content_of(mesh), watched.expected({north}));
}

// A file that is written slowly is taken when it is complete, not before.
TEST(Watch, WaitsForTheEndOfAFile) {
  const Watched watched;
  std::vector<std::string> arguments = watched.arguments;
  arguments[8] = "0.5";
  const TemporaryFolder outputs;
  const RunningProgram program(outputs, arguments);
  const std::size_t half = north.find('\n', north.size() / 2) + 1;
  {
    std::ofstream file(watched.drop + "/slow.xyz");
    file << north.substr(0, half) << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    file << north.substr(half);
  }
  ASSERT_TRUE(wait_for(
      [&] { return content_of(outputs.file("stdout")).find("slow.xyz: ") != std::string::npos; }));
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 0);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));
}

// The lock is taken before the model is read.
TEST(Watch, StopsCleanlyWhileItReadsItsModel) {
  const Watched watched;
  std::vector<std::string> arguments = watched.arguments;
  arguments[1] = watched.folder.write("large.xyz", whole_sphere(100000));
  const std::string report = watched.folder.write("report.json", "an older one");
  arguments.insert(arguments.end(), {"--json", report});
  const TemporaryFolder outputs;
  const RunningProgram program(outputs, arguments);
  ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(watched.mesh + ".session.lock"); }));
  program.send(SIGTERM);
  const ProgramRun run = program.wait();
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(run.error, "");
  EXPECT_NE(run.out.find("stopped before it watched; no file was changed"), std::string::npos)
      << run.out;
  EXPECT_FALSE(std::filesystem::exists(watched.mesh));
  EXPECT_EQ(content_of(report), "an older one");
}

// The time of a file may be that of another machine.
TEST(Watch, TakesAFileFromAClockThatIsAhead) {
  const Watched watched;
  const TemporaryFolder outputs;
  watched.put("1.xyz", north);
  std::filesystem::last_write_time(
      watched.drop + "/1.xyz",
      std::filesystem::file_time_type::clock::now() + std::chrono::hours(24));
  const RunningProgram program(outputs, watched.once());
  const bool stopped = wait_for([&] {
    return content_of(outputs.file("stdout")).find("1 cloud applied") != std::string::npos;
  });
  EXPECT_TRUE(stopped);
  if (!stopped) program.send(SIGKILL);
  program.wait();
}

// Killed at any moment, it neither loses a cloud nor applies one twice.
TEST(Watch, ResumesAfterAKill) {
  const Watched watched;
  watched.put("1.xyz", north);
  watched.put("2.xyz", south);
  std::filesystem::last_write_time(
      watched.drop + "/2.xyz",
      std::filesystem::last_write_time(watched.drop + "/1.xyz") + std::chrono::milliseconds(5));
  for (int milliseconds : {5, 60, 120, 180, 240, 300, 400, 500, 700}) {
    const TemporaryFolder outputs;
    const RunningProgram program(outputs, watched.arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().signal, SIGKILL);
  }
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("0 refused"), std::string::npos) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north, south}));
}

// Killed after one cloud was applied: the session is as it began, the cloud is beside it.
class KilledWatch : public Watched {
 public:
  explicit KilledWatch(const std::vector<std::string>& more = {}) {
    put("1.xyz", north);
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    const TemporaryFolder outputs;
    const RunningProgram program(outputs, all);
    EXPECT_TRUE(wait_for(
        [&] { return content_of(outputs.file("stdout")).find("1.xyz: ") != std::string::npos; }));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().signal, SIGKILL);
  }
  std::string session = mesh + ".session";
  std::string pending = session + ".cloud-1";
};

TEST(PendingClouds, AreTakenUpByTheNextUpdate) {
  const KilledWatch watched;
  EXPECT_TRUE(std::filesystem::exists(watched.pending));
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));
  const std::string updated = watched.folder.file("updated.ply");
  const ProgramRun run = run_program({"update", "--session", watched.session,
                                      watched.folder.write("south.xyz", south), "-o", updated});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(content_of(updated), watched.expected({north, south}));
  EXPECT_FALSE(std::filesystem::exists(watched.pending));
}

TEST(PendingClouds, AreMergedWhenTheWatchStopsOrIfAskedForEach) {
  const KilledWatch watched;
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(watched.pending));
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));
  const KilledWatch eager({"--save-every", "1"});
  EXPECT_FALSE(std::filesystem::exists(eager.pending));
  const ProgramRun run = run_program(eager.once());
  EXPECT_NE(run.out.find("resumed with 1 cloud applied"), std::string::npos) << run.out;
}

// Killed when the session had been written, but its clouds were not yet removed.
TEST(PendingClouds, ThatTheSessionHasAreRemoved) {
  const KilledWatch watched;
  const std::string before = content_of(watched.pending);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  std::ofstream(watched.pending, std::ios::binary) << before;
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_FALSE(std::filesystem::exists(watched.pending));
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));

  // So are those of the session in whose place a new one is put.
  std::ofstream(watched.pending, std::ios::binary) << before;
  ASSERT_EQ(run_program({"reconstruct", watched.arguments[1], "-o", watched.mesh, "--session",
                         watched.session})
                .exit_code,
            0);
  EXPECT_FALSE(std::filesystem::exists(watched.pending));
}

// They are applied again with the rho of their time.
TEST(PendingClouds, KeepTheirRho) {
  const KilledWatch watched({"--rho", "0.25"});
  const std::string before = content_of(watched.mesh);
  std::filesystem::remove(watched.mesh);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  EXPECT_EQ(content_of(watched.mesh), before);
}

TEST(PendingClouds, AreRefusedIfDamagedOrOfAnotherSession) {
  const KilledWatch watched;
  const std::string good = content_of(watched.pending);
  for (const std::size_t at : {std::size_t{0}, std::size_t{9}, std::size_t{40}, good.size() / 2}) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 4);
    watched.folder.write(std::filesystem::path(watched.pending).filename().string(), bad);
    expect_error(run_program(watched.once()), 1, "out.ply.session.cloud-1");
  }
  watched.folder.write(std::filesystem::path(watched.pending).filename().string(),
                       good.substr(0, good.size() - 8));
  expect_error(run_program(watched.once()), 1, "checksum");

  // A session begun anew does not know them, and takes the clouds from the folder.
  watched.folder.write(std::filesystem::path(watched.pending).filename().string(), good);
  std::filesystem::remove(watched.session);
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_NE(run.out.find("1 cloud applied, 0 refused, 0 known"), std::string::npos) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));

  // Of a session with other notes: this one knows of no cloud, that one followed a cloud.
  const KilledWatch two;
  const std::string first = content_of(two.pending);
  ASSERT_EQ(run_program(two.once()).exit_code, 0);
  std::ofstream(two.session + ".cloud-2", std::ios::binary) << first;
  expect_error(run_program(two.once()), 1, "follows another session");
}

TEST(Watch, SaysWhatIsWrongBeforeItStarts) {
  const Watched watched;
  expect_error(run_program({"watch", watched.arguments[1], watched.folder.file("missing"), "-o",
                            watched.mesh}),
               1, "no such folder");
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  std::vector<std::string> other = watched.once();
  other[1] = watched.folder.write("other.xyz", whole_sphere(800));
  expect_error(run_program(other), 1, "another model");
  std::vector<std::string> changed = watched.once();
  changed.insert(changed.end(), {"--alpha", "25"});
  expect_error(run_program(changed), 1, "other parameters");
}

}  // namespace
