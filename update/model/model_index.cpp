#include "update/model/model_index.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/edited_ids.h"
#include "geom/arrays/sort_ids.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/box.h"
#include "geom/errors.h"
#include "geom/mesh/changed_neighbors.h"
#include "geom/mesh/halfedges.h"
#include "geom/parallel/parallel_reduce.h"
#include "geom/triangle_normal.h"

namespace cocoon {

namespace {

const TriangleMesh& checked(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw InputError("update: the model has no triangles; give a closed mesh or reconstruct one");
  }
  // Nearly always all points are finite: in the order of memory.
  const bool all_finite = std::all_of(mesh.points.begin(), mesh.points.end(),
                                      [](const Point& p) { return is_finite(p); });
  for (const TriangleId t : mesh.triangles.ids()) {
    for (const VertexId v : mesh.triangles[t]) {
      if (v.index() < mesh.points.size() && (all_finite || is_finite(mesh.points[v]))) continue;
      throw InputError("update: triangle " + std::to_string(t.value) +
                       " of the model names vertex " + std::to_string(v.value) +
                       ", which is missing or not finite; repair the mesh");
    }
  }
  return mesh;
}

// Numbered by their first triangles; empty if all are of one component. Each triangle takes over
// the seed of its earliest neighbor before it, and seeds that meet are joined: in the order of
// memory, and without a branch for what cannot be foreseen, which neighbors are earlier. Numbers
// and not ids, since g++ puts ids that are compared into memory.
IdVector<TriangleId, std::uint32_t> components_of(const TriangleNeighbors& neighbors) {
  IdVector<TriangleId, std::uint32_t> components(neighbors.size());  // first, their seeds
  std::vector<std::uint32_t>& seed_of = components.raw();
  std::uint32_t seeds = 0;
  std::vector<std::array<std::uint32_t, 2>> joins;
  std::size_t num_joins = 0;
  const auto smaller = [](std::uint32_t a, std::uint32_t b) { return a < b ? a : b; };
  constexpr std::uint32_t block = 1024;
  for (std::uint32_t t = 0; t < seed_of.size(); ++t) {
    if (t % block == 0) joins.resize(num_joins + 3 * std::size_t{block});
    const auto& next = neighbors[TriangleId(t)];
    const std::uint32_t a = smaller(next[0].value, t);  // none is above all
    const std::uint32_t b = smaller(next[1].value, t);
    const std::uint32_t c = smaller(next[2].value, t);
    const std::uint32_t earliest = smaller(smaller(a, b), c);
    const std::uint32_t taken_over = seed_of[earliest];
    const std::uint32_t seed = earliest < t ? taken_over : seeds;
    seeds += earliest < t ? 0U : 1U;
    seed_of[t] = seed;
    const auto join = [&](std::uint32_t neighbor) {
      const std::uint32_t other = seed_of[neighbor];
      joins[num_joins] = {seed, other};
      num_joins += other != seed ? 1U : 0U;
    };
    join(a);
    join(b);
    join(c);
  }
  DisjointSets sets(seeds);
  for (std::size_t k = 0; k < num_joins; ++k) sets.join(joins[k][0], joins[k][1]);
  std::vector<std::uint32_t> number(seeds);
  std::uint32_t count = 0;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    number[seed] = sets.root(seed) == seed ? count++ : number[sets.root(seed)];
  }
  if (count <= 1) return {};
  for (std::uint32_t& component : components) component = number[component];
  return components;
}

// Whether one can go from each of the triangles, all different, to each other one within them.
bool hang_together(std::span<const TriangleId> triangles, const TriangleNeighbors& neighbors) {
  if (triangles.empty()) return true;
  ZeroedArray<TriangleId, std::uint8_t> open(neighbors.size());  // and not reached yet
  for (const TriangleId t : triangles) open[t] = 1;
  open[triangles[0]] = 0;
  std::size_t count = 1;
  std::vector<TriangleId> stack(1, triangles[0]);
  while (!stack.empty()) {
    const TriangleId t = stack.back();
    stack.pop_back();
    for (const TriangleId next : neighbors[t]) {
      if (next.is_none() || open[next] == 0) continue;
      open[next] = 0;
      ++count;
      stack.push_back(next);
    }
  }
  return count == triangles.size();
}

}  // namespace

ModelIndex::ModelIndex(const TriangleMesh& mesh, const Execution& execution)
    : mesh_(&checked(mesh)),
      neighbors_(triangle_neighbors(mesh, execution)),
      at_vertices_(triangles_at_vertices(mesh, execution)),
      components_(components_of(neighbors_)) {}

ModelIndex::ModelIndex(const TriangleMesh& mesh, const IndexBefore& before) : mesh_(&mesh) {
  const MeshChange& change = before.change;
  std::optional<ChangedNeighbors> changed = changed_neighbors(
      mesh, {before.mesh, before.index.neighbors_, change.vertex_map, change.triangle_map});
  if (!changed) {
    *this = ModelIndex(mesh);
    return;
  }
  neighbors_ = std::move(changed->neighbors);
  at_vertices_ = std::move(changed->at_vertices);
  // From a triangle that stayed one comes, within those that stayed, to one that went, hence to the
  // seam: if that hangs together so does all.
  const bool connected = before.index.is_connected() &&
                         (change.added.empty() || !change.removed.empty()) &&
                         hang_together(changed->seam, neighbors_);
  if (!connected) components_ = components_of(neighbors_);
  distinct_points_ = before.distinct_points;
}

ModelIndex ModelIndex::of_smooth(const TriangleMesh& mesh, const Execution& execution) {
  ModelIndex index;
  index.mesh_ = &mesh;
  index.neighbors_ = triangle_neighbors(mesh, execution);
  index.prepare_for_edits();
  return index;
}

