#include "geom/execution.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <string_view>
#include <unistd.h>
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

// In bytes, of this process; 0: the system does not tell.
double resident_memory() {
  std::ifstream statm("/proc/self/statm");
  double size = 0;
  double resident = 0;
  statm >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// A program that waits for work runs for months.
TEST(ParallelChunks, TakesNoMemoryForGood) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep memory that was given back";
#endif
  std::vector<double> numbers(64);
  const auto run = [&](int times) {
    for (int k = 0; k < times; ++k) {
      parallel_chunks({2}, numbers.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) numbers[i] += 1;
      });
    }
  };
  run(200);
  const double before = resident_memory();
  run(1500);
  EXPECT_LT(resident_memory() - before, 2e6);
  EXPECT_EQ(numbers.front() + numbers.back(), 3400);
}

// A loop in a task of another one.
TEST(ThreadCount, HasBothEnds) {
  EXPECT_EQ(thread_count({3}), 3);
  EXPECT_GE(thread_count({0}), 1);
  EXPECT_EQ(thread_count({-5}), thread_count({0}));
  EXPECT_EQ(thread_count({std::numeric_limits<int>::max()}), 1024);
}

TEST(ParallelChunks, CanBeNested) {
  std::vector<double> numbers(256);
  parallel_chunks({2}, 16, 1, [&](std::size_t begin, std::size_t) {
    parallel_chunks({2}, 16, 1, [&](std::size_t i, std::size_t) { numbers[16 * begin + i] += 1; });
  });
  EXPECT_EQ(numbers, std::vector<double>(256, 1));
}

// Says stop once a fraction is reached.
class StopAt : public Progress {
 public:
  explicit StopAt(double fraction) : stop_at_(fraction) {}
  bool report(std::string_view, double fraction) override {
    EXPECT_GE(fraction, heard.empty() ? 0 : heard.back());
    heard.push_back(fraction);
    return fraction < stop_at_;
  }
  std::vector<double> heard;

 private:
  double stop_at_;
};

TEST(ParallelChunksOfAStage, AreTheSameChunksAndReportOnTheWay) {
  for (const std::size_t count : {0U, 1U, 1000U, 12345U}) {
    StopAt progress(2);
    std::vector<int> visits(count);
    parallel_chunks({2, &progress}, StagePart{"half", 0.25, 0.75}, count, 10,
                    [&](std::size_t begin, std::size_t end) {
                      EXPECT_EQ(begin % 10, 0U);
                      EXPECT_EQ(end, std::min<std::size_t>(begin + 10, count));
                      for (std::size_t i = begin; i < end; ++i) ++visits[i];
                    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
    if (count == 0) continue;
    EXPECT_EQ(progress.heard.front(), 0.25);
    EXPECT_LT(progress.heard.back(), 0.75);
    EXPECT_TRUE(count < 2000 || progress.heard.size() > 50);
  }
}

TEST(ParallelChunksOfAStage, CanBeCancelled) {
  StopAt progress(0.5);
  std::atomic<std::size_t> visited = 0;
  EXPECT_THROW(parallel_chunks({2, &progress}, StagePart{"all"}, 100000, 10,
                               [&](std::size_t begin, std::size_t end) { visited += end - begin; }),
               Cancelled);
  EXPECT_GT(visited, 40000U);
  EXPECT_LT(visited, 60000U);
}

// So that each may keep something for itself.
TEST(ParallelChunksByThread, NumbersThoseUnderWay) {
  constexpr std::size_t threads = 3;
  std::array<std::atomic<int>, threads> under_way{};
  std::atomic<int> shared = 0;
  std::atomic<int> calls = 0;
  parallel_chunks_by_thread({threads}, 3000, 2,
                            [&](std::size_t thread, std::size_t begin, std::size_t end) {
                              ASSERT_LT(thread, threads);
                              EXPECT_EQ(begin + 2, end);
                              shared += under_way.at(thread)++;
                              ++calls;
                              --under_way.at(thread);
                            });
  EXPECT_EQ(shared, 0);
  EXPECT_EQ(calls, 1500);
  parallel_chunks_by_thread(
      {1}, 5, 2, [](std::size_t thread, std::size_t, std::size_t) { EXPECT_EQ(thread, 0U); });
}

}  // namespace
}  // namespace cocoon
