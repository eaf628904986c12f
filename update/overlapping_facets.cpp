#include "update/overlapping_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/median.h"
#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"
#include "geom/triangle_projection.h"
#include "update/cloud/raised_loops.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

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

// +1 or -1 per point: does the surface at its loop face like the model or the other way? All points
// of a loop vote; of a loop on a one-sided part those next to the point, since the surface goes
// over to the other side of the body somewhere.
std::vector<double> facing_signs(const ModelIndex& model, const CloudRim& rim,
                                 const std::vector<ClosestFacet>& closest, std::size_t window) {
  std::vector<double> signs;
  std::size_t first = 0;  // point of the loop
  for (const RimLoop& loop : rim.loops) {
    const std::size_t size = loop.size();
    std::vector<double> votes;
    for (std::size_t i = 0; i < size; ++i) {
      votes.push_back(dot(loop.normals[i], model.normal(closest[first + i].triangle)));
    }
    const bool all = !loop.one_sided || 2 * window + 1 >= size;
    const double sum = std::accumulate(votes.begin(), votes.end(), 0.0);
    for (std::size_t i = 0; i < size; ++i) {
      double vote = all ? sum : 0;
      for (std::size_t k = 0; !all && k <= 2 * window; ++k) {
        vote += votes[(i + size + k - window) % size];
      }
      signs.push_back(vote < 0 ? -1 : 1);
    }
    first += size;
  }
  return signs;
}

// The paper's choice: of the admitted facets at the nearest vertex, that which contains the
// projection of b (Eq. 1-3); of several the one with the least distance |D| from its plane, ties by
// lexicographic corners.
template <class Admits>
ClosestFacet star_facet(const ModelIndex& model, VertexId nearest, const Point& b,
                        double max_distance, Admits admits) {
  ClosestFacet best;
  best.squared_distance = max_distance * max_distance;
  std::array<Point, 3> corners_of_best{};
  for (const TriangleId t : model.triangles_at(nearest)) {
    if (!admits(t)) continue;
    const std::array<Point, 3> corners = sorted_corners(corners_of(model.mesh(), t));
    const PlaneProjection projection = project_to_triangle_plane(b, corners);
    if (!projection.is_inside()) continue;
    const double squared = projection.signed_distance * projection.signed_distance;
    if (squared > best.squared_distance) continue;
    const bool ties = squared == best.squared_distance && !best.triangle.is_none();
    if (ties && corners >= corners_of_best) continue;
    best = {t, projection.projected, squared};
    corners_of_best = corners;
  }
  return best;
}

// The vertex nearest to a point among those that triangles use, for the paper's choice alone.
// Ties by lexicographic coordinates.
class NearestVertex {
 public:
  explicit NearestVertex(const ModelIndex& model)
      : used_(vertices_in_use(model)), tree_(points_at(model.mesh(), used_)) {}
  VertexId operator()(const Point& p) const { return used_[tree_.nearest(p).point.index()]; }

 private:
  static std::vector<VertexId> vertices_in_use(const ModelIndex& model) {
    std::vector<VertexId> used;
    for (const VertexId v : model.mesh().points.ids()) {
      if (model.is_used(v)) used.push_back(v);
    }
    return used;
  }
  static std::vector<Point> points_at(const TriangleMesh& mesh, const std::vector<VertexId>& used) {
    std::vector<Point> points;
    points.reserve(used.size());
    for (const VertexId v : used) points.push_back(mesh.points[v]);
    return points;
  }

  std::vector<VertexId> used_;
  NearestPointTree tree_;
};

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
  Vec3 facing;           // the cloud's normal, on the model's side
  double spacing = 0;    // of rim and model there
  ClosestFacet closest;  // of all facets
  std::uint32_t component = any_component;
};

// Finds the overlapping facets of rim points.
class Locator {
 public:
  Locator(const ModelIndex& model, const OverlapOptions& options)
      : model_(model), options_(options) {
    if (options.rule == LocationRule::nearest_vertex_star) nearest_vertex_.emplace(model);
  }

