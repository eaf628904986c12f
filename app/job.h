// What every command has: how it runs, where its results go.
#pragma once

#include <fmt/format.h>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/json_report.h"
#include "app/progress_line.h"
#include "app/stage_clock.h"
#include "geom/execution.h"

namespace cocoon::app {

class Job {
 public:
  Job(const std::string& command, const SharedArguments& shared);

  const SharedArguments& shared() const { return shared_; }
  Execution execution() { return {shared_.threads, &clock_}; }
  const StageClock& clock() const { return clock_; }
  JsonReport& report() { return report_; }
  // One line of the summary for people, on standard output. Silent with --quiet, and when the JSON
  // report goes to standard output.
  template <class... Values>
  void say(fmt::format_string<Values...> format, Values&&... values) {
    say_line(fmt::format(format, std::forward<Values>(values)...));
  }
  // Such a line that begins with "warning: ", also kept for the reports.
  void warn(const std::string& warning);
  const std::vector<std::string>& warnings() const { return warnings_; }

  // Seconds of each outermost stage so far; what runs nested in it is part of it.
  std::vector<StageTime> timings() const;

  // The last step of a command: adds timings and memory to the report and writes it where the
  // user wants it. Returns its text.
  std::string finish();

 private:
  void say_line(const std::string& line);

  SharedArguments shared_;
  ProgressLine progress_line_;
  StageClock clock_;
  JsonReport report_;
  std::vector<std::string> warnings_;
};

// Highest amount of memory that the program has used so far, in bytes.
std::size_t peak_memory_bytes();

}  // namespace cocoon::app
