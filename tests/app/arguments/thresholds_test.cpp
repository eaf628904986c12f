#include "app/arguments/thresholds.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "app/command_line.h"

namespace cocoon::app {
namespace {

nlohmann::json parameters(const StageOptions& options) {
  JsonReport report;
  for (const ThresholdUse use :
       {ThresholdUse::cocone, ThresholdUse::tight, ThresholdUse::second_look,
        ThresholdUse::clean_up, ThresholdUse::outliers, ThresholdUse::noise, ThresholdUse::loops,
        ThresholdUse::findings}) {
    add_thresholds(report, use, options);
  }
  return nlohmann::json::parse(report.text())["parameters"];
}

std::string key(const Threshold& threshold) {
  std::string key =
      std::string(threshold.name) + (threshold.kind == ThresholdKind::angle ? "_deg" : "");
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

TEST(Thresholds, AreOneFieldEach) {
  std::set<const void*> fields;
  std::set<std::string> names;
  StageOptions options;
  for (const Threshold& t : thresholds()) {
    std::visit([&](const void* field) { fields.insert(field); }, t.field(options));
    names.insert(t.name);
  }
  EXPECT_EQ(fields.size(), thresholds().size());
  EXPECT_EQ(names.size(), thresholds().size());
}

TEST(Thresholds, OneThatIsGivenIsSetAndReportedAndNoOther) {
  const nlohmann::json defaults = parameters({});
  ASSERT_EQ(defaults.size(), thresholds().size());
  EXPECT_EQ(defaults["evidence_weight"], 2.25);
  EXPECT_NEAR(defaults["keep_angle_deg"].get<double>(), 134.4, 0.1);
  EXPECT_EQ(defaults["crease_angle_deg"].dump(), "90.0");  // not 90.00000000000001
  for (const Threshold& t : thresholds()) {
    EXPECT_EQ(defaults[key(t)].is_number_integer(), t.kind == ThresholdKind::whole) << t.name;
  }
  for (const Threshold& given : thresholds()) {
    const double inside = given.low + 0.375 * (given.high - given.low);
    const double value = given.kind == ThresholdKind::whole ? std::floor(inside) : inside;
    StageOptions options;
    set_thresholds(options, {{given.name, value}});
    const nlohmann::json now = parameters(options);
    for (const Threshold& t : thresholds()) {
      if (&t == &given) {
        EXPECT_NEAR(now[key(t)].get<double>(), value, 1e-9) << t.name;
        EXPECT_NE(now[key(t)], defaults[key(t)]) << t.name;
      } else {
        EXPECT_EQ(now[key(t)], defaults[key(t)]) << given.name << " set, " << t.name << " changed";
      }
    }
  }
}

// Whichever of the two is given.
TEST(Thresholds, EndsOfARangeAreInOrder) {
  for (const auto& [name, value] : {std::pair("full-pole-ratio", 0.5), {"near-pole-ratio", 3.0}}) {
    StageOptions options;
    set_thresholds(options, {{name, value}});
    try {
      require_order(options);
      ADD_FAILURE() << name;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()).find("--near-pole-ratio ("), 0U) << error.what();
    }
  }
  StageOptions options;
  set_thresholds(options, {{"near-pole-ratio", 3}, {"full-pole-ratio", 3}});
  require_order(options);
}

TEST(Thresholds, GivenOnesAreNamedByUse) {
  const std::map<std::string, double> given{
      {"keep-angle", 100}, {"idle-cost", 1}, {"max-spots", 5}};
  EXPECT_EQ(given_thresholds(ThresholdUse::clean_up, given),
            std::vector<std::string>{"--idle-cost"});
  EXPECT_TRUE(given_thresholds(ThresholdUse::tight, given).empty());
  EXPECT_TRUE(given_thresholds(ThresholdUse::noise, given).empty());
}

}  // namespace
}  // namespace cocoon::app
