#include "update/cloud/outward_normals.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "cocone/orient_surface.h"
#include "geom/id_vector.h"
#include "geom/mesh/edge_components.h"
#include "geom/search/closest_facet.h"
#include "geom/triangle_normal.h"
#include "update/cloud/area_normals.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Cosines whose sum is not more than so much for each of them are nothing but rounding.
constexpr double rounding_of_cosine = 1e-12;

// The points of the rim that lie on the model.
struct RimOnModel {
  std::vector<VertexOfPart> corners;  // of the part of the surface that ends there
  std::vector<TriangleId> facets;     // of the model
};

RimOnModel rim_on_model(const EdgeComponents& parts, const CloudRim& rim, const Overlap& overlap) {
  RimOnModel found;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (overlap.loops[l].match != LoopMatch::on_model) continue;
    const RimLoop& loop = rim.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const TriangleId facet = overlap.loops[l].facets[i];
      if (facet.is_none()) continue;
      found.corners.push_back({loop.vertices[i], parts.component_of[loop.triangles[i].index()]});
      found.facets.push_back(facet);
    }
  }
  return found;
}

// For each part of an oriented surface 1 if it faces as the model does, -1 if the other way, 0 if
// that is not known.
std::vector<int> ways_of_parts(const ModelIndex& model, const TriangleMesh& mesh,
                               const EdgeComponents& parts, const CloudRim& rim,
                               const Overlap& overlap) {
  const auto [corners, facets] = rim_on_model(parts, rim, overlap);
  const std::vector<Vec3> normals = area_normals_of_parts(mesh, parts.component_of, corners);
  std::vector<double> votes(parts.components.size(), 0);
  std::vector<double> voters(parts.components.size(), 0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    votes[corners[k].part] += dot(normals[k], model.normal(facets[k]));
    ++voters[corners[k].part];
  }
  std::vector<int> ways;
  for (std::size_t k = 0; k < votes.size(); ++k) {
    const double least = rounding_of_cosine * voters[k];
    const int way = votes[k] > least ? 1 : votes[k] < -least ? -1 : 0;
    ways.push_back(parts.components[k].is_contradictory ? 0 : way);
  }
  return ways;
}

Vec3 normal_of(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = corners_of(mesh, t);
  return unit(area_normal(a, b, c));
}

// Parts of which nothing is known so far, and that hang outside of the model.
void turn_away(const ModelIndex& model, const TriangleMesh& mesh, const EdgeComponents& parts,
               double reach, double min_cosine, std::vector<int>& ways) {
  std::vector<Point> centers;
  std::vector<TriangleId> triangles;
  for (const TriangleId t : mesh.triangles.ids()) {
    const std::uint32_t part = parts.component_of[t.index()];
    if (ways[part] != 0 || parts.components[part].is_contradictory) continue;
    const auto& [a, b, c] = corners_of(mesh, t);
    centers.push_back((1.0 / 3) * (a + b + c));
    triangles.push_back(t);
  }
  if (centers.empty()) return;
  const std::vector<ClosestFacet> feet = closest_facets(model, centers, reach);
  std::vector<double> cosines(ways.size(), 0);
  for (std::size_t k = 0; k < centers.size(); ++k) {
    const Vec3 away = unit(centers[k] - feet[k].point);
    if (dot(away, model.normal(feet[k].triangle)) <= 0) continue;  // inside
    cosines[parts.component_of[triangles[k].index()]] += dot(away, normal_of(mesh, triangles[k]));
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double limit = min_cosine * static_cast<double>(parts.components[k].triangles);
    if (std::abs(cosines[k]) > limit) ways[k] = cosines[k] > 0 ? 1 : -1;
  }
}

// The mean normal of the model at the points of the rim. Its length tells how much they agree.
Vec3 mean_normal_at_rim(const ModelIndex& model, const Overlap& overlap) {
  Vec3 sum;
  double count = 0;
  for (const LoopOverlap& loop : overlap.loops) {
    if (loop.match != LoopMatch::on_model) continue;
    for (const TriangleId facet : loop.facets) {
      if (facet.is_none()) continue;
      sum = sum + model.normal(facet);
      ++count;
    }
  }
  return count > 0 ? (1 / count) * sum : sum;
}

// 1 if the triangle faces this direction, -1 if it does when turned over, 0 if it is too steep.
int way_to(const Vec3& view, const TriangleMesh& mesh, TriangleId t, double min_cosine) {
  const double cosine = dot(normal_of(mesh, t), view);
  return cosine > min_cosine ? 1 : cosine < -min_cosine ? -1 : 0;
}

// The triangles of which it is known which way they face, facing outward.
struct TurnedSurface {
  TriangleMesh mesh;
  IdVector<VertexId, Vec3> views;  // as Outward::view
};

TurnedSurface turned_outward(const ModelIndex& model, TriangleMesh mesh, const CloudRim& rim,
                             const Overlap& overlap, const OutwardOptions& options) {
  const EdgeComponents parts = edge_components(mesh, link_halfedges(mesh));
  orient_surface(mesh, parts);
  std::vector<int> ways = ways_of_parts(model, mesh, parts, rim, overlap);
  turn_away(model, mesh, parts, rim.median_edge, options.min_part_cosine, ways);
  const Vec3 mean = mean_normal_at_rim(model, overlap);
  const Vec3 view = norm(mean) >= options.min_agreement ? unit(mean) : Vec3{};
  TurnedSurface turned{{}, IdVector<VertexId, Vec3>(mesh.points.size(), Vec3{})};
  for (const TriangleId t : mesh.triangles.ids()) {
    int way = ways[parts.component_of[t.index()]];
    const bool is_presumed = way == 0 && view != Vec3{};
    if (is_presumed) way = way_to(view, mesh, t, options.min_view_cosine);
    if (way == 0) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    turned.mesh.triangles.push_back(way > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    if (!is_presumed) continue;
    for (const VertexId v : {a, b, c}) turned.views[v] = view;
  }
  turned.mesh.points = std::move(mesh.points);
  return turned;
}

}  // namespace

std::vector<Outward> outward_normals(const ModelIndex& model, Points cloud,
                                     const CloudSurface& surface, const Overlap& overlap,
                                     const OutwardOptions& options) {
  require_options("outward_normals", options);
  const TurnedSurface turned = turned_outward(model, surface.mesh, surface.rim, overlap, options);
  const IdVector<VertexId, Vec3> normals = area_normals(turned.mesh);
  std::vector<Outward> outward(cloud.size());
  for (const VertexId v : normals.ids()) {
    outward[surface.point_of_vertex[v].index()] = {normals[v], turned.views[v]};
  }
  return outward;
}

}  // namespace cocoon
