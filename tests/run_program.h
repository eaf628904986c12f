// Runs the program `cocoon` as a user does, and says what it wrote and how it ended.
#pragma once

#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "tests/temporary_folder.h"

namespace cocoon::test {

using cocoon::content_of;
using cocoon::TemporaryFolder;

struct ProgramRun {
  int exit_code = -1;  // -1: ended by `signal`
  int signal = 0;
  std::string out;
  std::string error;
};

// A program that is running; its outputs go to files of `folder`.
class RunningProgram {
 public:
  // `limit` is called in the new process before the program begins. Signals that end programs do so
  // there, also where the tests run under nohup.
  RunningProgram(const TemporaryFolder& outputs, std::vector<std::string> arguments,
                 void (*limit)() = nullptr)
      : out_(outputs.file("stdout")), error_(outputs.file("stderr")) {
    arguments.insert(arguments.begin(), COCOON_PROGRAM);
    process_ = fork();
    if (process_ != 0) return;
    redirect(out_, STDOUT_FILENO);
    redirect(error_, STDERR_FILENO);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    if (limit != nullptr) limit();
    execv(argv[0], argv.data());
    _exit(127);
  }

  void send(int signal) const { kill(process_, signal); }
  std::string error_so_far() const { return content_of(error_); }

  ProgramRun wait() const {
    int status = 0;
    waitpid(process_, &status, 0);
    ProgramRun run;
    if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
    run.out = content_of(out_);
    run.error = content_of(error_);
    return run;
  }

 private:
  static void redirect(const std::string& path, int descriptor) {
    dup2(open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), descriptor);
  }

  std::string out_;
  std::string error_;
  pid_t process_ = -1;
};

inline ProgramRun run_program(const std::vector<std::string>& arguments,
                              void (*limit)() = nullptr) {
  const TemporaryFolder outputs;
  return RunningProgram(outputs, arguments, limit).wait();
}

// How an error must look: exit code, nothing on standard output, one line that begins with
// "cocoon: " and contains `mentions`.
inline void expect_error(const ProgramRun& run, int exit_code, const std::string& mentions) {
  EXPECT_EQ(run.exit_code, exit_code) << run.error;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.error.rfind("cocoon: ", 0), 0U) << run.error;
  EXPECT_EQ(run.error.find('\n'), run.error.size() - 1) << run.error;
  EXPECT_NE(run.error.find(mentions), std::string::npos) << run.error << " lacks " << mentions;
}

}  // namespace cocoon::test
