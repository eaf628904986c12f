#include "update/replace_points.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geom/arrays/large_pages.h"
#include "geom/arrays/list_edit.h"
#include "geom/arrays/sort_ids.h"
#include "geom/box.h"
#include "geom/errors.h"
#include "geom/messages/require_size.h"
#include "geom/search/equal_points.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/rim_index.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Whether the vertex is close to a point of the first cloud, second cloud, ...
class ThinningTest {
 public:
  ThinningTest(std::span<const CloudRim> rims, std::span<const std::vector<Point>> clouds,
               double share) {
    if (!(share > 0)) return;
    for (std::size_t c = 0; c < clouds.size(); ++c) {
      if (clouds[c].empty()) continue;
      const double reach = share * rims[c].spacing;
      clouds_.push_back({NearestPointTree(clouds[c]), reach * reach});
    }
  }
  bool is_on() const { return !clouds_.empty(); }
  bool is_thinned(const Point& p) const {
    for (const Cloud& cloud : clouds_) {
      if (cloud.points.nearest(p).squared_distance < cloud.squared_reach) return true;
    }
    return false;
  }

 private:
  struct Cloud {
    NearestPointTree points;
    double squared_reach;
  };
  std::vector<Cloud> clouds_;
};

// The vertices to be looked at, ascending: all but those of the region that nothing is said of; all
// if it is none.
std::vector<VertexId> not_plain(RegionId plain, const Regions& regions,
                                const SparseVector<VertexId, Scanned>& scanned,
                                std::span<const VertexId> overlooked) {
  std::vector<VertexId> found(overlooked.begin(), overlooked.end());
  const auto take = [&](VertexId v) { found.push_back(v); };
  regions.group_of_vertex.visit_where([&](RegionId r) { return plain.is_none() || r != plain; },
                                      take);
  scanned.visit_where([](Scanned s) { return s != Scanned::unclear; }, take);
  make_set(found);
  return found;
}

// Whether a vertex goes because the regions around it do, or stays because they do and no rim is
// there; nothing if they differ. Parts of what a rim encloses border on each other without a rim
// between: islands that were split off, and what several clouds cut.
std::optional<bool> told_by_regions(const ModelIndex& model, const Regions& regions,
                                    const RegionChoice& choice, VertexId v) {
  bool goes = false;
  bool stays = false;
  bool at_rim = false;
  for (const TriangleId t : model.triangles_at(v)) {
    const RegionId r = regions.region_of_facet[t];
    (r.is_none() ? at_rim : choice.replaced[r] != 0 ? goes : stays) = true;
  }
  if (goes == stays || (stays && at_rim)) return std::nullopt;
  return goes;
}

// Whether all regions around a vertex and its neighbors go, and there is one.
bool is_enclosed(const ModelIndex& model, const Regions& regions, const RegionChoice& choice,
                 VertexId v) {
  bool any = false;
  for (const TriangleId t : model.triangles_at(v)) {
    for (const VertexId neighbor : model.mesh().triangles[t]) {
      for (const TriangleId around : model.triangles_at(neighbor)) {
        const RegionId r = regions.region_of_facet[around];
        if (r.is_none()) continue;
        if (choice.replaced[r] == 0) return false;
        any = true;
      }
    }
  }
  return any;
}

// Of a vertex that regions do not tell about.
struct ToldByRim {
  bool goes = false;
  bool is_enclosed = false;  // and goes though it is on the other side
};

ToldByRim told_by_rim(const ModelIndex& model, const Regions& regions, const RegionChoice& choice,
                      const RimIndex& rims, VertexId v, const ReplaceOptions& options) {
  const RimSide side = rims.side_of(model.mesh().points[v]);
  if (side.on_cloud_side) return {.goes = true};
  const bool enclosed =
      options.enclosed_go && side.at_partial_loop && is_enclosed(model, regions, choice, v);
  return {enclosed, enclosed};
}

