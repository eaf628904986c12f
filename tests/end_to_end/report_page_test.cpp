// The HTML page of an update has all that the JSON report has, also what was told before the
// update.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

Json data_of(const std::string& page) {
  const std::string before = "<script id=\"report\" type=\"application/json\">";
  const std::size_t begin = page.find(before) + before.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ReportPage, HasWarningsAndTimesOfTheWholeCommand) {
  const TemporaryFolder folder;
  const std::string model = folder.write("model.xyz", whole_sphere(1500));
  const std::string cap = folder.write("cap.xyz", sphere_cap(6000, 0.8, 0.3) + "nan 0 0\n");
  const std::string page_file = folder.file("page.html");
  const std::string json_file = folder.file("report.json");
  const ProgramRun run =
      run_program({"update", model, cap, "-o", folder.file("out.ply"), "--skip-non-finite",
                   "--html", page_file, "--json", json_file});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  const Json page = data_of(content_of(page_file));
  const Json report = Json::parse(content_of(json_file));
  const std::string warning = cap + ": 1 point is not finite and was left out";
  ASSERT_EQ(report["warnings"][0], warning);
  const Json& numbers = page["json"];
  EXPECT_EQ(numbers["warnings"], report["warnings"]);
  EXPECT_EQ(numbers["timings_s"]["read"], report["timings_s"]["read"]);
  EXPECT_EQ(numbers["timings_s"].size() + 1, report["timings_s"].size());  // but for writing it
  EXPECT_EQ(page["warnings"], report["warnings"]);
}

}  // namespace
}  // namespace cocoon::test
