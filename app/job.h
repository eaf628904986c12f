// What every command has: how it runs, where its results go.
#pragma once

#include <deque>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line.h"
#include "app/console/progress_line.h"
#include "app/console/stage_clock.h"
#include "app/files/output_folder.h"
#include "app/json_report.h"
#include "geom/execution.h"
#include "io/atomic_file.h"

namespace cocoon::app {

class Job {
 public:
  Job(const std::string& command, const SharedArguments& shared);

  const SharedArguments& shared() const { return shared_; }
  Execution execution() { return {shared_.threads, &clock_}; }
  const StageClock& clock() const { return clock_; }
  JsonReport& report() { return report_; }
  // An output goes to standard output: nothing else may, from now on. Warnings go to standard error
  // then, if that is a terminal, when the outputs are complete (finish).
  void keep_standard_output() { is_output_taken_ = true; }
  // One line of the summary for people, on standard output. Silent with --quiet, and when an output
  // goes there.
  template <class... Values>
  void say(fmt::format_string<Values...> format, Values&&... values) {
    say_line(fmt::format(format, std::forward<Values>(values)...));
  }
  // Such a line that tells of outputs: it, and all lines behind it, are printed when the outputs
  // are complete (finish), for until then none of them may appear.
  template <class... Values>
  void say_outputs(fmt::format_string<Values...> format, Values&&... values) {
    lines_wait_ = true;
    say_line(fmt::format(format, std::forward<Values>(values)...));
  }
  // Such a line that begins with "warning: ", also kept for the reports.
  void warn(const std::string& warning);
  const std::vector<std::string>& warnings() const { return warnings_; }
  // The first one that nobody has seen, which may explain why the command fails; empty: none.
  const std::string& unseen_warning() const { return unseen_warning_; }

  // Returns attempt(), whether the attempt is taken. What it says, warns and reports counts only
  // then, and not if it throws; until then no line is printed. Of stages the time counts in any
  // case. Attempts are not nested.
  template <class Attempt>
  bool try_out(const Attempt& attempt) {
    begin_trial();
    bool is_taken = false;
    try {
      is_taken = attempt();
    } catch (...) {
      end_trial(false);
      throw;
    }
    end_trial(is_taken);
    return is_taken;
  }

  // Makes a folder for outputs. What was made of it goes again if nothing is in it when the job
  // ends. Throws FileError.
  void make_folder(const std::string& path);
  // Where the outputs wait until all of them are complete.
  FileBatch* outputs() { return &outputs_; }
  // Warns of meshes in a batch whose files are other surfaces than the program told of, since
  // floats are too coarse for them; the numbers are in section "rounding" of the report. Once for
  // each file, whatever is written later. finish() does so for outputs().
  void warn_of_rounding(FileBatch& batch);

  // Seconds of each outermost stage so far; what runs nested in it is part of it.
  std::vector<StageTime> timings() const;

  // Adds warnings, timings and memory to the report, as they are now.
  void complete_report();

  // The last step of a command: completes the report, writes it where the user
  // wants it and to a second file that the command wants, and puts all outputs in place. Throws
  // FileError if one cannot be written, standard output included; then the old files are as they
  // were.
  void finish(const std::string& copy_of_report = {});

 private:
  void begin_trial();
  void end_trial(bool is_taken);
  void say_line(const std::string& line);

  SharedArguments shared_;
  ProgressLine progress_line_;
  StageClock clock_;
  JsonReport report_;
  std::deque<OutputFolder> folders_;  // before the outputs, which may have files there to the end
  FileBatch outputs_;
  std::vector<std::string> warnings_;
  std::set<std::string> rounded_;  // files that were warned of
  std::string unseen_warning_;
  bool is_silent_;
  bool is_output_taken_ = false;
  bool lines_wait_ = false;
  std::string waiting_lines_;
  std::string waiting_warnings_;  // for standard error

  struct Trial {
    JsonReport report;                               // before it
    std::vector<std::pair<std::string, bool>> told;  // lines, and whether it is a warning
  };
  std::optional<Trial> trial_;
};

// Highest amount of memory that the program has used so far, in bytes.
std::size_t peak_memory_bytes();

}  // namespace cocoon::app