void ModelIndex::prepare_for_edits() {
  distinct_points_ = true;
  at_vertices_ = {};
  triangle_at_.resize(mesh_->points.size());
  cells_ = GridCells(mesh_->points);
  longest_extent_ = 0;
  for (const TriangleId t : mesh_->triangles.ids()) {
    for (const VertexId v : mesh_->triangles[t]) triangle_at_[v] = t;
    take_in_size(t);
  }
}

void ModelIndex::take_in_size(TriangleId t) {
  const Vec3 size = box_of(corners_of(*mesh_, t)).size();
  longest_extent_ = std::max({longest_extent_, size.x, size.y, size.z});
}

// Those that a way around the vertex meets until it comes back; on some meshes it never does: then
// `most` at least.
std::size_t ModelIndex::corners_around(VertexId v, std::size_t most) const {
  const TriangleId first = triangle_at_[v];
  if (first.is_none()) return most;
  std::size_t met = 0;
  TriangleId t = first;
  do {
    t = next_around(v, t);
  } while (++met < most && t != first);
  return met;
}

bool ModelIndex::is_really_smooth(const Execution& execution) const {
  const TriangleNeighbors& neighbors = neighbors_;
  const auto is_closed_at = [&](std::size_t i) {
    const TriangleId t(i);
    return !repeats_a_vertex(mesh_->triangles[t]) &&
           std::none_of(neighbors[t].begin(), neighbors[t].end(),
                        [](TriangleId next) { return next.is_none(); });
  };
  if (first_failing(execution, neighbors.size(), is_closed_at) < neighbors.size()) return false;
  // Ways around all vertices meet all corners, once each.
  const std::size_t corners = 3 * neighbors.size();
  const std::size_t met = parallel_reduce(
      execution, mesh_->points.size(), std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t here = 0;
        for (VertexId v(begin); v.index() < end && here <= corners; ++v) {
          here += corners_around(v, corners + 1);
        }
        return here;
      },
      [](std::size_t a, std::size_t b) { return a + b; });
  return met == corners && components_of(neighbors_).empty();
}

void ModelIndex::edit(const Edit& edit) {
  assert(is_known_smooth());
  TriangleNeighbors& neighbors = neighbors_;
  // Triangles that came, or lost a neighbor.
  std::vector<TriangleId> seam = edit.triangles.added;
  for (const TriangleId t : edit.triangles.removed) {
    for (const TriangleId next : neighbors[t]) {
      const TriangleId now = edit.triangle_map[next];
      if (!now.is_none()) seam.push_back(now);
    }
  }
  make_set(seam);

  constexpr std::array<TriangleId, 3> open{};
  const std::vector fresh(edit.triangles.added.size(), open);
  const EditedIds<TriangleId> triangles(edit.triangles, edit.triangle_map);
  const auto renew = [&](auto block) { return triangles.renew(block); };
  edit_list_by_blocks(neighbors, edit.triangles, fresh, renew);
  link_open_edges(seam);
  const std::vector<TriangleId> none(edit.vertices.added.size());
  edit_list_by_blocks(triangle_at_, edit.vertices, none, renew);
  std::vector<Point> added;
  added.reserve(edit.vertices.added.size());
  for (const VertexId v : edit.vertices.added) added.push_back(mesh_->points[v]);
  cells_.edit(edit.vertices, added);
  for (const TriangleId t : edit.triangles.added) take_in_size(t);
  // Whoever lost a triangle has one beside it, or new ones.
  for (const TriangleId t : seam) {
    for (const VertexId v : mesh_->triangles[t]) triangle_at_[v] = t;
  }
}

// Links these triangles over the edges that have no neighbor, two by two: each waits in a table
// with open addresses, by its edge, for the other one.
void ModelIndex::link_open_edges(std::span<const TriangleId> triangles) {
  struct Waiting {
    std::uint64_t edge = 0;  // no edge: its ends differ
    Halfedge halfedge = 0;
  };
  std::vector<Waiting> table(std::bit_ceil(6 * triangles.size() + 2));
  const std::size_t mask = table.size() - 1;
  TriangleNeighbors& neighbors = neighbors_;
  for (const TriangleId t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!neighbors[t][i].is_none()) continue;
      const auto [a, b] = ends_of_halfedge(*mesh_, halfedge_of(t, i));
      const std::uint64_t edge = std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value;
      std::size_t at = (edge * 0x9E3779B97F4A7C15U) >> 32 & mask;
      while (table[at].edge != 0 && table[at].edge != edge) at = (at + 1) & mask;
      if (table[at].edge == 0) {
        table[at] = {edge, halfedge_of(t, i)};
        continue;
      }
      const Halfedge other = table[at].halfedge;
      const TriangleId across(triangle_of_halfedge(other));
      neighbors[t][i] = across;
      neighbors[across][corner_of_halfedge(other)] = t;
    }
  }
}

std::vector<TriangleId> ModelIndex::triangles_at(VertexId v) const {
  std::vector<TriangleId> found;
  for_each_triangle_at(v, [&](TriangleId t) { found.push_back(t); });
  std::sort(found.begin(), found.end());
  return found;
}

Vec3 ModelIndex::normal(TriangleId t) const {
  const auto [a, b, c] = corners_from_smallest(corners_of(*mesh_, t));
  return unit(area_normal(a, b, c));
}

Point ModelIndex::centroid(TriangleId t) const {
  const auto [a, b, c] = sorted_corners(corners_of(*mesh_, t));
  return (a + b + c) / 3;
}

}  // namespace cocoon
