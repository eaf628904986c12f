#include "app/report/findings.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace cocoon::app {
namespace {

// The message of the only finding, without its numbers' tail.
std::string said(const SurfaceDoubts& doubts, const std::string& until) {
  const std::vector<Finding> findings = findings_of(doubts, 10, NoiseFilter::not_used);
  EXPECT_EQ(findings.size(), 1U);
  if (findings.size() != 1) return "";
  return findings[0].message.substr(0, findings[0].message.find(until));
}

const std::vector<DoubtfulSpot> one_spot{{{1, 2, 3}, 1, 0.5}};

TEST(Findings, PartsAreCountedInGoodGrammar) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.fragments = 1;
  doubts.dust = one_spot;
  EXPECT_EQ(said(doubts, " and is"), "1 small part beside the main surface; it has 1 triangle");
  doubts.fragments = 2;
  doubts.dust[0].count = 4;
  EXPECT_EQ(said(doubts, " and is"),
            "2 small parts beside the main surface; the largest has 4 triangles");
}

TEST(Findings, ContactsNameOnlyWhatThereIs) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.contacts = one_spot;
  doubts.pinched_vertices = 1;
  EXPECT_EQ(said(doubts, ","), "the surface touches itself at 1 vertex");
  doubts.bad_edges = 2;
  EXPECT_EQ(said(doubts, ","), "the surface touches itself at 2 edges and 1 vertex");
  doubts.pinched_vertices = 0;
  doubts.bad_edges = 1;
  EXPECT_EQ(said(doubts, ","), "the surface touches itself at 1 edge");
}

// `watch` does not have the option.
TEST(Findings, ContactsNameManifoldWhereItIsAnOption) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.contacts = one_spot;
  doubts.bad_edges = 1;
  const auto message = [&](bool manifold) {
    return findings_of(doubts, 10, NoiseFilter::no_option, {}, {.manifold = manifold})[0].message;
  };
  EXPECT_NE(message(true).find("; --manifold parts the sheets"), std::string::npos);
  EXPECT_EQ(message(false).find("--manifold"), std::string::npos);
}

TEST(Findings, SparseSamplesAreCountedWithThoseBesideGaps) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = one_spot;
  doubts.gap_samples = 1;
  EXPECT_EQ(said(doubts, ";"),
            "samples are too sparse, or edges too sharp, at 1 sample beside gaps");
  doubts.boundary_samples = 3;
  EXPECT_EQ(said(doubts, ";"),
            "samples are too sparse, or edges too sharp, at 3 samples (1 more is beside gaps)");
  doubts.gap_samples = 0;
  EXPECT_EQ(said(doubts, ";"), "samples are too sparse, or edges too sharp, at 3 samples");
}

// A long edge spans what was not scanned; one without a length leads to a stray point.
TEST(Findings, LongEdgesNameTrimWhereItIsAnOption) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = one_spot;
  doubts.gap_samples = 1;
  const auto names_trim = [&](double longest, bool is_option) {
    doubts.sparse[0].size = longest;
    const Finding finding =
        findings_of(doubts, 10, NoiseFilter::no_option, {}, {.trim = is_option})[0];
    return finding.message.find("(--trim 8)") != std::string::npos;
  };
  EXPECT_FALSE(names_trim(1.4, true));
  EXPECT_TRUE(names_trim(1.6, true));
  EXPECT_FALSE(names_trim(1.6, false));
  EXPECT_FALSE(names_trim(std::numeric_limits<double>::infinity(), true));
}

// The finding of one kind; it must be there.
Finding finding_of(const SurfaceDoubts& doubts, const std::string& kind,
                   NoiseFilter filter = NoiseFilter::not_used) {
  for (const Finding& finding : findings_of(doubts, 1000, filter)) {
    if (finding.kind == kind) return finding;
  }
  ADD_FAILURE() << "no finding: " << kind;
  return {};
}

// Right surfaces, too, have sparse samples at their sharp edges.
TEST(Findings, SparseSamplesAreANoteUnlessTheSurfaceIsAGuess) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = one_spot;
  doubts.boundary_samples = 500;
  doubts.samples = 1000;
  doubts.unsurrounded_samples = 199;
  EXPECT_FALSE(finding_of(doubts, "sparse").warns);
  doubts.unsurrounded_samples = 210;
  const Finding finding = finding_of(doubts, "sparse");
  EXPECT_TRUE(finding.warns);
  EXPECT_NE(finding.message.find("; the surface is a guess at 21 % of them all; "),
            std::string::npos)
      << finding.message;
}

