#include "app/job.h"

#include <algorithm>
#include <sys/resource.h>
#include <utility>

#include "app/console/standard_streams.h"
#include "app/files/files.h"
#include "geom/messages/counted.h"
#include "geom/messages/without_control_bytes.h"
#include "io/file_format.h"

namespace cocoon::app {

Job::Job(const std::string& command, const SharedArguments& shared)
    : shared_(shared),
      progress_line_(progress_style(shared.progress, shared.quiet)),
      clock_(&progress_line_),
      is_silent_(shared.quiet || shared.json == "-") {
  report_.set("command", command);
  report_.set("version", COCOON_VERSION);
  report_.set("threads", thread_count(execution()));
}

void Job::begin_trial() { trial_ = Trial{report_.copy(), {}}; }

void Job::end_trial(bool is_taken) {
  Trial trial = std::move(*trial_);
  trial_.reset();
  if (!is_taken) {
    report_ = std::move(trial.report);
    return;
  }
  for (const auto& [line, is_warning] : trial.told) {
    is_warning ? warn(line) : say_line(line);
  }
}

void Job::say_line(const std::string& line) {
  if (trial_) {
    trial_->told.emplace_back(line, false);
    return;
  }
  if (is_silent_ || is_output_taken_) return;
  const std::string shown = without_control_bytes(line) + "\n";
  if (lines_wait_) {
    waiting_lines_ += shown;
    return;
  }
  progress_line_.clear();
  print_output(shown);
}

void Job::warn(const std::string& warning) {
  if (trial_) {
    trial_->told.emplace_back(warning, true);
    return;
  }
  warnings_.push_back(warning);
  const bool is_unseen = is_silent_ || is_output_taken_ || lines_wait_;
  if (unseen_warning_.empty() && is_unseen) unseen_warning_ = warning;
  if (is_output_taken_ && !is_silent_) {
    waiting_warnings_ += "warning: " + without_control_bytes(warning) + "\n";
  }
  say("warning: {}", warning);
}

void Job::make_folder(const std::string& path) {
  require_possible_name(path);
  folders_.emplace_back(path);
}

// Floats are written to binary STL, and to PLY with --float.
void Job::warn_of_rounding(FileBatch& batch) {
  for (const RoundedFile& file : batch.take_rounded()) {
    if (!rounded_.insert(file.target.string()).second) continue;
    const FloatRounding& rounding = file.rounding;
    report_.set("rounding/merged_vertices", rounding.merged_vertices);
    report_.set("rounding/largest_move", rounding.largest_move);
    report_.set("rounding/median_edge", rounding.median_edge);
    const bool is_chosen = format_of(file.target) == FileFormat::ply;
    warn(fmt::format(
        "{}: in {} vertices move by up to {:.3g} (median edge {:.3g}){}: it may be closed or "
        "manifold no longer, or cross itself; {}",
        file.target.string(), is_chosen ? "floats" : "the floats of binary STL",
        rounding.largest_move, rounding.median_edge,
        rounding.merged_vertices == 0
            ? ""
            : ", and " + counted(rounding.merged_vertices, "falls together", "fall together") +
                  " with others",
        is_chosen ? "leave --float out" : "add --ascii, or write PLY, OBJ or OFF"));
  }
}

std::vector<StageTime> Job::timings() const {
  std::vector<StageTime> result;
  for (const StageTime& time : clock_.times()) {
    const std::string stage = time.stage.substr(0, time.stage.find('/'));
    const auto is_listed = [&](const StageTime& other) { return other.stage == stage; };
    if (std::none_of(result.begin(), result.end(), is_listed)) {
      result.push_back({stage, clock_.seconds(stage)});
    }
  }
  return result;
}

void Job::complete_report() {
  report_.set_empty_array("warnings");
  for (const std::string& warning : warnings_) report_.append("warnings", warning);
  for (const StageTime& time : timings()) report_.set("timings_s/" + time.stage, time.seconds);
  report_.set("timings_s/total", clock_.total_seconds());
  report_.set("peak_memory_bytes", peak_memory_bytes());
}

void Job::finish(const std::string& copy_of_report) {
  warn_of_rounding(outputs_);
  complete_report();
  if (shared_.verbose) {
    for (const StageTime& time : clock_.times())
      say("  {:<45} {:9.3f} s", time.stage, time.seconds);
    say("  {:<45} {:9.3f} s", "total", clock_.total_seconds());
  }
  progress_line_.clear();
  const std::string text = report_.text();
  flush_output();  // the report may go to the same place by another name: /dev/stdout
  if (shared_.json == "-") {
    print_output(text);
  } else if (!shared_.json.empty()) {
    write_file(shared_.json, text, outputs());
  }
  if (!copy_of_report.empty()) write_file(copy_of_report, text, outputs());
  print_output(waiting_lines_);
  if (is_error_seen()) print_error(waiting_warnings_);
  flush_output();
  if (!is_silent_) unseen_warning_.clear();
  outputs_.commit();
}

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace cocoon::app
