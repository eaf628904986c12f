#include "geom/execution.h"

#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

// Writes down what it is told, and says stop at one of the reports.
class Recorder : public Progress {
 public:
  explicit Recorder(std::string stop_at = {}) : stop_at_(std::move(stop_at)) {}
  bool report(std::string_view stage, double fraction) override {
    heard.push_back(std::string(stage) + " " + std::to_string(static_cast<int>(fraction)));
    return heard.back() != stop_at_;
  }
  std::vector<std::string> heard;

 private:
  std::string stop_at_;
};

int forty_two(const Execution& execution) {
  report_progress(execution, "count", 0);
  report_progress(execution, "count", 1);
  return 42;
}

TEST(RunStep, TellsBeginAndEndAndWhatIsInIt) {
  Recorder recorder;
  const Execution execution{3, &recorder};
  EXPECT_EQ(run_step(execution, "all",
                     [&](const Execution& nested) {
                       EXPECT_EQ(nested.threads, 3);
                       run_step(nested, "half", forty_two);
                       return forty_two(nested);
                     }),
            42);
  const std::vector<std::string> expected{
      "all 0",      "all/half 0",  "all/half/count 0", "all/half/count 1",
      "all/half 1", "all/count 0", "all/count 1",      "all 1"};
  EXPECT_EQ(recorder.heard, expected);
}

TEST(RunStep, NobodyListens) {
  bool ran = false;
  run_step(Execution{2, nullptr}, "all", [&](const Execution& nested) {
    EXPECT_EQ(nested.progress, nullptr);
    ran = forty_two(nested) == 42;
  });
  EXPECT_TRUE(ran);
}

TEST(RunStep, ACancelledStepHasNoEnd) {
  Recorder recorder("all/count 0");
  EXPECT_THROW(run_step(Execution{1, &recorder}, "all", forty_two), Cancelled);
  EXPECT_EQ(recorder.heard, (std::vector<std::string>{"all 0", "all/count 0"}));
}

}  // namespace
}  // namespace cocoon
