#include "app/json_report.h"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cocoon::app {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonReport, NestsByPathAndKeepsTheOrder) {
  JsonReport report;
  report.set("z/first", 1);
  report.set("a", "text");
  report.set("z/second", std::vector<std::size_t>{3, 4});
  EXPECT_EQ(Json::parse(report.text()).dump(), R"({"z":{"first":1,"second":[3,4]},"a":"text"})");
}

TEST(JsonReport, KeysThatLookLikeIndicesStayKeys) {
  JsonReport report;
  report.set("mean_angle_deg/0", 4.45);
  EXPECT_EQ(Json::parse(report.text()).dump(), R"({"mean_angle_deg":{"0":4.45}})");
}

TEST(JsonReport, AppendsObjectsToArrays) {
  JsonReport report;
  report.set_empty_array("clouds");
  EXPECT_EQ(Json::parse(report.text())["clouds"].size(), 0U);
  JsonReport cloud;
  cloud.set("samples", std::size_t{7});
  report.append("clouds", cloud);
  EXPECT_EQ(Json::parse(report.text())["clouds"][0]["samples"], 7);
}

TEST(JsonReport, DoublesComeBackBitForBit) {
  JsonReport report;
  report.set("third", 1.0 / 3);
  report.set("missing", std::numeric_limits<double>::quiet_NaN());
  const Json json = Json::parse(report.text());
  EXPECT_EQ(json["third"].get<double>(), 1.0 / 3);
  EXPECT_TRUE(json["missing"].is_null());
}

TEST(JsonReport, SurvivesFileNamesThatAreNotUtf8) {
  JsonReport report;
  report.set("file", std::string("a\xFF"
                                 "b"));
  EXPECT_TRUE(Json::accept(report.text()));
}

TEST(JsonReport, ScriptTextCannotEndTheScript) {
  JsonReport report;
  for (const std::string title : {"</script><b>", "<!--<script>.ply"}) {
    report.set("title", title);
    const std::string text = report.script_text();
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(Json::parse(text)["title"], title);
  }
}

TEST(JsonReport, CountsAreAdded) {
  JsonReport report;
  report.add("input/skipped", 2);
  report.add("input/skipped", 3);
  EXPECT_EQ(nlohmann::json::parse(report.text())["input"]["skipped"], 5);
}

}  // namespace
}  // namespace cocoon::app
