#include "app/console/standard_streams.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "geom/errors.h"

namespace cocoon::app {

namespace {

int output_error = 0;  // errno of the first failure

void note_failure() {
  if (output_error == 0) output_error = errno;
}

}  // namespace

void open_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    const bool closed = ::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF;
    // The lowest free descriptor; as it is only read, what is printed to it fails.
    if (closed && ::open("/dev/null", O_RDONLY) < 0) return;
  }
  std::signal(SIGPIPE, SIG_IGN);
}

bool is_standard_output(const std::string& path) {
  struct stat of_path = {};
  struct stat of_output = {};
  return ::stat(path.c_str(), &of_path) == 0 && ::fstat(STDOUT_FILENO, &of_output) == 0 &&
         of_path.st_dev == of_output.st_dev && of_path.st_ino == of_output.st_ino;
}

void print_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_failure();
}

void flush_output() {
  if (std::fflush(stdout) != 0) note_failure();
  if (output_error == 0 || output_error == EPIPE) return;
  throw FileError(std::string("standard output: cannot be written (") +
                  std::strerror(output_error) + "); check where it goes to");
}

void print_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

bool is_error_seen() { return ::isatty(STDERR_FILENO) != 0; }

}  // namespace cocoon::app
