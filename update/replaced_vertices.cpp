#include "update/replaced_vertices.h"

#include <algorithm>
#include <optional>

#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"
#include "update/cloud/rim_index.h"
#include "update/model/require_ascending.h"
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
  model.for_each_triangle_at(v, [&](TriangleId t) {
    const RegionId r = regions.region_of_facet[t];
    (r.is_none() ? at_rim : choice.replaced[r] != 0 ? goes : stays) = true;
  });
  if (goes == stays || (stays && at_rim)) return std::nullopt;
  return goes;
}

// Whether all regions around a vertex and its neighbors go, and there is one.
bool is_enclosed(const ModelIndex& model, const Regions& regions, const RegionChoice& choice,
                 VertexId v) {
  bool any_goes = false;
  bool any_stays = false;
  model.for_each_triangle_at(v, [&](TriangleId t) {
    for (const VertexId neighbor : model.mesh().triangles[t]) {
      model.for_each_triangle_at(neighbor, [&](TriangleId around) {
        const RegionId r = regions.region_of_facet[around];
        if (!r.is_none()) (choice.replaced[r] != 0 ? any_goes : any_stays) = true;
      });
    }
  });
  return any_goes && !any_stays;
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

void require_inputs(const ModelIndex& index, const Regions& regions, const RegionChoice& choice,
                    std::span<const CloudRim> rims, std::span<const std::vector<Point>> clouds,
                    const ReplaceOptions& options, const SaidVertices& said) {
  require_options("replaced_vertices", options);
  require_size("replaced_vertices", "groups of vertices", regions.group_of_vertex.size(),
               index.mesh().points.size());
  require_size("replaced_vertices", "flags of replaced regions", choice.replaced.size(),
               regions.regions.size());
  require_size("replaced_vertices", "rims of clouds", rims.size(), clouds.size());
  const std::size_t count = index.mesh().points.size();
  require_ascending("replaced_vertices", "vertices said to go", said.go, count);
  require_ascending("replaced_vertices", "vertices said to stay", said.stay, count);
}

}  // namespace

ReplacedVertices replaced_vertices(const ModelIndex& index, const Regions& regions,
                                   const RegionChoice& choice, std::span<const CloudRim> rims,
                                   std::span<const std::vector<Point>> clouds,
                                   const ReplaceOptions& options, const SaidVertices& said) {
  const TriangleMesh& model = index.mesh();
  require_inputs(index, regions, choice, rims, clouds, options, said);
  ReplacedVertices result;
  const RimIndex rim_index(rims);
  const ThinningTest thinning(rims, clouds, options.thinning_distance);
  const SparseVector<VertexId, Scanned> scanned =
      scanned_vertices(index, regions, rim_index, rims, clouds, options.scanned);

  // Most vertices stay: those in the middle of the largest region that does.
  const bool any_region_goes = std::count(choice.replaced.begin(), choice.replaced.end(), 1) > 0;
  const auto decide = [&](VertexId v) {
    const RegionId group = regions.group_of_vertex[v];
    const bool on_border = group.is_none();
    if (on_border && !index.is_used(v)) {
      ++result.unused_vertices;
      result.removed.push_back(v);
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
      result.removed.push_back(v);
    } else if (thinning.is_thinned(model.points[v])) {
      ++result.thinned;
      result.removed.push_back(v);
    }
  };
  const RegionId plain = thinning.is_on() ? RegionId() : largest_kept_region(regions, choice);
  for (const VertexId v : not_plain(plain, regions, scanned, said.go)) decide(v);
  result.kept = model.points.size() - result.removed.size();
  return result;
}

}  // namespace cocoon