// Where samples are too few, or all of them noisy, overlapping scans are not the reason.
TEST(Findings, ScansMayOverlapWhereOnlySomeOfTheSurfaceIsAGuess) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.samples = 1000;
  doubts.conflicts = 9;
  const auto names_filter = [&](NoiseFilter filter) {
    return finding_of(doubts, "conflicts", filter).message.find("--noise robust") !=
           std::string::npos;
  };
  EXPECT_TRUE(names_filter(NoiseFilter::not_used));
  EXPECT_FALSE(names_filter(NoiseFilter::used));
  EXPECT_FALSE(names_filter(NoiseFilter::no_option));
  EXPECT_FALSE(names_filter(NoiseFilter::not_used_on_mesh));
  doubts.unsurrounded_samples = 300;
  EXPECT_FALSE(names_filter(NoiseFilter::not_used));
  doubts.unsurrounded_samples = 0;
  doubts.roughness = 1;
  EXPECT_FALSE(names_filter(NoiseFilter::not_used));
  EXPECT_NE(finding_of(doubts, "noise").message.find("--noise robust"), std::string::npos);
}

// Sparse samples are no reason to leave out more of them.
TEST(Findings, SparseSamplesDoNotNameTheFilter) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = one_spot;
  doubts.boundary_samples = 600;
  doubts.samples = 1000;
  for (const std::size_t unsurrounded : {0U, 300U}) {
    doubts.unsurrounded_samples = unsurrounded;
    const Finding finding = finding_of(doubts, "sparse");
    EXPECT_EQ(finding.message.find("--noise robust"), std::string::npos) << finding.message;
  }
}

TEST(Findings, HandlesWarnWhereTheSurfaceIsAGuess) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.samples = 1000;
  doubts.certificate.genus = 2;
  EXPECT_TRUE(findings_of(doubts, 1000, NoiseFilter::not_used).empty());  // nothing is doubtful
  doubts.unsurrounded_samples = 70;
  Finding finding = finding_of(doubts, "handles");
  EXPECT_FALSE(finding.warns);
  EXPECT_EQ(finding.message, "the surface has 2 handles; see if the object has as many");
  EXPECT_EQ(finding.count, 2U);
  doubts.handles = {{{1, 2, 3}, 5, 0.25}};
  doubts.unsurrounded_samples = 80;
  finding = finding_of(doubts, "handles");
  EXPECT_TRUE(finding.warns);
  EXPECT_EQ(finding.spots, doubts.handles);
  EXPECT_EQ(finding.message,
            "the surface has 2 handles and is a guess at 8.0 % of the samples; the narrowest is "
            "0.25 (2.5 times the spacing) around, near (1, 2, 3); if the object does not have as "
            "many, scan such places more densely, or try --noise robust if scans overlap there");
  doubts.certificate.genus = 0;
  EXPECT_TRUE(findings_of(doubts, 1000, NoiseFilter::not_used).empty());
  doubts.certificate.genus.reset();  // not manifold: another finding
  EXPECT_TRUE(findings_of(doubts, 1000, NoiseFilter::not_used).empty());
}

TEST(Findings, ConflictsWarnFromThreeInAThousandSamplesOn) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.samples = 1000;
  doubts.conflicts = 3;
  EXPECT_TRUE(findings_of(doubts, 1000, NoiseFilter::not_used).empty());
  doubts.conflicts = 4;
  doubts.contradicted = one_spot;
  const Finding finding = finding_of(doubts, "conflicts");
  EXPECT_TRUE(finding.warns);
  EXPECT_EQ(finding.count, 4U);
  EXPECT_EQ(finding.spots, one_spot);
  EXPECT_EQ(finding.message.find("samples contradict each other 4 times about what is inside, "
                                 "most near (1, 2, 3); "),
            0U)
      << finding.message;
}

// Noise is why something is wrong, if something is.
TEST(Findings, NoiseWarnsBesideOtherWarnings) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.samples = 1000;
  doubts.roughness = 1;
  doubts.sparse = one_spot;
  doubts.boundary_samples = 100;
  EXPECT_FALSE(finding_of(doubts, "noise").warns);
  doubts.conflicts = 9;
  EXPECT_TRUE(finding_of(doubts, "noise").warns);
  EXPECT_FALSE(finding_of(doubts, "sparse").warns);
}

