// Standard output and standard error, either of which may be closed, on a full disk, or a pipe
// whose reader has gone.
#pragma once

#include <string>
#include <string_view>

namespace cocoon::app {

// Takes the place of standard streams that the caller closed, so that no file that the program
// opens becomes one of them, and makes a pipe without a reader an error of the write (SIGPIPE).
// Call it first of all.
void open_standard_streams();

// Whether what is written to a file of this name goes where standard output goes: /dev/stdout,
// links to it, the file or the pipe that it was redirected to.
bool is_standard_output(const std::string& path);

// Appends to standard output; a failure is told by flush_output.
void print_output(std::string_view text);

// Throws FileError if something printed so far did not get there. A reader that has gone (as
// `head` does) wants no more, which is no failure.
void flush_output();

// To standard error, at once; there is nobody to tell a failure.
void print_error(std::string_view text);

// Whether somebody looks at standard error: where it is no terminal, nothing but errors goes there.
bool is_error_seen();

}  // namespace cocoon::app
