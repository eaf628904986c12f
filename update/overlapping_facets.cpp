#include "update/overlapping_facets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "geom/nearest_point.h"
#include "geom/triangle_projection.h"
#include "update/median.h"

namespace cocoon {

namespace {

constexpr std::size_t points_per_chunk = 64;

// A rim point by loop and position, so that all loops are one parallel range.
struct RimPoint {
  std::size_t loop;
  std::size_t index;
};

std::vector<RimPoint> all_points(const CloudRim& rim) {
  std::vector<RimPoint> points;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    for (std::size_t i = 0; i < rim.loops[l].size(); ++i) points.push_back({l, i});
  }
  return points;
}

// The median edge of a facet: the spacing of the model there.
double facet_spacing(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& v = mesh.triangles[t];
  return median({distance(mesh.points[v[0]], mesh.points[v[1]]),
                 distance(mesh.points[v[1]], mesh.points[v[2]]),
                 distance(mesh.points[v[2]], mesh.points[v[0]])});
}

// +1 or -1 per loop: does its surface face like the model or the other way?
std::vector<double> facing_signs(const ModelIndex& model, const CloudRim& rim,
                                 const std::vector<RimPoint>& points,
                                 const std::vector<ClosestFacet>& closest) {
  std::vector<double> votes(rim.loops.size(), 0.0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const RimLoop& loop = rim.loops[points[k].loop];
    votes[points[k].loop] += dot(loop.normals[points[k].index], model.normal(closest[k].triangle));
  }
  for (double& vote : votes) vote = vote < 0 ? -1 : 1;
  return votes;
}

// The paper's choice: the facet at the nearest vertex that contains the projection of b (Eq. 1-3);
// of several the one with the least distance |D| from its plane.
ClosestFacet star_facet(const ModelIndex& model, const Point& b, double max_distance) {
  const TriangleMesh& mesh = model.mesh();
  ClosestFacet best;
  best.squared_distance = max_distance * max_distance;
  for (const TriangleId t : model.adjacency().triangles_at(model.nearest_vertex(b))) {
    const Triangle& v = mesh.triangles[t];
    const PlaneProjection projection =
        project_to_triangle_plane(b, {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]});
    if (!projection.is_inside()) continue;
    const double squared = projection.signed_distance * projection.signed_distance;
    if (squared > best.squared_distance) continue;
    if (squared == best.squared_distance && !best.triangle.is_none()) continue;
    best = {t, projection.projected, squared};
  }
  return best;
}

struct Location {
  ClosestFacet facet;  // triangle none: unmatched
  bool star_miss = false;
  bool facing_away = false;
  bool steep = false;
};

constexpr std::uint32_t any_component = 0xFFFFFFFFU;

// One rim point and what its facet must be like.
struct Query {
  Point point;
  Vec3 facing;  // the cloud's normal, on the model's side
  double rim_spacing = 0;
  TriangleId closest;  // the closest facet of all
  std::uint32_t component = any_component;
};

Location locate(const ModelIndex& model, const Query& query, const OverlapOptions& options) {
  const double spacing = std::max(query.rim_spacing, facet_spacing(model.mesh(), query.closest));
  const double max_distance = options.max_distance * spacing;
  // A point without a normal, or a facet without area, has no side to be on.
  auto faces_at_least = [&](double cosine) {
    return [&model, &query, cosine](TriangleId t) {
      if (query.component != any_component && model.component(t) != query.component) return false;
      if (query.facing == Vec3{} || model.normal(t) == Vec3{}) return true;
      return dot(model.normal(t), query.facing) >= cosine;
    };
  };
  Location location;
  location.facing_away = !faces_at_least(options.min_normal_cosine)(query.closest);
  if (options.rule == LocationRule::nearest_vertex_star) {
    location.facet = star_facet(model, query.point, max_distance);
    if (!location.facet.triangle.is_none()) return location;
    location.star_miss = true;
  }
  // The closest facet that does not face away; one that faces as the cloud does instead if there is
  // one hardly farther away.
  location.facet = model.closest(query.point, max_distance * max_distance,
                                 faces_at_least(-options.min_normal_cosine));
  if (location.facet.triangle.is_none()) return location;
  if (faces_at_least(options.min_normal_cosine)(location.facet.triangle)) return location;
  const double reach = std::min(max_distance, std::sqrt(location.facet.squared_distance) +
                                                  options.facing_preference * spacing);
  const ClosestFacet facing =
      model.closest(query.point, reach * reach, faces_at_least(options.min_normal_cosine));
  location.steep = facing.triangle.is_none();
  if (!location.steep) location.facet = facing;
  return location;
}

// The component that most points of each loop lie on; any_component if too many do not.
std::vector<std::uint32_t> main_components(const ModelIndex& model, const CloudRim& rim,
                                           const std::vector<RimPoint>& points,
                                           const std::vector<Location>& located, double max_share) {
  std::vector<std::map<std::uint32_t, std::size_t>> counts(rim.loops.size());
  std::vector<std::size_t> matched(rim.loops.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TriangleId facet = located[k].facet.triangle;
    if (facet.is_none()) continue;
    ++counts[points[k].loop][model.component(facet)];
    ++matched[points[k].loop];
  }
  std::vector<std::uint32_t> result(rim.loops.size(), any_component);
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    for (const auto& [component, count] : counts[l]) {
      const double others = static_cast<double>(matched[l] - count);
      if (others <= max_share * static_cast<double>(matched[l])) result[l] = component;
    }
  }
  return result;
}

