#include "app/console/stage_clock.h"

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace cocoon::app {
namespace {

void sleep_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

void run_stage(StageClock& clock, const std::string& stage, int ms) {
  clock.report(stage, 0);
  clock.report(stage, 0.5);
  sleep_ms(ms);
  clock.report(stage, 1);
}

std::vector<std::string> stages_of(const StageClock& clock) {
  std::vector<std::string> names;
  for (const StageTime& time : clock.times()) names.push_back(time.stage);
  return names;
}

TEST(StageClock, TimesAStageFromZeroToOne) {
  StageClock clock(nullptr);
  run_stage(clock, "poles", 20);
  EXPECT_GE(clock.seconds("poles"), 0.020);
  EXPECT_LE(clock.seconds("poles"), clock.total_seconds());
}

TEST(StageClock, AddsUpRepeatedRuns) {
  StageClock clock(nullptr);
  run_stage(clock, "read", 10);
  sleep_ms(30);  // not part of the stage
  run_stage(clock, "read", 10);
  EXPECT_GE(clock.seconds("read"), 0.020);
  EXPECT_LE(clock.seconds("read"), clock.total_seconds() - 0.030);
}

TEST(StageClock, NestedStagesAreTimedOnTheirOwnAndStandInForTheirParent) {
  StageClock clock(nullptr);
  run_stage(clock, "reconstruction/delaunay", 10);
  run_stage(clock, "reconstruction/poles", 15);
  EXPECT_GE(clock.seconds("reconstruction/delaunay"), 0.010);
  EXPECT_DOUBLE_EQ(clock.seconds("reconstruction"), clock.seconds("reconstruction/delaunay") +
                                                        clock.seconds("reconstruction/poles"));
}

TEST(StageClock, AParentThatReportsItselfIsNotCountedTwice) {
  StageClock clock(nullptr);
  clock.report("reconstruction", 0);
  run_stage(clock, "reconstruction/delaunay", 10);
  clock.report("reconstruction", 1);
  EXPECT_GE(clock.seconds("reconstruction"), clock.seconds("reconstruction/delaunay"));
  EXPECT_LT(clock.seconds("reconstruction"), 2 * clock.seconds("reconstruction/delaunay"));
}

TEST(StageClock, ListsFinishedStagesInTheOrderOfTheirBeginning) {
  StageClock clock(nullptr);
  clock.report("b", 0);
  run_stage(clock, "a", 0);
  clock.report("b", 1);
  clock.report("b", 1);  // a second end is no new run
  clock.report("never ends", 0.5);
  EXPECT_EQ(stages_of(clock), (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(clock.seconds("unknown"), 0);
}

class Recorder : public Progress {
 public:
  explicit Recorder(bool answer) : answer_(answer) {}
  bool report(std::string_view stage, double fraction) override {
    seen += std::string(stage) + (fraction >= 1 ? "! " : "? ");
    return answer_;
  }
  std::string seen;

 private:
  bool answer_;
};

TEST(StageClock, PassesReportsOnAndAnswersBack) {
  Recorder goes_on(true);
  StageClock clock(&goes_on);
  EXPECT_TRUE(clock.report("a", 0));
  EXPECT_TRUE(clock.report("a", 1));
  EXPECT_EQ(goes_on.seen, "a? a! ");
  Recorder stops(false);
  EXPECT_FALSE(StageClock(&stops).report("a", 0));
}

TEST(Timed, ReturnsWhatTheBodyReturns) {
  StageClock clock(nullptr);
  const Execution execution{1, &clock};
  EXPECT_EQ(timed(execution, "answer", [] { return 42; }), 42);
  int calls = 0;
  timed(execution, "nothing", [&] { ++calls; });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(stages_of(clock), (std::vector<std::string>{"answer", "nothing"}));
}

}  // namespace
}  // namespace cocoon::app
