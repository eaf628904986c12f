#include "update/shared_edges.h"

#include <algorithm>
#include <cstdint>

#include "geom/arrays/disjoint_sets.h"
#include "geom/box.h"
#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/rim_seams.h"
#include "update/model/reached_cells.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// An edge of a loop and where another cloud beyond it would have samples.
struct PlaceBeyond {
  std::size_t loop;
  std::size_t edge;
  Point place;
};

std::vector<PlaceBeyond> places_in(const Box& box, const CloudRim& rim, double step) {
  std::vector<PlaceBeyond> found;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    for (std::size_t i = 0; i < rim.loops[l].size(); ++i) {
      const Point place = place_beyond(rim.loops[l], i, step);
      if (contains(box, place)) found.push_back({l, i, place});
    }
  }
  return found;
}

std::vector<Point> samples_near_places(Points cloud, const std::vector<PlaceBeyond>& places,
                                       double reach) {
  std::vector<Point> centers;
  centers.reserve(places.size());
  for (const PlaceBeyond& p : places) centers.push_back(p.place);
  return points_near(cloud, centers, reach);
}

}  // namespace

std::vector<std::size_t> mark_shared_edges(std::size_t c, std::span<const Scan> scans,
                                           CloudRim& rim, const SharedEdgeOptions& options) {
  require_options("mark_shared_edges", options);
  require_index("mark_shared_edges", "scan", c, scans.size());
  std::vector<std::size_t> others;
  for (std::size_t other = 0; other < scans.size(); ++other) {
    const Scan& scan = scans[other];
    if (other == c || scan.samples.empty()) continue;
    const double step = std::max(rim.spacing, scan.spacing);
    const double reach = options.reach * step;
    Box box = box_of(scan.samples);
    box.enlarge(reach);
    const std::vector<PlaceBeyond> places = places_in(box, rim, step);
    if (places.empty()) continue;
    const std::vector<Point> samples = samples_near_places(scan.samples, places, reach);
    if (samples.empty()) continue;
    const NearestPointTree tree(samples);
    bool shares = false;
    for (const PlaceBeyond& p : places) {
      if (!tree.any_near(p.place, reach)) continue;
      shares = true;
      RimLoop& loop = rim.loops[p.loop];
      if (loop.is_inner(p.edge)) continue;
      loop.inner.resize(loop.size(), 0);
      loop.inner[p.edge] = 1;
      ++rim.shared_edges;
    }
    if (shares) others.push_back(other);
  }
  return others;
}

std::vector<std::size_t> lowest_sharing_clouds(std::span<const std::vector<std::size_t>> others) {
  DisjointSets sets(others.size());
  for (std::uint32_t c = 0; c < others.size(); ++c) {
    for (const std::size_t other : others[c]) sets.join(c, static_cast<std::uint32_t>(other));
  }
  std::vector<std::size_t> lowest;
  for (std::uint32_t c = 0; c < others.size(); ++c) lowest.push_back(sets.root(c));
  return lowest;
}

}  // namespace cocoon