// Enters what was found for each rim point into the result.
void gather_by_loop(const CloudRim& rim, const std::vector<RimPoint>& points,
                    const std::vector<Location>& located, Overlap& overlap) {
  overlap.loops.resize(rim.loops.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Location& location = located[k];
    LoopOverlap& loop = overlap.loops[points[k].loop];
    loop.facets.push_back(location.facet.triangle);
    loop.feet.push_back(location.facet.point);
    overlap.star_misses += location.star_miss ? 1 : 0;
    overlap.facing_away += location.facing_away ? 1 : 0;
    overlap.steep += location.steep ? 1 : 0;
    if (rim.loops[points[k].loop].is_gap_point(points[k].index)) {
      ++loop.gap_points;
      continue;
    }
    if (location.facet.triangle.is_none()) {
      ++loop.unmatched;
      ++overlap.unmatched;
      continue;
    }
    overlap.facets.push_back(location.facet.triangle);
    overlap.largest_distance =
        std::max(overlap.largest_distance, std::sqrt(location.facet.squared_distance));
  }
  std::sort(overlap.facets.begin(), overlap.facets.end());
  overlap.facets.erase(std::unique(overlap.facets.begin(), overlap.facets.end()),
                       overlap.facets.end());
}

LoopMatch match_of(const LoopOverlap& loop, double max_share) {
  const std::size_t points = loop.facets.size() - loop.gap_points;
  const double allowed = max_share * static_cast<double>(points);
  if (static_cast<double>(loop.unmatched - loop.covered) > allowed) return LoopMatch::off_model;
  if (static_cast<double>(points - loop.unmatched) <= allowed) return LoopMatch::covered;
  return LoopMatch::on_model;
}

// Loops off the model are holes inside the cloud, unless the longest loop is one of them.
void match_loops(const CloudRim& rim, double max_share, Overlap& overlap) {
  std::size_t longest = 0;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (rim.loops[l].perimeter > rim.loops[longest].perimeter) longest = l;
    overlap.loops[l].match = match_of(overlap.loops[l], max_share);
  }
  const bool overlaps = !rim.loops.empty() && overlap.loops[longest].match != LoopMatch::off_model;
  overlap.status = overlaps ? OverlapStatus::ok : OverlapStatus::no_overlap;
}

}  // namespace

Overlap overlapping_facets(const ModelIndex& model, const CloudRim& rim,
                           const OverlapOptions& options, const Execution& execution) {
  report_progress(execution, "overlapping_facets", 0);
  const std::vector<RimPoint> points = all_points(rim);

  // 1. The closest facet of all: gives the local spacing and the side the cloud is seen from.
  std::vector<ClosestFacet> closest(points.size());
  parallel_chunks(execution, points.size(), points_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) {
                      closest[k] = model.closest(rim.loops[points[k].loop].points[points[k].index]);
                    }
                  });
  const std::vector<double> signs = facing_signs(model, rim, points, closest);

  // 2. The overlapping facets.
  std::vector<Location> located(points.size());
  auto locate_point = [&](std::size_t k, std::uint32_t component) {
    const RimLoop& loop = rim.loops[points[k].loop];
    const std::size_t i = points[k].index;
    if (loop.is_gap_point(i)) return;
    located[k] = locate(model,
                        {loop.points[i], signs[points[k].loop] * loop.normals[i], rim.spacing,
                         closest[k].triangle, component},
                        options);
  };
  parallel_chunks(execution, points.size(), points_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) locate_point(k, any_component);
                  });
  Overlap overlap;
  const std::vector<std::uint32_t> main =
      main_components(model, rim, points, located, options.max_unmatched_share);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TriangleId facet = located[k].facet.triangle;
    const std::uint32_t component = main[points[k].loop];
    if (facet.is_none() || component == any_component || model.component(facet) == component) {
      continue;
    }
    ++overlap.relocated;
    located[k] = {};
    locate_point(k, component);
  }

  // 3. Gathered by loop, and judged.
  gather_by_loop(rim, points, located, overlap);
  match_loops(rim, options.max_unmatched_share, overlap);
  report_progress(execution, "overlapping_facets", 1);
  return overlap;
}

void excuse_covered_points(std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds, std::span<Overlap> overlaps,
                           const OverlapOptions& options) {
  std::size_t unmatched = 0;
  for (const Overlap& overlap : overlaps) unmatched += overlap.unmatched;
  if (unmatched == 0 || clouds.size() < 2) return;
  std::vector<NearestPointTree> trees;
  for (const std::vector<Point>& cloud : clouds) trees.emplace_back(cloud);

  for (std::size_t c = 0; c < rims.size(); ++c) {
    const double reach = options.max_distance * rims[c].spacing;
    auto is_covered = [&](const Point& p) {
      for (std::size_t other = 0; other < trees.size(); ++other) {
        if (other == c) continue;
        if (trees[other].nearest(p).squared_distance <= reach * reach) return true;
      }
      return false;
    };
    for (std::size_t l = 0; l < rims[c].loops.size(); ++l) {
      LoopOverlap& loop = overlaps[c].loops[l];
      loop.covered = 0;
      for (std::size_t i = 0; i < loop.facets.size(); ++i) {
        if (!loop.facets[i].is_none() || rims[c].loops[l].is_gap_point(i)) continue;
        if (is_covered(rims[c].loops[l].points[i])) ++loop.covered;
      }
    }
    match_loops(rims[c], options.max_unmatched_share, overlaps[c]);
  }
}

Overlap overlapping_facets(const TriangleMesh& model, const CloudRim& rim,
                           const OverlapOptions& options, const Execution& execution) {
  return overlapping_facets(ModelIndex(model), rim, options, execution);
}

}  // namespace cocoon
