#include "app/command_line.h"

#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace cocoon::app {
namespace {

Request parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cocoon");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

template <class Arguments>
Arguments parsed(const std::vector<const char*>& arguments) {
  return std::get<Arguments>(std::get<CommandLine>(parse(arguments)).command);
}

TEST(CommandLine, ReconstructHasDocumentedDefaults) {
  const auto arguments = parsed<ReconstructArguments>({"reconstruct", "a.xyz", "-o", "a.ply"});
  EXPECT_EQ(arguments.points, "a.xyz");
  EXPECT_EQ(arguments.mesh, "a.ply");
  EXPECT_EQ(arguments.surface, SurfaceKind::tight);
  EXPECT_EQ(arguments.parameters.mode, Mode::robust);
  EXPECT_FALSE(arguments.parameters.rho.has_value());
  EXPECT_FALSE(arguments.writing.ascii);
  EXPECT_FALSE(arguments.writing.single_precision);
}

TEST(CommandLine, OldNamesOfTheParametersAreAliases) {
  const auto arguments = parsed<ReconstructArguments>(
      {"reconstruct", "a.xyz", "-o", "a.ply", "-c", "20", "-s", "50", "-f", "25", "-r", "0.3"});
  EXPECT_EQ(arguments.parameters.cocone_angle_deg, 20.0);
  EXPECT_EQ(arguments.parameters.sharp_angle_deg, 50.0);
  EXPECT_EQ(arguments.parameters.alpha_deg, 25.0);
  EXPECT_EQ(arguments.parameters.rho, 0.3);
}

TEST(CommandLine, ThresholdsOfStagesAreTakenByName) {
  const auto arguments =
      parsed<ReconstructArguments>({"reconstruct", "a.xyz", "-o", "a.ply", "--evidence-weight", "2",
                                    "--fold-angle", "30", "--no-clean-up"});
  EXPECT_EQ(arguments.thresholds,
            (std::map<std::string, double>{{"evidence-weight", 2}, {"fold-angle", 30}}));
  EXPECT_FALSE(arguments.clean_up);
  const auto plain = parsed<ReconstructArguments>({"reconstruct", "a.xyz", "-o", "a.ply"});
  EXPECT_TRUE(plain.thresholds.empty());
  EXPECT_TRUE(plain.clean_up);
  EXPECT_THROW(parse({"reconstruct", "a.xyz", "-o", "a.ply", "--fold-angle", "200"}), UsageError);
}

TEST(CommandLine, RadiusSeedingAndNoiseFilterAreOptions) {
  const auto arguments = parsed<ReconstructArguments>(
      {"reconstruct", "a.xyz", "-o", "a.ply", "--radius", "cocone", "--no-deferred-seeding",
       "--noise", "robust", "--noise-skin-only", "--noise-spacing-only", "--noise-neighbors", "5"});
  EXPECT_EQ(arguments.radius, RadiusMode::cocone);
  EXPECT_EQ(arguments.noise, NoiseHandling::robust);
  EXPECT_FALSE(arguments.deferred_seeding);
  EXPECT_FALSE(arguments.noise_keep_good);
  EXPECT_FALSE(arguments.noise_spare_good);
  EXPECT_EQ(arguments.thresholds, (std::map<std::string, double>{{"noise-neighbors", 5}}));
  const auto plain = parsed<ReconstructArguments>({"reconstruct", "a.xyz", "-o", "a.ply"});
  EXPECT_EQ(plain.radius, std::nullopt);
  EXPECT_EQ(plain.noise, NoiseHandling::none);
  EXPECT_TRUE(plain.deferred_seeding && plain.noise_keep_good && plain.noise_spare_good);
  EXPECT_THROW(parse({"reconstruct", "a.xyz", "-o", "a.ply", "--radius", "ball"}), UsageError);
  const auto open = parsed<BoundaryArguments>(
      {"boundary", "a.xyz", "-o", "a.ply", "--radius", "tangent-plane", "--min-loop-edges", "3"});
  EXPECT_EQ(open.radius, RadiusMode::tangent_plane);
  EXPECT_EQ(open.thresholds, (std::map<std::string, double>{{"min-loop-edges", 3}}));
  EXPECT_THROW(parse({"boundary", "a.xyz", "-o", "a.ply", "--idle-cost", "3"}), UsageError);
}

TEST(CommandLine, ChoicesAreWords) {
  const auto open = parsed<ReconstructArguments>(
      {"reconstruct", "a.xyz", "-o", "a.ply", "--surface", "cocone", "--mode", "paper"});
  EXPECT_EQ(open.surface, SurfaceKind::cocone);
  EXPECT_EQ(open.parameters.mode, Mode::paper);
  const auto update = parsed<UpdateArguments>(
      {"update", "m.ply", "c.xyz", "-o", "u.ply", "--noise", "robust", "--mode", "robust"});
  EXPECT_EQ(update.filter.noise, NoiseHandling::robust);
  EXPECT_EQ(update.parameters.mode, Mode::robust);
  for (const char* option : {"--surface", "--mode", "--noise", "--radius"}) {
    EXPECT_THROW(parse({"reconstruct", "a.xyz", "-o", "a.ply", option, "0"}), UsageError) << option;
    EXPECT_THROW(parse({"reconstruct", "a.xyz", "-o", "a.ply", option, ""}), UsageError) << option;
  }
}

TEST(CommandLine, UpdateTakesAnyNumberOfClouds) {
  const auto arguments = parsed<UpdateArguments>(
      {"update", "m.ply", "c1.xyz", "c2.xyz", "-o", "u.ply", "--map", "m.txt", "--html", "r.html"});
  EXPECT_EQ(arguments.model, "m.ply");
  EXPECT_EQ(arguments.clouds, (std::vector<std::string>{"c1.xyz", "c2.xyz"}));
  EXPECT_EQ(arguments.mesh, "u.ply");
  EXPECT_EQ(arguments.map, "m.txt");
  EXPECT_EQ(arguments.html, "r.html");
}

TEST(CommandLine, UpdateTakesCloudsBehindTheOptionsToo) {
  const auto arguments = parsed<UpdateArguments>({"update", "-o", "u.ply", "m.ply", "c1.xyz"});
  EXPECT_EQ(arguments.model, "m.ply");
  EXPECT_EQ(arguments.clouds, (std::vector<std::string>{"c1.xyz"}));
}

TEST(CommandLine, ASessionTakesThePlaceOfTheModel) {
  const auto arguments =
      parsed<UpdateArguments>({"update", "--session", "s", "c1.xyz", "c2.xyz", "-o", "u.ply"});
  EXPECT_EQ(arguments.model, "");
  EXPECT_EQ(arguments.session, "s");
  EXPECT_EQ(arguments.clouds, (std::vector<std::string>{"c1.xyz", "c2.xyz"}));
  EXPECT_EQ(parsed<ReconstructArguments>({"reconstruct", "p.xyz", "-o", "m.ply", "--session", "s"})
                .session,
            "s");
}

TEST(CommandLine, WatchNeedsModelFolderAndMesh) {
  const auto arguments = parsed<WatchArguments>(
      {"watch", "m.ply", "scans", "-o", "l.ply", "--poll", "0.1", "--settle", "2", "--once"});
  EXPECT_EQ(arguments.model, "m.ply");
  EXPECT_EQ(arguments.folder, "scans");
  EXPECT_EQ(arguments.poll, 0.1);
  EXPECT_EQ(arguments.settle, 2.0);
  EXPECT_TRUE(arguments.once);
  EXPECT_EQ(arguments.session, "");
}

TEST(CommandLine, SampleAndDemo) {
  const auto sample = parsed<SampleArguments>(
      {"sample", "golf-club", "--points", "100", "--cloud-points", "50", "--seed", "7"});
  EXPECT_EQ(sample.name, "golf-club");
  EXPECT_EQ(sample.points, 100U);
  EXPECT_EQ(sample.cloud_points, 50U);
  EXPECT_EQ(sample.seed, 7U);
  const auto largest =
      parsed<SampleArguments>({"sample", "block", "--seed", "18446744073709551615"});
  EXPECT_EQ(largest.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(parsed<DemoArguments>({"demo", "-o", "there"}).folder, "there");
}

// As `seq -w` counts; not octal, as in C.
TEST(CommandLine, LeadingZerosMeanNothing) {
  const auto sample = parsed<SampleArguments>(
      {"sample", "block", "--points", "0400", "--cloud-points", "010000", "--seed", "08"});
  EXPECT_EQ(sample.points, 400U);
  EXPECT_EQ(sample.cloud_points, 10000U);
  EXPECT_EQ(sample.seed, 8U);
  EXPECT_EQ(parsed<SampleArguments>({"sample", "block", "--seed", "000"}).seed, 0U);
  EXPECT_EQ(parsed<CompareArguments>({"compare", "a", "b", "--samples", "010"}).samples, 10U);
}

TEST(CommandLine, RequirementsAreAListOfWords) {
  const auto check = parsed<CheckArguments>(
      {"check", "m.ply", "--require", "closed,manifold,oriented", "--self-intersections"});
  EXPECT_EQ(check.required, (std::vector<std::string>{"closed", "manifold", "oriented"}));
  EXPECT_TRUE(check.self_intersections);
  const auto before = parsed<CheckArguments>({"check", "--require", "closed", "m.ply"});
  EXPECT_EQ(before.required, (std::vector<std::string>{"closed"}));
  EXPECT_EQ(before.mesh, "m.ply");
  EXPECT_EQ(parsed<CheckArguments>({"check", "m.ply", "--handles", "3"}).handles, 3U);
}

TEST(CommandLine, RemainingCommands) {
  EXPECT_EQ(parsed<DelaunayArguments>({"delaunay", "p.xyz", "-o", "p.vtu"}).file, "p.vtu");
  EXPECT_EQ(parsed<CompareArguments>({"compare", "a", "b", "--samples", "10"}).samples, 10U);
  EXPECT_EQ(
      parsed<BoundaryArguments>({"boundary", "p.xyz", "-o", "b.ply", "--loops", "l.obj"}).loops,
      "l.obj");
}

TEST(CommandLine, SharedOptionsStandBeforeOrBehindTheCommand) {
  for (const std::vector<const char*>& arguments :
       {std::vector<const char*>{"--threads", "3", "--json", "-", "--quiet", "demo"},
        std::vector<const char*>{"demo", "--threads", "3", "--json", "-", "--quiet"}}) {
    const auto line = std::get<CommandLine>(parse(arguments));
    EXPECT_EQ(line.shared.threads, 3);
    EXPECT_EQ(line.shared.json, "-");
    EXPECT_TRUE(line.shared.quiet);
  }
}

TEST(CommandLine, HelpAndVersionAreTexts) {
  EXPECT_EQ(std::get<TextRequest>(parse({"--version"})).text.rfind("cocoon ", 0), 0U);
  EXPECT_EQ(std::get<TextRequest>(parse({"update", "--version"})).text.rfind("cocoon ", 0), 0U);
  const std::string help = std::get<TextRequest>(parse({"--help"})).text;
  for (const char* name : {"demo", "sample", "reconstruct", "boundary", "update", "watch",
                           "delaunay", "check", "compare"}) {
    EXPECT_NE(help.find(name), std::string::npos) << name;
  }
  const std::string update_help = std::get<TextRequest>(parse({"update", "--help"})).text;
  EXPECT_NE(update_help.find("--threads"), std::string::npos);
  EXPECT_NE(update_help.find("--html"), std::string::npos);
}

TEST(CommandLine, HelpOfACommandIsAsOneTypesIt) {
  for (const char* name : {"demo", "sample", "reconstruct", "boundary", "update", "watch",
                           "delaunay", "check", "compare"}) {
    const std::string help = std::get<TextRequest>(parse({name, "--help"})).text;
    EXPECT_NE(help.find(std::string("Usage: cocoon ") + name + " "), std::string::npos) << help;
    EXPECT_EQ(help.find("{false}"), std::string::npos) << help;
  }
}

std::string help_of(const char* command) {
  return std::get<TextRequest>(parse({command, "--help"})).text;
}

// Without a run that writes a report. Lines of the help are not broken.
TEST(CommandLine, HelpHasDefaultsOfNumbers) {
  const auto expect_default = [](const char* command, const std::string& text) {
    EXPECT_NE(help_of(command).find(text), std::string::npos) << command << ": " << text;
  };
  for (const char* command : {"reconstruct", "boundary", "update", "watch"}) {
    expect_default(command, "normals of cocone neighbors (30)");
    expect_default(command, "about the tangent plane (22.5)");
    expect_default(command, "triangles are pruned (60)");
  }
  expect_default("reconstruct", "flatter than this dihedral angle, stay (134.427)");
  expect_default("reconstruct", "all cells (0.5)");
  expect_default("reconstruct",
                 "Noise filter: spacing of outliers, in spacings of their neighbors (3)");
  expect_default("update", "Noise filter: spacing of outliers, in spacings of their neighbors (2)");
  expect_default("boundary", "in median edges of the surface (12)");
}

// A session of `watch` does not keep them.
TEST(CommandLine, HelpPromisesPropertiesWhereTheyAreKept) {
  const auto promises = [](const char* command) {
    return help_of(command).find("PLY also keeps") != std::string::npos;
  };
  EXPECT_TRUE(promises("reconstruct") && promises("boundary") && promises("update"));
  EXPECT_FALSE(promises("watch"));
}

// Also behind the options that may come before it.
TEST(CommandLine, AMisspelledCommandIsNamed) {
  for (const std::vector<const char*>& before : std::vector<std::vector<const char*>>{
           {}, {"--quiet"}, {"--threads", "1"}, {"--threads=1", "--json", "a.json", "--verbose"}}) {
    std::vector<const char*> arguments = before;
    arguments.insert(arguments.end(), {"recnstruct", "a.xyz", "-o", "a.ply"});
    try {
      parse(arguments);
      ADD_FAILURE() << before.size();
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()).find("'recnstruct' is no command; there are "), 0U)
          << error.what();
    }
  }
}