  double max_distance(const Query& query) const { return options_.max_distance * query.spacing; }

  // The location of most points: the closest facet of all is fine or too far away, and there is no
  // need to look for another one.
  std::optional<Location> locate_at_once(const Query& query) const {
    const TriangleId closest = query.closest.triangle;
    if (nearest_vertex_ || !is_on_part(query, closest)) return {};
    if (!faces_at_least(query, closest, good())) return {};
    const double max = max_distance(query);
    if (query.closest.squared_distance > max * max) return Location{};
    return Location{.facet = query.closest};
  }

  // `near` reaches max_distance() at least.
  Location locate(const NearFacets& near, const Query& query) const {
    const auto facing = [&](double cosine) {
      return [&, cosine](TriangleId t) {
        return is_on_part(query, t) && faces_at_least(query, t, cosine);
      };
    };
    Location location;
    const double max = max_distance(query);
    location.facing_away = !faces_at_least(query, query.closest.triangle, good());
    if (nearest_vertex_) {
      location.facet = star_facet(model_, (*nearest_vertex_)(query.point), query.point, max,
                                  [&](TriangleId t) { return is_on_part(query, t); });
      if (!location.facet.triangle.is_none()) return location;
      location.star_miss = true;
    }
    // The closest facet that does not face away; one that faces as the cloud does instead if there
    // is one hardly farther away.
    location.facet = near.closest(query.point, max * max, facing(-good()));
    if (location.facet.triangle.is_none()) return location;
    if (faces_at_least(query, location.facet.triangle, good())) return location;
    const double reach = std::min(max, std::sqrt(location.facet.squared_distance) +
                                           options_.facing_preference * query.spacing);
    const ClosestFacet better = near.closest(query.point, reach * reach, facing(good()));
    location.steep = better.triangle.is_none();
    if (!location.steep) location.facet = better;
    return location;
  }

 private:
  double good() const { return options_.min_normal_cosine; }

  bool is_on_part(const Query& query, TriangleId t) const {
    return query.component == any_component || model_.component(t) == query.component;
  }

  // A point without a normal, or a facet without area, has no side to be on.
  bool faces_at_least(const Query& query, TriangleId t, double cosine) const {
    const Vec3 normal = model_.normal(t);
    if (query.facing == Vec3{} || normal == Vec3{}) return true;
    return dot(normal, query.facing) >= cosine;
  }

  const ModelIndex& model_;
  const OverlapOptions& options_;
  std::optional<NearestVertex> nearest_vertex_;
};

// The component that more points of a loop lie on than on any other; any_component if two have as
// many, or more than max_share of the points lie elsewhere.
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
    std::size_t most = 0;
    for (const auto& [component, count] : counts[l]) {
      if (count == most) result[l] = any_component;
      if (count > most) result[l] = component;
      most = std::max(most, count);
    }
    const double others = static_cast<double>(matched[l] - most);
    if (others > max_share * static_cast<double>(matched[l])) result[l] = any_component;
  }
  return result;
}

// Enters what was found for each rim point into the result.
void gather_by_loop(const CloudRim& rim, const std::vector<RimPoint>& points,
                    const std::vector<Location>& located, Overlap& overlap) {
  overlap.loops.resize(rim.loops.size());
  std::vector<double> distances;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Location& location = located[k];
    LoopOverlap& loop = overlap.loops[points[k].loop];
    loop.facets.push_back(location.facet.triangle);
    loop.feet.push_back(location.facet.point);
    overlap.figures.star_misses += location.star_miss ? 1 : 0;
    overlap.figures.facing_away += location.facing_away ? 1 : 0;
    overlap.figures.steep += location.steep ? 1 : 0;
    if (rim.loops[points[k].loop].is_inner_point(points[k].index)) {
      ++loop.inner_points;
      continue;
    }
    if (location.facet.triangle.is_none()) {
      ++loop.unmatched;
      ++overlap.unmatched;
      continue;
    }
    overlap.facets.push_back(location.facet.triangle);
    distances.push_back(std::sqrt(location.facet.squared_distance));
    overlap.figures.largest_distance = std::max(overlap.figures.largest_distance, distances.back());
  }
  overlap.figures.median_distance = median(std::move(distances));
  make_set(overlap.facets);
}

