#include "app/console/interrupt.h"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>

namespace cocoon::app {
namespace {

// In a process of its own: that it was interrupted holds from then on.
TEST(InterruptDeathTest, StagesInsideOthersStopToo) {
  StopWhenInterrupted stop;
  EXPECT_TRUE(stop.report("delaunay", 0.5));
  const auto goes_on_after_signal = [&] {
    catch_interrupts();
    std::raise(SIGTERM);
    std::_Exit(stop.report("delaunay", 0.5) ? 1 : 0);
  };
  EXPECT_EXIT(goes_on_after_signal(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace cocoon::app
