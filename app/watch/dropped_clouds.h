// Clouds that came into a watched folder, and the line that tells what they did.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "app/shapes/cloud_filter.h"
#include "app/watch/watch_notes.h"
#include "geom/point.h"
#include "update/stray_samples.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

// Files that are clouds, as they were when they were read, and are applied together.
struct DroppedClouds {
  std::chrono::steady_clock::time_point start;
  std::vector<NotedFile> files;
  std::vector<std::string> names;  // as messages show them
  std::vector<std::vector<Point>> clouds;
  std::vector<std::size_t> thinned;  // how many points --thin left out of each
  std::vector<StraySamples> strays;  // what --noise robust left out of each
  bool has_to_wait = false;          // one of those that belong to it was being written

  // Of all of them.
  std::string name() const;
  // One of several, alone, from now on.
  DroppedClouds only(std::size_t k) const;
};

// One line of all that was applied: counts, seconds since the start, topology, what was left out,
// notes and warnings.
std::string told_applied(const DroppedClouds& dropped, const SessionUpdate& update,
                         const CloudFilter& filter, const UpdateOptions& options);

}  // namespace cocoon::app
