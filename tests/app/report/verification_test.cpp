// A refuted result stops a command before it writes.
#include "app/report/verification.h"

#include <gtest/gtest.h>
#include <string>

#include "app/report/reconstruct_report.h"
#include "geom/errors.h"

namespace cocoon::app {
namespace {

TEST(Verification, WithoutOneNothingIsSaid) {
  JsonReport report;
  report_verification(report, "a.xyz", SurfaceVerification{});
  EXPECT_EQ(report.text().find("verification"), std::string::npos);
}

TEST(Verification, WhatHeldIsReported) {
  JsonReport report;
  SurfaceVerification verification;
  verification.done = true;
  verification.cells = 12345;
  report_verification(report, "a.xyz", verification);
  EXPECT_NE(report.text().find("12345"), std::string::npos);
}

TEST(Verification, WhatIsRefutedThrowsAndSaysWhy) {
  ReconstructResult result;
  result.status = SurfaceStatus::refuted;
  result.verification.done = true;
  result.verification.failure = "3 triangles of the surface are no facets of its cells";
  Job job("reconstruct", SharedArguments());
  try {
    require_surface(job, "a.xyz", result, {}, {});
    FAIL() << "accepted";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("a.xyz: ", 0), 0U) << message;
    EXPECT_NE(message.find(result.verification.failure), std::string::npos) << message;
    EXPECT_NE(message.find("not written"), std::string::npos) << message;
  }
  DelaunayReport delaunay;
  delaunay.first_violation = "cell 5 is not positively oriented";
  EXPECT_THROW(report_verification(job.report(), "a.xyz", 9, delaunay), Error);
}

}  // namespace
}  // namespace cocoon::app
