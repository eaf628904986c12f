#include "update/checks/unscanned_losses.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/visit_where.h"
#include "geom/messages/require_size.h"
#include "update/model/mean_at_vertex.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// The mean edge of the model at one of its vertices, which has triangles.
double mean_edge_at(const ModelIndex& model, VertexId v) {
  const auto& points = model.mesh().points;
  return mean_at_vertex(model, v,
                        [&](VertexId other) { return distance(points[v], points[other]); });
}

// A vertex that went, with no sample near it.
struct Loss {
  VertexId vertex;
  double spacing;  // of the model
};

double unit_at(const Loss& loss, const Scan& scan) { return std::max(scan.spacing, loss.spacing); }

std::vector<Loss> far_from_samples(const ModelIndex& model, std::span<const VertexId> lost,
                                   std::span<const Scan> scans,
                                   std::span<const NearestPointTree> samples, double reach) {
  std::vector<Loss> far;
  for (const VertexId v : lost) {
    const Loss loss{v, mean_edge_at(model, v)};
    bool is_near = false;
    for (std::size_t c = 0; c < scans.size() && !is_near; ++c) {
      is_near = samples[c].any_near(model.mesh().points[v], reach * unit_at(loss, scans[c]));
    }
    if (!is_near) far.push_back(loss);
  }
  return far;
}

// From the samples, in spacings.
double distance_of(const Loss& loss, const Point& place, std::span<const Scan> scans,
                   std::span<const NearestPointTree> samples) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const double nearest = std::sqrt(samples[c].nearest(place).squared_distance);
    least = std::min(least, nearest / unit_at(loss, scans[c]));
  }
  return least;
}

// Those that hang together by edges of the model are a group, named by one of them.
class Groups {
 public:
  Groups(const ModelIndex& model, const std::vector<Loss>& losses)
      : sets_(losses.size()), begins_(losses.size(), 0) {
    for (std::size_t i = 0; i < losses.size(); ++i) {
      for (const TriangleId t : model.triangles_at(losses[i].vertex)) {
        for (const VertexId other : model.mesh().triangles[t]) join(i, other, losses);
      }
    }
  }
  std::size_t of(std::size_t i) { return sets_.root(static_cast<std::uint32_t>(i)); }
  // Whether its group begins there: it has a neighbor that is none of them.
  bool begins_at(std::size_t i) const { return begins_[i] != 0; }

 private:
  void join(std::size_t i, VertexId other, const std::vector<Loss>& losses) {
    const auto found =
        std::lower_bound(losses.begin(), losses.end(), other,
                         [](const Loss& loss, VertexId v) { return loss.vertex < v; });
    if (found == losses.end() || found->vertex != other) {
      begins_[i] = 1;
    } else {
      sets_.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(found - losses.begin()));
    }
  }

  DisjointSets sets_;
  std::vector<std::uint8_t> begins_;
};

// Which losses a change of the surface explains, by their groups.
std::vector<std::uint8_t> explained_by_changes(const ModelIndex& model,
                                               const std::vector<Loss>& losses,
                                               std::span<const Scan> scans,
                                               std::span<const NearestPointTree> samples,
                                               const UnscannedOptions& options) {
  Groups groups(model, losses);
  std::vector<std::size_t> begins(losses.size(), 0);
  std::vector<std::size_t> changed(losses.size(), 0);
  std::vector<std::size_t> asked;
  std::vector<Point> places;
  double spacing = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    if (!groups.begins_at(i)) continue;
    asked.push_back(i);
    places.push_back(model.mesh().points[losses[i].vertex]);
    spacing = std::max(spacing, losses[i].spacing);
  }
  std::vector<std::uint8_t> is_changed(asked.size(), 0);
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const Scan& scan = scans[c];
    const double largest = std::max(scan.spacing, spacing);
    SampleHeights heights(model, scan.samples, places, options.change_reach * largest,
                          options.off_model * largest, scan.shift);
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const double unit = unit_at(losses[asked[k]], scan);
      const double off = options.off_model * unit;
      const auto is_off = [&](PointId p) { return heights.squared(p) > off * off; };
      if (samples[c].any_near(places[k], options.change_reach * unit, is_off)) is_changed[k] = 1;
    }
  }
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const std::size_t group = groups.of(asked[k]);
    ++begins[group];
    changed[group] += is_changed[k];
  }
  std::vector<std::uint8_t> explained;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    const std::size_t group = groups.of(i);
    explained.push_back(begins[group] > 0 &&
                        static_cast<double>(changed[group]) >=
                            options.explained * static_cast<double>(begins[group]));
  }
  return explained;
}

}  // namespace

std::vector<VertexId> lost_vertices(const ModelIndex& model, const Replacement& replacement,
                                    const IdVector<VertexId, VertexId>& vertex_map, bool all_used) {
  std::vector<VertexId> lost;
  if (all_used) {
    lost = replacement.vertices.removed;
  } else {
    require_size("lost_vertices", "vertices of the map", vertex_map.size(),
                 model.mesh().points.size());
    visit_where(
        vertex_map.size(), [&](std::size_t i) { return vertex_map[VertexId(i)].is_none(); },
        [&](std::size_t i) { lost.push_back(VertexId(i)); });
  }
  std::erase_if(lost, [&](VertexId v) { return !model.is_used(v); });
  return lost;
}

UnscannedLosses unscanned_losses(const ModelIndex& model, std::span<const VertexId> lost,
                                 std::span<const Scan> scans,
                                 std::span<const NearestPointTree> samples, bool lost_handles,
                                 const UnscannedOptions& options) {
  require_options("unscanned_losses", options);
  require_size("unscanned_losses", "trees of samples", samples.size(), scans.size());
  UnscannedLosses result;
  const std::vector<Loss> losses = far_from_samples(model, lost, scans, samples, options.reach);
  result.far = losses.size();
  std::vector<std::uint8_t> explained(losses.size(), 0);
  const double most = options.max_explained_share * static_cast<double>(model.mesh().points.size());
  if (!losses.empty() && !lost_handles && static_cast<double>(losses.size()) <= most) {
    explained = explained_by_changes(model, losses, scans, samples, options);
  }
  for (std::size_t i = 0; i < losses.size(); ++i) {
    if (explained[i] != 0) continue;
    ++result.vertices;
    const VertexId v = losses[i].vertex;
    const double distance = distance_of(losses[i], model.mesh().points[v], scans, samples);
    if (distance <= result.distance) continue;
    result.farthest = v;
    result.distance = distance;
  }
  return result;
}

}  // namespace cocoon