LoopMatch match_of(const LoopOverlap& loop, double max_share) {
  const std::size_t points = loop.facets.size() - loop.inner_points;
  const double allowed = max_share * static_cast<double>(points);
  if (static_cast<double>(loop.unmatched - loop.covered) > allowed) return LoopMatch::off_model;
  if (static_cast<double>(points - loop.unmatched) <= allowed) return LoopMatch::covered;
  return LoopMatch::on_model;
}

// Loops off the model are holes inside the cloud, or parts of it off the model, unless the longest
// loop is one of them.
void match_loops(const CloudRim& rim, const OverlapOptions& options, Overlap& overlap) {
  if (rim.loops.empty()) {
    overlap.status = OverlapStatus::no_overlap;
    return;
  }
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    LoopOverlap& loop = overlap.loops[l];
    loop.match = match_of(loop, options.max_unmatched_share);
    if (loop.match == LoopMatch::on_model && is_raised(loop, options)) {
      loop.match = LoopMatch::off_model;
    }
  }
  LoopOverlap& longest = overlap.loops[rim.longest_loop()];
  if (overlap.figures.in_shadow > 0) longest.match = LoopMatch::on_model;
  const bool overlaps = longest.match != LoopMatch::off_model;
  overlap.status = overlaps ? OverlapStatus::ok : OverlapStatus::no_overlap;
}

// Clouds that cover each other lie on the model if one of them does.
void refuse_off_model(DisjointSets& sets, std::span<Overlap> overlaps) {
  std::vector<std::uint8_t> on_model(overlaps.size(), 0);
  for (std::uint32_t c = 0; c < overlaps.size(); ++c) {
    const auto& loops = overlaps[c].loops;
    const bool any = std::any_of(loops.begin(), loops.end(), [](const LoopOverlap& loop) {
      return loop.match == LoopMatch::on_model;
    });
    if (any) on_model[sets.root(c)] = 1;
  }
  for (std::uint32_t c = 0; c < overlaps.size(); ++c) {
    if (on_model[sets.root(c)] == 0) overlaps[c].status = OverlapStatus::no_overlap;
  }
}

// Fills located[k] for each k of `chosen`.
void locate_points(const ModelIndex& model, const Locator& locator,
                   const std::vector<Query>& queries, const std::vector<std::size_t>& chosen,
                   const Execution& execution, std::vector<Location>& located) {
  std::vector<std::size_t> open;
  std::vector<Point> centers;
  double reach = 0;
  for (const std::size_t k : chosen) {
    if (const std::optional<Location> location = locator.locate_at_once(queries[k])) {
      located[k] = *location;
      continue;
    }
    open.push_back(k);
    centers.push_back(queries[k].point);
    reach = std::max(reach, locator.max_distance(queries[k]));
  }
  if (open.empty()) return;
  const NearFacets near(model, centers, reach);
  parallel_chunks(execution, open.size(), points_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                      located[open[i]] = locator.locate(near, queries[open[i]]);
                    }
                  });
}

}  // namespace