TEST(Findings, UnusedPointsWarnIfManyAndNotFiltered) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.unused = one_spot;
  doubts.unused_points = 100;
  EXPECT_FALSE(finding_of(doubts, "unused").warns);
  doubts.unused_points = 101;
  EXPECT_TRUE(finding_of(doubts, "unused").warns);
  EXPECT_FALSE(finding_of(doubts, "unused", NoiseFilter::used).warns);
}

// What --trim leaves out is no outlier, and as it was wanted.
TEST(Findings, UnusedPointsThatWereTrimmedAreToldApart) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.unused = one_spot;
  doubts.unused_points = 300;
  const auto of_trimmed = [&](std::size_t trimmed) {
    return findings_of(doubts, 1000, NoiseFilter::not_used, {}, {.trimmed_points = trimmed})[0];
  };
  EXPECT_TRUE(of_trimmed(0).warns);
  EXPECT_TRUE(of_trimmed(199).warns);
  EXPECT_NE(of_trimmed(199).message.find("; 199 of them went with the long triangles that --trim "
                                         "leaves out, else outliers"),
            std::string::npos);
  EXPECT_FALSE(of_trimmed(200).warns);
  EXPECT_FALSE(of_trimmed(300).warns);
  EXPECT_EQ(of_trimmed(300).message.find("outliers"), std::string::npos);
}

// --cavities where it does something, and has not been given.
TEST(Findings, UnusedPointsNameCavitiesWhereTheyHelp) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.unused = one_spot;
  doubts.unused_points = 1;
  const auto names_cavities = [&](NoiseFilter filter, bool cavities) {
    const Finding finding = findings_of(doubts, 10, filter, {}, {.cavities = cavities})[0];
    EXPECT_NE(finding.message.find("inner surfaces"), std::string::npos) << finding.message;
    return finding.message.find("(--cavities keeps them)") != std::string::npos;
  };
  for (const NoiseFilter filter :
       {NoiseFilter::not_used, NoiseFilter::not_used_on_mesh, NoiseFilter::no_noise}) {
    EXPECT_TRUE(names_cavities(filter, true));
    EXPECT_FALSE(names_cavities(filter, false));
  }
  EXPECT_FALSE(names_cavities(NoiseFilter::of_strays, true));
  EXPECT_FALSE(names_cavities(NoiseFilter::no_option, true));
}

// No advice names an option that the command does not have.
TEST(Findings, UpdatesHaveNoNoiseFilter) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = one_spot;
  doubts.boundary_samples = 6;
  doubts.roughness = 1;
  doubts.unused = one_spot;
  doubts.unused_points = 1;
  const std::vector<Finding> findings = findings_of(doubts, 100, NoiseFilter::no_option);
  EXPECT_EQ(findings.size(), 3U);
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.message.find("--noise"), std::string::npos) << finding.message;
  }
}

// Noise of 0.03, which is 15 % of 0.2.
TEST(Findings, OfNoiseNameTheDistanceWhereItIsHarmless) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.roughness = 0.21;
  const auto advice = [&](NoiseFilter filter) {
    return findings_of(doubts, 100, filter).at(0).message;
  };
  const std::string noise = "noise is about 30 % of the spacing 0.1; ";
  const std::string thin = "--thin 0.2, which leaves out points that lie closer";
  EXPECT_EQ(advice(NoiseFilter::not_used), noise + "try --noise robust, or " + thin);
  EXPECT_EQ(advice(NoiseFilter::no_option), noise + "smooth the points, or try " + thin);
  EXPECT_EQ(advice(NoiseFilter::used), advice(NoiseFilter::no_option));
  EXPECT_EQ(advice(NoiseFilter::no_noise), noise + "smooth the mesh first");
}

// The filter of update leaves out stray samples; it is advised for them and not for noise.
TEST(Findings, UpdatesAdviseTheirFilterForStraysOnly) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.sparse = doubts.unused = doubts.dust = one_spot;
  doubts.boundary_samples = 6;
  doubts.roughness = 1;
  doubts.unused_points = 1;
  doubts.fragments = 1;
  const std::vector<Finding> findings = findings_of(doubts, 100, NoiseFilter::of_strays);
  EXPECT_EQ(findings.size(), 4U);
  for (const Finding& finding : findings) {
    const bool advised = finding.kind == "fragments" || finding.kind == "unused";
    EXPECT_EQ(finding.message.find("--noise robust") != std::string::npos, advised)
        << finding.message;
    EXPECT_EQ(finding.message.find("--cavities"), std::string::npos) << finding.message;
  }
}

