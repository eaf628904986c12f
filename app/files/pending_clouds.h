// Clouds that were applied to a session since its file was written: a small file for each update
// beside it, so that to keep a cloud costs what the cloud costs, and not what the model does. Of a
// cloud that was refused the note alone is kept.
//
//   SESSION.cloud-K  the session had K notes (session_file.h) before this update
//   bytes            content (all numbers little-endian)
//   8                "COCOONCL"
//   4, 4             version (4); bits: 1 = rho was given, 2 = refused, 4 = all samples came in
//   8                rho, 64-bit floating point
//   8                what stands for the K notes: the checksum of their text
//   8                number of clouds n, applied together; versions 1 and 2 have none: it is 1
//   16 n             of each: bytes of the note on it, number of points k (0 if refused)
//                    then of each:
//   24 k             coordinates
//                    the note; zero bytes up to a multiple of 8
//   8                checksum (io/summed_file.h)
//
// Version 1 knows no refused clouds. Before version 4 all samples came in.
//
// Applied to the session in order they give the model that they gave before, bit for bit
// (update_session.h). Files with smaller K than the session has notes are in it already.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/point.h"
#include "io/atomic_file.h"

namespace cocoon::app {

struct PendingUpdate {
  std::vector<std::string> notes;          // one on each cloud
  std::vector<std::vector<Point>> clouds;  // applied together
  std::optional<double> rho;               // that they were applied with
  bool refused = false;                    // they were not applied, and there are no points
  bool keep_crowded = false;               // all samples came in, even where they crowd
};

// Its name: SESSION.cloud-K, where SESSION is the file behind all symbolic links: who takes it up
// by another name must find the clouds.
std::string pending_cloud_file(const std::string& session, std::size_t notes);

// Whether this is the name of one, whatever K: digits and nothing else. The folder must be spelled
// as that of the session behind all links.
bool is_pending_cloud_file(const std::filesystem::path& path, const std::string& session);

// `notes`: those before it. The file waits for the batch to be put in place. Precondition: at least
// one cloud. Errors: FileError.
void save_pending_clouds(const std::string& session, std::span<const std::string> notes,
                         const PendingUpdate& update, FileBatch& batch);

// Those that follow the notes, in order. Errors: FileError, one line, if one is damaged, follows
// other notes, or is missing while later ones are there.
std::vector<PendingUpdate> load_pending_clouds(const std::string& session,
                                               std::span<const std::string> notes);

// When they are in the session's file, or the session was begun anew. Errors: FileError.
void remove_pending_clouds(const std::string& session);

}  // namespace cocoon::app