TEST(CommandLine, AWrongOptionPointsToTheHelpOfItsCommand) {
  const auto told = [](const std::vector<const char*>& arguments) -> std::string {
    try {
      parse(arguments);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(told({"check", "a.ply", "--wrong"}).find("(see cocoon check --help)"),
            std::string::npos);
  EXPECT_NE(told({"--wrong"}).find("(see cocoon --help)"), std::string::npos);
  EXPECT_NE(told({}).find("(see cocoon --help)"), std::string::npos);
}

TEST(CommandLine, WhatIsMissingIsNamed) {
  const auto expect_missing = [](const std::vector<const char*>& arguments,
                                 const std::string& what) {
    const std::string command = arguments[0];
    try {
      parse(arguments);
      ADD_FAILURE() << "accepted without " << what;
    } catch (const UsageError& error) {
      EXPECT_EQ(error.what(), what + " is required (see cocoon " + command + " --help)");
    }
  };
  expect_missing({"update", "-o", "u.ply"}, "MODEL");
  expect_missing({"update", "m.ply", "-o", "u.ply"}, "CLOUD");
  expect_missing({"update", "--session", "s", "-o", "u.ply"}, "CLOUD");
  expect_missing({"watch", "--session", "s", "-o", "u.ply"}, "MODEL");
}

std::string complaint(const std::vector<const char*>& arguments) {
  try {
    parse(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

// As of variables of a shell that are not set.
TEST(CommandLine, EmptyValuesAreNoFileNames) {
  const std::string told = ": the value is empty; give one";
  EXPECT_EQ(complaint({"reconstruct", "a.xyz", "-o", ""}), "--output" + told);
  EXPECT_EQ(complaint({"reconstruct", "a.xyz", "-o", "a.ply", "--session", ""}),
            "--session" + told);
  EXPECT_EQ(complaint({"boundary", "a.xyz", "-o", "a.ply", "--loops", ""}), "--loops" + told);
  EXPECT_EQ(complaint({"update", "a.ply", "b.xyz", "-o", "a.ply", "--map", ""}), "--map" + told);
  EXPECT_EQ(complaint({"update", "a.ply", "b.xyz", "-o", "a.ply", "--html", ""}), "--html" + told);
  EXPECT_EQ(complaint({"update", "a.ply", "b.xyz", "", "-o", "a.ply"}), "CLOUD" + told);
  EXPECT_EQ(complaint({"sample", "block", "-o", ""}), "--output" + told);
  EXPECT_EQ(complaint({"check", "a.ply", "--json", ""}), "--json" + told);
  EXPECT_EQ(complaint({"--json", "", "check", "a.ply"}), "--json" + told);
  EXPECT_EQ(complaint({"check", ""}), "MESH" + told);
  EXPECT_EQ(complaint({"compare", "a.ply", "b.ply", "--tolerance", ""}), "--tolerance" + told);
  EXPECT_EQ(complaint({"update", "a.ply", "b.xyz", "-o", "c.ply", "--keep-groups", ""}),
            "--keep-groups" + told);
}

// Alone, in the order given, and before what is missing because of it.
TEST(CommandLine, WhatACommandDoesNotHaveIsNamed) {
  EXPECT_EQ(complaint({"check", "a.ply", "--bogus", "value", "more"}),
            "cocoon check has no option --bogus (see cocoon check --help)");
  EXPECT_EQ(complaint({"reconstruct", "a.xyz", "--outptu=b.ply"}),
            "cocoon reconstruct has no option --outptu (see cocoon reconstruct --help)");
  EXPECT_EQ(complaint({"--bogus", "check", "a.ply"}),
            "cocoon check has no option --bogus (see cocoon check --help)");
  EXPECT_EQ(complaint({"check", "a.ply", "b.ply", "c.ply"}),
            "cocoon check has no place for b.ply c.ply (see cocoon check --help)");
  EXPECT_EQ(complaint({"check", "a.ply", "--config", "a.ini"}),
            "cocoon check has no option --config; options are given on the command line alone (see "
            "cocoon check --help)");
}

TEST(CommandLine, RepeatedOptionsAreNamed) {
  EXPECT_EQ(complaint({"reconstruct", "a.xyz", "-o", "a.ply", "-o", "b.ply"}),
            "--output: is given 2 times; give it once (see cocoon reconstruct --help)");
}

TEST(CommandLine, WrongOnesAreUsageErrorsOfOneLine) {
  const std::vector<std::vector<const char*>> wrong = {
      {},
      {"no-such-command"},
      {"reconstruct"},
      {"reconstruct", "a.xyz"},
      {"reconstruct", "a.xyz", "-o"},
      {"reconstruct", "a.xyz", "b.xyz", "-o", "a.ply"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--surface", "round"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--rho", "1.2"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--rho", "much"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--rho", "nan"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--mode", "careless"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--no-such-option"},
      {"update", "m.ply", "-o", "u.ply"},
      {"update", "--session", "s", "c.xyz", "-o", "u.ply", "--mode", "paper"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--surface", "cocone", "--session", "s"},
      {"watch", "m.ply", "-o", "u.ply"},
      {"watch", "m.ply", "scans", "-o", "u.ply", "--poll", "0"},
      {"sample", "teapot"},
      {"sample", "block", "--points", "-5"},
      {"sample", "block", "--points", ""},
      {"sample", "block", "--points", "18446744073709551626"},
      {"sample", "block", "--cloud-points", "-5"},
      {"sample", "block", "--cloud-points", ""},
      {"--json", "a.json", "check", "m.ply", "--json", "b.json"},
      {"--threads", "1", "check", "m.ply", "--threads", "2"},
      {"sample", "block", "--seed", "-1"},
      {"sample", "block", "--seed", ""},
      {"sample", "block", "--seed", " 7"},
      {"sample", "block", "--seed", "7 8"},
      {"sample", "block", "--seed", "7.5"},
      {"sample", "block", "--seed", "18446744073709551616"},
      {"compare", "a.ply", "b.ply", "--samples", "-1"},
      {"compare", "a.ply", "b.ply", "--samples", ""},
      {"compare", "a.ply", "b.ply", "--samples", "18446744073709551626"},
      {"compare", "a.ply", "b.ply", "--samples", "100000001"},
      {"watch", "m.ply", "scans", "-o", "u.ply", "--save-every", "-1"},
      {"watch", "m.ply", "scans", "-o", "u.ply", "--save-every", ""},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise-neighbors", ""},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise-neighbors", "18446744073709551626"},
      {"demo", "--threads", ""},
      {"demo", "--threads", "-1"},
      {"demo", "--threads", "many"},
      {"check", "m.ply", "--require", "beautiful"},
      {"compare", "a.ply"},
      {"compare", "a.ply", "b.ply", "--tolerance", "-1"},
      {"compare", "a.ply", "b.ply", "--float"},
      {"compare", "a.ply", "b.ply", "--ascii"},
      {"reconstruct", "a.xyz", "-o", "a.obj", "--float"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise-neighbors", "5"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise", "robust", "--surface", "cocone"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise", "robust", "--session", "s"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--noise", "robust", "--densify", "1"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--surface", "cocone", "--trim", "8"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--surface", "cocone", "--no-clean-up"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--session", "s", "--radius", "cocone"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--session", "s", "--trim", "8"},
      {"reconstruct", "a.xyz", "-o", "a.ply", "--thin", "1", "--densify", "1"},
      {"boundary", "a.xyz", "-o", "a.obj", "--label-samples"},
      {"update", "m.ply", "c.xyz", "-o", "u.stl", "--map", "map.txt"},
      {"update", "m.ply", "c.xyz", "-o", "u.ply", "--noise-neighbors", "5"},
      {"watch", "m.ply", "scans", "-o", "u.ply", "--noise-neighbors", "5"},
      {"update", "m.ply", "c.xyz", "-o", "u.stl", "--float"},
  };
  for (const auto& arguments : wrong) {
    std::string line;
    for (const char* argument : arguments) line += std::string(" ") + argument;
    try {
      parse(arguments);
      ADD_FAILURE() << "accepted:" << line;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace cocoon::app