// Whether samples at the very rim tell that it is the other way round. Where no region goes there
// is nothing to replace, and no sample takes a vertex away.
bool samples_overrule(Scanned by_samples, bool replaced, bool any_region_goes) {
  if (replaced) return by_samples == Scanned::no;
  return by_samples == Scanned::yes && any_region_goes;
}

// Merges equal points, keeping the first of each in place; returns the new position of every old
// one.
std::vector<PointId> merge_equal(std::vector<Point>& points,
                                 std::span<const RepeatedPoint> repeated) {
  std::vector<PointId> new_position(points.size());
  auto next = repeated.begin();
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next != repeated.end() && next->point == i) {
      new_position[i] = new_position[next->first];
      ++next;
      continue;
    }
    if (count != i) points[count] = points[i];
    new_position[i] = PointId(count++);
  }
  points.resize(count);
  return new_position;
}

// The points that stay, and then the clouds.
std::vector<Point> gather(Points model, const ListEdit<VertexId>& edit,
                          std::span<const std::vector<Point>> clouds) {
  std::vector<Point> points;
  std::size_t count = edit.size_after(model.size());
  for (const std::vector<Point>& cloud : clouds) count += cloud.size();
  points.reserve(count);
  prefer_large_pages(points);
  for (const KeptRun& run : kept_runs(edit, model.size())) {
    const Points kept = model.subspan(run.from, run.count);
    points.insert(points.end(), kept.data(), kept.data() + kept.size());
  }
  for (const std::vector<Point>& cloud : clouds) {
    points.insert(points.end(), cloud.begin(), cloud.end());
  }
  return points;
}

// Where the vertices of the model that stay and lie in the box came to lie among the points.
std::vector<std::uint32_t> kept_in(const ModelIndex& model, const Box& box,
                                   const ListEdit<VertexId>& edit) {
  std::vector<std::uint32_t> kept;
  auto removed = edit.removed.begin();
  model.for_each_vertex_in(box, [&](VertexId v) {
    while (removed != edit.removed.end() && *removed < v) ++removed;
    if (removed != edit.removed.end() && *removed == v) return;
    kept.push_back(v.value - static_cast<std::uint32_t>(removed - edit.removed.begin()));
  });
  return kept;
}

// Those that are equal to others. The first `kept` are of the model.
std::vector<RepeatedPoint> repeated_among(Points points, std::size_t kept, const ModelIndex& model,
                                          const ListEdit<VertexId>& edit) {
  if (!model.has_distinct_points()) return repeated_points(points);
  return repeated_points(points, kept, kept_in(model, box_of(points.subspan(kept)), edit));
}

// Fills in the updated points: those that stay, then the clouds, equal ones once. Returns where
// each came to lie; nothing if all are different.
std::vector<PointId> add_clouds(const ModelIndex& model, const ListEdit<VertexId>& edit,
                                std::span<const std::vector<Point>> clouds, Replacement& result) {
  result.points = gather(model.mesh().points.span(), edit, clouds);
  const std::vector<RepeatedPoint> repeated =
      repeated_among(result.points, result.kept, model, edit);
  result.duplicates = repeated.size();
  result.kept_are_distinct = repeated.empty() || repeated.front().point >= result.kept;
  if (repeated.empty()) return {};
  return merge_equal(result.points, repeated);
}

// Where the model vertices went, and the points of the clouds behind them.
void tell_positions(const ListEdit<VertexId>& edit, std::size_t num_vertices,
                    std::span<const std::vector<Point>> clouds,
                    std::span<const PointId> new_position, Replacement& result) {
  const auto position = [&](std::size_t gathered) {
    return new_position.empty() ? PointId(gathered) : new_position[gathered];
  };
  result.point_of_vertex.reserve(num_vertices);
  prefer_large_pages(result.point_of_vertex.raw());
  result.point_of_vertex.resize(num_vertices);
  for (const KeptRun& run : kept_runs(edit, num_vertices)) {
    for (std::size_t k = 0; k < run.count; ++k) {
      result.point_of_vertex[VertexId(run.from + k)] = position(run.to + k);
    }
  }
  std::size_t next = edit.size_after(num_vertices);
  for (const std::vector<Point>& cloud : clouds) {
    IdVector<PointId, PointId> positions;
    for (std::size_t k = 0; k < cloud.size(); ++k) positions.push_back(position(next++));
    result.point_of_cloud_point.push_back(std::move(positions));
  }
}

