// A session on disk: the model of an update with all that makes the next update fast.
//
//   bytes          content (all numbers little-endian)
//   8              "COCOONUS"
//   4, 4           version (5; 4 never has the bits above 16, 3 also differs in what `watch`
//                  notes, watch_notes.h; both are read, too);
//                  bits: 1 = paper mode, 2, 4, 8 = the following angles were given, 16 = the
//                  surface is certified (cocone/kept/certified_surface.h), 32 = marks are kept
//                  (kept_marks.h), 64 = the body is (kept_body.h)
//   8, 8, 8        alpha, cocone angle, sharp angle in degrees, 64-bit floating point
//   8, 8, 8        numbers of model vertices n, triangles t, points k
//   8, 8, 8        bytes of the notes, of the triangulation, and of what is known of its surface
//   24 n, 24 k     coordinates of the model's vertices and of the points
//   4 n, 12 t      the point at each vertex (2^32 - 1 = none), the triangles; zero bytes up to a
//                  multiple of 8
//                  the notes: a line of text each; zero bytes up to a multiple of 8
//                  the triangulation as io/triangulation_block.h has it, or nothing
//                  the surface (cocone/live/surface_state.h), or nothing; with v vertices and c
//                  cells:
//   24 v, 4 v      normals, steps
//   v, v, c, c     flags of vertices, samples, flags of cells, pruned candidates
//   c, v           sides and sheets, if certified
//   c, v           marks, if kept
//   c              1 for cells that are not of the body, if kept; zero bytes up to a multiple of 8
//   8              checksum (io/summed_file.h)
#pragma once

#include <string>
#include <vector>

#include "app/command_line.h"
#include "io/atomic_file.h"
#include "update/update_session.h"

namespace cocoon::app {

struct SavedSession {
  SessionSnapshot snapshot;
  SurfaceArguments parameters;     // without rho, which is that of the clouds
  std::vector<std::string> notes;  // one line each: whatever the command wants to remember
};

// Are those that a session keeps the same?
bool same_parameters(const SurfaceArguments& a, const SurfaceArguments& b);

// The file appears complete or not at all, and is on the disk then (io/atomic_file.h); with a batch
// it appears together with the rest of it. Errors: FileError.
void save_session(const std::string& path, const SavedSession& session, FileBatch* batch = nullptr);

// Before anything is believed: checksum, length, ranges, and that model, points and triangulation
// fit together. Memory is proportional to the length of the file. Errors: FileError, one line.
SavedSession load_session(const std::string& path, const Execution& execution = {});

}  // namespace cocoon::app
