// The program `cocoon`: reads the command line, runs the command, turns errors into exit codes.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <unistd.h>
#include <variant>

#include "app/commands.h"
#include "app/console/interrupt.h"
#include "app/console/standard_streams.h"
#include "app/kept_memory.h"
#include "geom/errors.h"
#include "geom/messages/without_control_bytes.h"

namespace cocoon::app {

namespace {

enum ExitCode { done = 0, cannot_be_done = 1, wrong_command_line = 2 };

// Once: if several threads fail, the others wait for the end of the program.
void be_the_first_to_tell() {
  static std::atomic_flag is_told;
  while (is_told.test_and_set()) ::pause();
}

int report_error(const std::string& message, ExitCode code) {
  const std::string line = "cocoon: " + without_control_bytes(message) + "\n";
  be_the_first_to_tell();  // not before there is a line: memory may be lacking for it
  print_error(line);
  return code;
}

// Without memory, which may be what is lacking, and without the destructors of the libraries:
// threads of oneTBB may be on their way still.
[[noreturn]] void end_with_line(std::string_view line) {
  be_the_first_to_tell();
  print_error(line);
  std::fflush(stdout);
  ::_exit(cannot_be_done);
}

[[noreturn]] void end_for_lack_of_memory() {
  end_with_line("cocoon: not enough memory for this input; use fewer points or a larger machine\n");
}

[[noreturn]] void end_for_lack_of_threads() {
  end_with_line(
      "cocoon: no further thread can be started: the limit on memory or on threads is too low "
      "(ulimit -v, ulimit -u); raise it, or use --threads 1\n");
}

// oneTBB has no type of its own for what it throws when the system gives it no further thread.
bool is_lack_of_threads(const std::exception& error) {
  return std::string_view(error.what()).starts_with("pthread_create has failed");
}

// A thread of oneTBB that is refused memory or another thread throws where nobody can catch it.
void end_where_nobody_catches() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    end_for_lack_of_memory();
  } catch (const std::exception& error) {
    if (is_lack_of_threads(error)) end_for_lack_of_threads();
  } catch (...) {
  }
  std::abort();
}

// If it fails: `unseen_warning` is what was to be said before, and nobody has seen.
void run_job(const CommandLine& line, std::string& unseen_warning) {
  const auto run_command = [&](const auto& arguments) {
    Job job(arguments.command, line.shared);
    try {
      run(arguments, job);
    } catch (const FileError&) {
      // A signal interrupts the system when it waits for a pipe. But `watch` writes files after it.
      constexpr bool watches = std::is_same_v<std::decay_t<decltype(arguments)>, WatchArguments>;
      if (interrupted() && !watches) throw Cancelled("cancelled while it waited for a file");
      unseen_warning = job.unseen_warning();
      throw;
    } catch (const Error&) {
      unseen_warning = job.unseen_warning();
      throw;
    }
  };
  std::visit(run_command, line.command);
}

int run_command_line(const CommandLine& line) {
  if (!std::holds_alternative<WatchArguments>(line.command)) keep_freed_memory();
  catch_interrupts();
  std::string warning;
  try {
    run_job(line, warning);
    return done;
  } catch (const UsageError& error) {
    return report_error(error.what(), wrong_command_line);
  } catch (const Cancelled& cancelled) {
    report_error(fmt::format("{}; no file was changed", cancelled.what()), cannot_be_done);
    if (interrupted()) end_by_interrupt();
    return cannot_be_done;
  } catch (const Error& error) {
    if (!warning.empty()) warning = fmt::format(" (warning: {})", warning);
    return report_error(error.what() + warning, cannot_be_done);
  } catch (const std::bad_alloc&) {
    end_for_lack_of_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    return report_error(fmt::format("{}: {}; check the name and the permissions",
                                    error.path1().string(), error.code().message()),
                        cannot_be_done);
  } catch (const std::exception& error) {
    if (is_lack_of_threads(error)) end_for_lack_of_threads();
    return report_error(fmt::format("internal error: {}; please report it", error.what()),
                        cannot_be_done);
  }
}

int main_of_program(int argc, const char* const* argv) {
  open_standard_streams();
  std::set_terminate(end_where_nobody_catches);
  try {
    const Request request = parse_command_line(argc, argv);
    if (const auto* text = std::get_if<TextRequest>(&request)) {
      print_output(text->text);
      flush_output();
      return done;
    }
    return run_command_line(std::get<CommandLine>(request));
  } catch (const UsageError& error) {
    return report_error(error.what(), wrong_command_line);
  } catch (const FileError& error) {
    return report_error(error.what(), cannot_be_done);
  }
}

}  // namespace

}  // namespace cocoon::app

int main(int argc, char** argv) { return cocoon::app::main_of_program(argc, argv); }