// The filter of reconstruct leaves out clumps, which become parts; nothing of it helps if it is in
// use, or if the samples are the vertices of a mesh.
TEST(Findings, FragmentsNameTheFilterWhereItHelps) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.dust = one_spot;
  doubts.fragments = 2;
  const auto names_filter = [&](NoiseFilter filter) {
    const std::string message = findings_of(doubts, 100, filter).front().message;
    return message.find("--noise robust") != std::string::npos;
  };
  EXPECT_TRUE(names_filter(NoiseFilter::not_used));
  EXPECT_FALSE(names_filter(NoiseFilter::not_used_on_mesh));
  EXPECT_FALSE(names_filter(NoiseFilter::used));
  EXPECT_FALSE(names_filter(NoiseFilter::no_option));
}

TEST(Findings, ClumpsAreToldWithTheirPlace) {
  NoiseCounters noise;
  noise.clumps = 2;
  noise.clump_samples = 31;
  noise.largest_clump = 19;
  noise.largest_clump_at = PointId(1);
  const std::vector<Point> points{{0, 0, 0}, {1, 2, 3}};
  const Finding two = clumps_finding(noise, points);
  EXPECT_EQ(two.kind, "clumps");
  EXPECT_EQ(two.count, 2U);
  EXPECT_EQ(two.message,
            "31 samples in 2 clumps left out as stray ones; the largest has 19, near (1, 2, 3); if "
            "it is a body, --noise-clump-share 0 keeps it");
  noise.clumps = 1;
  EXPECT_NE(clumps_finding(noise, points).message.find("it has 19"), std::string::npos);
}

TEST(Findings, UnusedPointsAreOneOrMany) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.unused = one_spot;
  doubts.unused_points = 1;
  EXPECT_EQ(said(doubts, " ("), "1 of 10 points is not on the surface; it is 0.5");
  doubts.unused_points = 2;
  EXPECT_EQ(said(doubts, " ("), "2 of 10 points are not on the surface; the farthest is 0.5");
}

// No fifty digits, and no "inf".
TEST(Findings, LengthsBeyondAllMeasureAreReadable) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.unused = doubts.sparse = one_spot;
  doubts.unused_points = doubts.boundary_samples = 1;
  doubts.unused[0].size = 1e50;
  doubts.sparse[0].size = std::numeric_limits<double>::infinity();
  const std::vector<Finding> findings = findings_of(doubts, 10, NoiseFilter::used);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_NE(
      findings[0].message.find("there is too long to be measured, since a point lies too far"),
      std::string::npos)
      << findings[0].message;
  EXPECT_NE(findings[1].message.find("it is 1e+50 (1e+51 times the spacing) off"),
            std::string::npos)
      << findings[1].message;
}

TEST(Findings, CountsAndRatiosAreThoseOfTheDoubts) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.boundary_samples = 1;
  doubts.gap_samples = 2;
  doubts.bad_edges = 3;
  doubts.pinched_vertices = 4;
  doubts.unused_points = 5;
  doubts.sparse = doubts.unused = doubts.contacts = one_spot;
  const std::vector<Finding> findings = findings_of(doubts, 10, NoiseFilter::used);
  ASSERT_EQ(findings.size(), 3U);
  const auto says = [](const Finding& finding, const std::string& text) {
    return finding.message.find(text) != std::string::npos;
  };
  EXPECT_EQ(findings[0].count, 3U);
  EXPECT_TRUE(says(findings[0], "is 0.5 (5.0 times the median)")) << findings[0].message;
  EXPECT_EQ(findings[1].count, 5U);
  EXPECT_TRUE(says(findings[1], "is 0.5 (5.0 times the spacing) off")) << findings[1].message;
  EXPECT_EQ(findings[2].count, 7U);
  doubts.spacing = 0;  // there is no surface
  EXPECT_TRUE(findings_of(doubts, 10, NoiseFilter::used).empty());
}

// Normal noise makes a roughness of 0.7 times its deviation, in spacings (surface_doubts.h).
TEST(Findings, NoiseIsToldAboveAFifthOfTheSpacing) {
  SurfaceDoubts doubts;
  doubts.spacing = 0.1;
  doubts.roughness = 0.7 * 0.19;
  EXPECT_TRUE(findings_of(doubts, 10, NoiseFilter::not_used).empty());
  doubts.roughness = 0.7 * 0.21;
  EXPECT_EQ(said(doubts, ";"), "noise is about 21 % of the spacing 0.1");
}

}  // namespace
}  // namespace cocoon::app