Overlap overlapping_facets(const ModelIndex& model, const CloudRim& rim,
                           const OverlapOptions& options, const Execution& execution) {
  require_options("overlapping_facets", options);
  report_progress(execution, "overlapping_facets", 0);
  const std::vector<RimPoint> points = all_points(rim);

  // 1. The closest facet of all: gives the local spacing and the side the cloud is seen from.
  // Rims lie on the model, so facets within a spacing hold the answer as a rule.
  std::vector<Point> places;
  places.reserve(points.size());
  for (const auto& [l, i] : points) places.push_back(rim.loops[l].points[i]);
  const std::vector<ClosestFacet> closest = closest_facets(model, places, rim.spacing, execution);
  const std::vector<double> signs = facing_signs(model, rim, closest, options.one_sided_window);

  // 2. The overlapping facets.
  std::vector<Query> queries;
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [l, i] = points[k];
    const RimLoop& loop = rim.loops[l];
    queries.push_back({loop.points[i], signs[k] * loop.normals[i],
                       larger_spacing(model, rim, closest[k].triangle), closest[k]});
    if (!loop.is_inner_point(i)) chosen.push_back(k);
  }
  const Locator locator(model, options);
  std::vector<Location> located(points.size());
  locate_points(model, locator, queries, chosen, execution, located);
  Overlap overlap;
  const std::vector<std::uint32_t> main =
      main_components(model, rim, points, located, options.max_unmatched_share);
  std::erase_if(chosen, [&](std::size_t k) {
    const TriangleId facet = located[k].facet.triangle;
    queries[k].component = main[points[k].loop];
    return facet.is_none() || queries[k].component == any_component ||
           model.component(facet) == queries[k].component;
  });
  overlap.figures.relocated = chosen.size();
  locate_points(model, locator, queries, chosen, execution, located);

  // 3. Gathered by loop, and judged.
  gather_by_loop(rim, points, located, overlap);
  measure_excess(model, rim, overlap);
  overlap.leaves_model = overlap.figures.largest_excess > options.raised_distance;
  count_raised(model, rim, options.raised_distance, overlap);
  match_loops(rim, options, overlap);
  report_progress(execution, "overlapping_facets", 1);
  return overlap;
}

void excuse_covered_points(std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds, std::span<Overlap> overlaps,
                           const OverlapOptions& options) {
  constexpr const char* stage = "excuse_covered_points";
  require_size(stage, "clouds", clouds.size(), rims.size());
  require_size(stage, "overlaps", overlaps.size(), rims.size());
  for (std::size_t c = 0; c < rims.size(); ++c) {
    require_size(stage, "loops of an overlap", overlaps[c].loops.size(), rims[c].loops.size());
  }
  require_options(stage, options);
  std::size_t unmatched = 0;
  for (const Overlap& overlap : overlaps) unmatched += overlap.unmatched;
  if (unmatched == 0 || clouds.size() < 2) return;
  const std::vector<NearestPointTree> trees = nearest_point_trees(clouds);

  DisjointSets sets(rims.size());  // of clouds that cover each other
  for (std::uint32_t c = 0; c < rims.size(); ++c) {
    const double reach = options.max_distance * rims[c].spacing;
    auto is_covered = [&](const Point& p) {
      bool found = false;
      for (std::uint32_t other = 0; other < trees.size(); ++other) {
        if (other == c || (found && sets.root(other) == sets.root(c))) continue;
        if (!trees[other].any_near(p, reach)) continue;
        sets.join(c, other);
        found = true;
      }
      return found;
    };
    for (std::size_t l = 0; l < rims[c].loops.size(); ++l) {
      LoopOverlap& loop = overlaps[c].loops[l];
      loop.covered = 0;
      for (std::size_t i = 0; i < loop.facets.size(); ++i) {
        if (!loop.facets[i].is_none() || rims[c].loops[l].is_inner_point(i)) continue;
        if (is_covered(rims[c].loops[l].points[i])) ++loop.covered;
      }
    }
    match_loops(rims[c], options, overlaps[c]);
  }
  refuse_off_model(sets, overlaps);
}

Overlap overlapping_facets(const TriangleMesh& model, const CloudRim& rim,
                           const OverlapOptions& options, const Execution& execution) {
  return overlapping_facets(ModelIndex(model, execution), rim, options, execution);
}

}  // namespace cocoon