void require_ascending(std::span<const VertexId> vertices, std::size_t count) {
  if (std::is_sorted(vertices.begin(), vertices.end()) &&
      (vertices.empty() || vertices.back().index() < count)) {
    return;
  }
  throw InputError("replace_points: said vertices are to be ascending, and of the model");
}

void require_inputs(const ModelIndex& index, const Regions& regions, const RegionChoice& choice,
                    std::span<const CloudRim> rims, std::span<const std::vector<Point>> clouds,
                    const ReplaceOptions& options, const SaidVertices& said) {
  require_options("replace_points", options);
  require_size("replace_points", "groups of vertices", regions.group_of_vertex.size(),
               index.mesh().points.size());
  require_size("replace_points", "flags of replaced regions", choice.replaced.size(),
               regions.regions.size());
  require_size("replace_points", "rims of clouds", rims.size(), clouds.size());
  require_ascending(said.go, index.mesh().points.size());
  require_ascending(said.stay, index.mesh().points.size());
}

}  // namespace

Replacement replace_points(const ModelIndex& index, const Regions& regions,
                           const RegionChoice& choice, std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds,
                           std::span<const std::vector<Point>> added, const ReplaceOptions& options,
                           const SaidVertices& said) {
  const TriangleMesh& model = index.mesh();
  require_inputs(index, regions, choice, rims, clouds, options, said);
  Replacement result;
  const RimIndex rim_index(rims);
  const ThinningTest thinning(rims, clouds, options.thinning_distance);
  const SparseVector<VertexId, Scanned> scanned =
      scanned_vertices(index, regions, rim_index, rims, clouds, options.scanned);

  // 1. Who goes. Most vertices stay: those in the middle of the largest region that does.
  const bool any_region_goes = std::count(choice.replaced.begin(), choice.replaced.end(), 1) > 0;
  ListEdit<VertexId> edit;
  const auto decide = [&](VertexId v) {
    const RegionId group = regions.group_of_vertex[v];
    const bool on_border = group.is_none();
    if (on_border && !index.is_used(v)) {
      ++result.unused_vertices;
      edit.removed.push_back(v);
      return;
    }
    const std::optional<bool> told =
        on_border ? told_by_regions(index, regions, choice, v) : choice.replaced[group] != 0;
    const ToldByRim by_rim =
        told ? ToldByRim() : told_by_rim(index, regions, choice, rim_index, v, options);
    bool replaced = told ? *told : by_rim.goes;
    result.enclosed_replaced += by_rim.is_enclosed ? 1U : 0U;
    if (samples_overrule(scanned[v], replaced, any_region_goes)) {
      replaced = !replaced;
      ++(replaced ? result.scanned_replaced : result.unscanned_kept);
    }
    if (std::binary_search((replaced ? said.stay : said.go).begin(),
                           (replaced ? said.stay : said.go).end(), v)) {
      replaced = !replaced;
      ++(replaced ? result.overlooked : result.unchanged);
    }
    if (on_border) ++(replaced ? result.border_replaced : result.border_kept);
    if (replaced) {
      ++result.replaced;
      edit.removed.push_back(v);
    } else if (thinning.is_thinned(model.points[v])) {
      ++result.thinned;
      edit.removed.push_back(v);
    }
  };
  const RegionId plain = thinning.is_on() ? RegionId() : largest_kept_region(regions, choice);
  for (const VertexId v : not_plain(plain, regions, scanned, said.go)) decide(v);
  result.kept = edit.size_after(model.points.size());

  // 2. Then the clouds; equal points once.
  const std::vector<PointId> new_position = add_clouds(index, edit, added, result);

  // 3. Where everything went.
  tell_positions(edit, model.points.size(), added, new_position, result);
  result.removed = std::move(edit.removed);
  return result;
}

}  // namespace cocoon
