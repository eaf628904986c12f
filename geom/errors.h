// The exception types of the library. Caller mistakes throw; outcomes that depend on the data
// (an empty surface, an ambiguous choice) are values in the result of the stage.
//   Error
//     InputError         points, meshes and options that cannot be worked on
//       DegenerateInput  points that span no space
//     FileError          files; of these UnreadableFile and NonFiniteError are thrown by io/
//     Cancelled          by the caller's Progress
#pragma once

#include <stdexcept>
#include <string>

namespace cocoon {

// Base of all: what() is one line that says what is wrong, where, and what to do about it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The points, mesh or options given to a stage cannot be worked on (non-finite coordinate, fewer
// than four points, all points coplanar, too many points, option out of range).
class InputError : public Error {
 public:
  using Error::Error;
};

// Of these: the points given span no space, so that none can be triangulated: fewer than four
// different ones, or all in one plane. Who tries fewer points than are given goes on without.
class DegenerateInput : public InputError {
 public:
  using InputError::InputError;
};

// A file cannot be opened, read, understood or written.
class FileError : public Error {
 public:
  using Error::Error;
};

// The caller's Progress asked to stop.
class Cancelled : public Error {
 public:
  using Error::Error;
};

}  // namespace cocoon
