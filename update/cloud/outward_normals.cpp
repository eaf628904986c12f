#include "update/cloud/outward_normals.h"

#include <cstdint>

#include "cocone/orient_surface.h"
#include "geom/edge_components.h"
#include "geom/id_vector.h"

namespace cocoon {

namespace {

// The surface with its parts oriented, though some may have their inside outside.
struct OrientedParts {
  TriangleMesh mesh;
  EdgeComponents components;
  IdVector<VertexId, std::uint32_t> part_at;  // of a triangle at each vertex

  explicit OrientedParts(const TriangleMesh& surface)
      : mesh(surface), part_at(surface.points.size(), 0) {
    components = edge_components(mesh, link_halfedges(mesh));
    orient_surface(mesh, components);
    for (const TriangleId t : mesh.triangles.ids()) {
      for (const VertexId v : mesh.triangles[t]) part_at[v] = part(t);
    }
  }

  std::uint32_t part(TriangleId t) const { return components.component_of[t.index()]; }

  // Weighted by area; each part's turned over where its sign is negative.
  IdVector<VertexId, Vec3> normals(const std::vector<double>& signs) const {
    IdVector<VertexId, Vec3> sums(mesh.points.size());
    for (const TriangleId t : mesh.triangles.ids()) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Point& origin = mesh.points[a];
      const Vec3 twice_area = cross(mesh.points[b] - origin, mesh.points[c] - origin);
      for (const VertexId v : {a, b, c}) sums[v] = sums[v] + signs[part(t)] * twice_area;
    }
    for (Vec3& sum : sums) sum = unit(sum);
    return sums;
  }
};

// For each part 1 or -1, or 0 where nothing is known.
std::vector<double> signs_of_parts(const ModelIndex& model, const OrientedParts& parts,
                                   const CloudRim& rim, const Overlap& overlap) {
  const std::vector<EdgeComponent>& components = parts.components.components;
  const IdVector<VertexId, Vec3> normals = parts.normals(std::vector<double>(components.size(), 1));
  std::vector<double> votes(components.size(), 0);
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (overlap.loops[l].match != LoopMatch::on_model) continue;
    for (std::size_t i = 0; i < rim.loops[l].size(); ++i) {
      const TriangleId facet = overlap.loops[l].facets[i];
      const VertexId v = rim.loops[l].vertices[i];
      if (!facet.is_none()) votes[parts.part_at[v]] += dot(normals[v], model.normal(facet));
    }
  }
  for (std::size_t k = 0; k < votes.size(); ++k) {
    const double sign = votes[k] > 0 ? 1 : votes[k] < 0 ? -1 : 0;
    votes[k] = components[k].is_contradictory ? 0 : sign;
  }
  return votes;
}

}  // namespace

std::vector<Vec3> outward_normals(const ModelIndex& model, Points cloud,
                                  const CloudSurface& surface, const Overlap& overlap) {
  const OrientedParts parts(surface.mesh);
  const IdVector<VertexId, Vec3> normals =
      parts.normals(signs_of_parts(model, parts, surface.rim, overlap));
  std::vector<Vec3> outward(cloud.size());
  for (const VertexId v : normals.ids()) outward[surface.point_of_vertex[v].index()] = normals[v];
  return outward;
}

}  // namespace cocoon
