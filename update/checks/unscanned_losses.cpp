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

// Those that hang together by edges of the model are a group. It begins at those with a neighbor
// that is none of them; those of these that hang together are an end of it.
class Groups {
 public:
  // `lost`: these and those near samples, ascending.
  Groups(const ModelIndex& model, const std::vector<Loss>& losses, std::span<const VertexId> lost)
      : groups_(losses.size()),
        ends_(losses.size()),
        begins_(losses.size(), 0),
        is_beside_kept_(losses.size(), 0) {
    visit_edges(model, losses, [&](std::uint32_t i, std::uint32_t other, VertexId v) {
      if (other == none) {
        begins_[i] = 1;
        if (!std::binary_search(lost.begin(), lost.end(), v)) is_beside_kept_[i] = 1;
      } else {
        groups_.join(i, other);
      }
    });
    visit_edges(model, losses, [&](std::uint32_t i, std::uint32_t other, VertexId) {
      if (other != none && begins_at(i) && begins_at(other)) ends_.join(i, other);
    });
  }

  // Each is named by one of its losses.
  std::size_t group_of(std::size_t i) { return groups_.root(static_cast<std::uint32_t>(i)); }
  std::size_t end_of(std::size_t i) { return ends_.root(static_cast<std::uint32_t>(i)); }
  bool begins_at(std::size_t i) const { return begins_[i] != 0; }
  // A neighbor of it stays.
  bool is_beside_kept(std::size_t i) const { return is_beside_kept_[i] != 0; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  // visit(i, other, v): of a loss and a neighbor v, by its place or none if that is no loss.
  template <class Visit>
  static void visit_edges(const ModelIndex& model, const std::vector<Loss>& losses,
                          const Visit& visit) {
    for (std::size_t i = 0; i < losses.size(); ++i) {
      for (const TriangleId t : model.triangles_at(losses[i].vertex)) {
        for (const VertexId v : model.mesh().triangles[t]) {
          const auto found = std::lower_bound(
              losses.begin(), losses.end(), v,
              [](const Loss& loss, VertexId other) { return loss.vertex < other; });
          const bool is_loss = found != losses.end() && found->vertex == v;
          visit(static_cast<std::uint32_t>(i),
                is_loss ? static_cast<std::uint32_t>(found - losses.begin()) : none, v);
        }
      }
    }
  }

  DisjointSets groups_;
  DisjointSets ends_;
  std::vector<std::uint8_t> begins_;
  std::vector<std::uint8_t> is_beside_kept_;
};

// A place where losses begin, and whether a sample off the model is near.
struct Beginning {
  std::size_t loss;
  bool is_changed = false;
};

std::vector<Beginning> beginnings(const ModelIndex& model, const std::vector<Loss>& losses,
                                  const Groups& groups, std::span<const Scan> scans,
                                  std::span<const NearestPointTree> samples,
                                  const UnscannedOptions& options) {
  std::vector<Beginning> found;
  std::vector<Point> places;
  double spacing = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    if (!groups.begins_at(i)) continue;
    found.push_back({i});
    places.push_back(model.mesh().points[losses[i].vertex]);
    spacing = std::max(spacing, losses[i].spacing);
  }
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const Scan& scan = scans[c];
    const double largest = std::max(scan.spacing, spacing);
    SampleHeights heights(model, scan.samples, places, options.change_reach * largest,
                          options.off_model * largest, scan.shift);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double unit = unit_at(losses[found[k].loss], scan);
      const double off = options.off_model * unit;
      const auto is_off = [&](PointId p) { return heights.squared(p) > off * off; };
      if (samples[c].any_near(places[k], options.change_reach * unit, is_off)) {
        found[k].is_changed = true;
      }
    }
  }
  return found;
}

// By `part_of` of a loss: which parts have that share of their beginnings changed.
template <class PartOf>
std::vector<std::uint8_t> changed_parts(const std::vector<Beginning>& beginnings,
                                        std::size_t losses, double share, const PartOf& part_of) {
  std::vector<std::size_t> all(losses, 0);
  std::vector<std::size_t> changed(losses, 0);
  for (const Beginning& beginning : beginnings) {
    const std::size_t part = part_of(beginning.loss);
    ++all[part];
    changed[part] += beginning.is_changed ? 1 : 0;
  }
  std::vector<std::uint8_t> is_changed(losses, 0);
  for (std::size_t i = 0; i < losses; ++i) {
    is_changed[i] =
        all[i] > 0 && static_cast<double>(changed[i]) >= share * static_cast<double>(all[i]);
  }
  return is_changed;
}

// Which losses a change of the surface explains: by groups, or if `by_ends` those groups all of
// whose ends are explained, with nothing beside them that stays.
std::vector<std::uint8_t> explained_by_changes(const ModelIndex& model,
                                               const std::vector<Loss>& losses,
                                               std::span<const VertexId> lost,
                                               std::span<const Scan> scans,
                                               std::span<const NearestPointTree> samples,
                                               bool by_ends, const UnscannedOptions& options) {
  Groups groups(model, losses, lost);
  const std::vector<Beginning> found = beginnings(model, losses, groups, scans, samples, options);
  const auto group_of = [&](std::size_t i) { return groups.group_of(i); };
  std::vector<std::uint8_t> is_explained =
      changed_parts(found, losses.size(), options.explained, group_of);
  if (by_ends) {
    const auto end_of = [&](std::size_t i) { return groups.end_of(i); };
    const std::vector<std::uint8_t> ends =
        changed_parts(found, losses.size(), options.explained, end_of);
    for (const Beginning& beginning : found) {
      const std::size_t i = beginning.loss;
      if (ends[end_of(i)] == 0 || groups.is_beside_kept(i)) is_explained[group_of(i)] = 0;
    }
  }
  std::vector<std::uint8_t> explained;
  for (std::size_t i = 0; i < losses.size(); ++i) explained.push_back(is_explained[group_of(i)]);
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
  if (!losses.empty() && static_cast<double>(losses.size()) <= most) {
    explained = explained_by_changes(model, losses, lost, scans, samples, lost_handles, options);
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
