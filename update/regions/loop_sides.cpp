#include "update/regions/loop_sides.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "cocone/boundary_loops.h"
#include "geom/arrays/sort_ids.h"

namespace cocoon {

namespace {

// The facets of the band, each once.
std::vector<TriangleId> band_facets(const LoopBorder& band) {
  std::vector<TriangleId> facets;
  band.for_each_facet([&](TriangleId t) { facets.push_back(t); });
  make_set(facets);
  return facets;
}

// The facet of the model across the edge of `facet` that does not hold the third corner.
TriangleId across(const TriangleMesh& model, const TriangleNeighbors& neighbors, TriangleId facet,
                  VertexId from, VertexId to) {
  const Triangle& corners = model.triangles[facet];
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] != from && corners[i] != to) return neighbors[facet][i];
  }
  return {};
}

// The band as a mesh of its own, with vertices numbered from 0.
TriangleMesh band_mesh(const TriangleMesh& model, const std::vector<TriangleId>& facets,
                       std::vector<VertexId>& model_vertex) {
  for (const TriangleId t : facets) {
    const Triangle& corners = model.triangles[t];
    model_vertex.insert(model_vertex.end(), corners.begin(), corners.end());
  }
  make_set(model_vertex);
  auto local = [&](VertexId v) {
    const auto position = std::lower_bound(model_vertex.begin(), model_vertex.end(), v);
    return VertexId(static_cast<std::size_t>(position - model_vertex.begin()));
  };
  TriangleMesh mesh;
  for (const VertexId v : model_vertex) mesh.points.push_back(model.points[v]);
  for (const TriangleId t : facets) {
    const Triangle& corners = model.triangles[t];
    mesh.triangles.push_back({local(corners[0]), local(corners[1]), local(corners[2])});
  }
  return mesh;
}

std::size_t facets_of(const Regions& regions, RegionId r) {
  return r.is_none() ? 0 : regions.regions[r].facets;
}

// The region with most edges; of several the largest.
RegionId majority(const std::map<RegionId, std::size_t>& edges_at, const Regions& regions) {
  RegionId best;
  std::pair<std::size_t, std::size_t> most;
  for (const auto& [region, edges] : edges_at) {
    const std::pair own(edges, facets_of(regions, region));
    if (own > most) {
      best = region;
      most = own;
    }
  }
  return best;
}

}  // namespace

LoopSides loop_sides(const TriangleMesh& model, const TriangleNeighbors& neighbors,
                     const LoopBorder& band, const Regions& regions) {
  LoopSides result;
  const std::vector<TriangleId> facets = band_facets(band);
  std::vector<VertexId> model_vertex;
  const TriangleMesh mesh = band_mesh(model, facets, model_vertex);

  for (const BoundaryLoop& curve : boundary_loops(mesh, {.min_component_share = 0}).loops) {
    std::map<RegionId, std::size_t> edges_at;
    for (const BoundaryEdge& edge : curve.edges) {
      const TriangleId other =
          across(model, neighbors, facets[edge.triangle.index()], model_vertex[edge.from.index()],
                 model_vertex[edge.to.index()]);
      if (other.is_none() || regions.region_of_facet[other].is_none()) continue;
      ++edges_at[regions.region_of_facet[other]];
    }
    result.sides.push_back({curve.edges.size(), majority(edges_at, regions)});
  }
  std::sort(result.sides.begin(), result.sides.end(), [&](const LoopSide& a, const LoopSide& b) {
    return std::tuple(b.edges, facets_of(regions, b.region), a.region) <
           std::tuple(a.edges, facets_of(regions, a.region), b.region);
  });

  std::vector<RegionId> at_sides;  // longest first
  for (const LoopSide& side : result.sides) {
    if (!side.region.is_none()) at_sides.push_back(side.region);
  }
  if (!band.closed) {
    result.separation = Separation::open_band;
  } else if (at_sides.size() < 2) {
    result.separation = Separation::encloses_nothing;
  } else if (at_sides[0] == at_sides[1]) {
    result.separation = Separation::non_separating;
  }
  return result;
}

}  // namespace cocoon
