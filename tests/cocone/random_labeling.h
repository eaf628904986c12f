// Random labelings of small triangulations, with their energy from its definition.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "cocone/clean_up/far_reach.h"
#include "cocone/energy/cell_energy.h"
#include "cocone/energy/doubtful_region.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {

// A center with far more than 64 cells around it.
inline std::vector<Point> ball(std::uint64_t seed) {
  std::vector<Point> points = shapes::sphere(60, seed);
  points.push_back({0, 0, 0});
  return points;
}

struct Labeling {
  explicit Labeling(const std::vector<Point>& points, std::uint64_t seed = 1, double bias = 0.5)
      : Labeling(delaunay(points).triangulation, seed, bias) {}
  explicit Labeling(Triangulation of_points, std::uint64_t seed = 1, double bias = 0.5)
      : stages(std::move(of_points)),
        cosines(stages.triangulation, 0),
        stars(stages.triangulation),
        out(stages.triangulation.num_cells(), 1),
        spacings(stages.triangulation, stars),
        energy(stages.triangulation, cosines, stars, spacings, marks, options, out),
        far_reach(stages.triangulation, stars, spacings, marks, options, out) {
    marks.labels = IdVector<CellId, CellLabel>(stages.triangulation.num_cells(), CellLabel::out);
    Random random(seed);
    for (const CellId c : stages.triangulation.finite_cells()) {
      out[c] = random.uniform() < bias ? 1 : 0;
      marks.labels[c] = random.uniform() < 0.5 ? CellLabel::out : CellLabel::in;
      energy.set_preference(c, to_energy(random.uniform() - 0.5));
    }
    for (const VertexId v : stages.triangulation.vertices()) {
      if (random.uniform() < 0.7) energy.want(v);
    }
  }

  // The parts of a star by the plainest means: labels that spread until nothing changes.
  std::size_t parts(VertexId v) const {
    const std::span<const CellId> star = stages.stars.star(v);
    std::map<CellId, CellId> root;
    for (const CellId c : star) root[c] = c;
    for (bool changed = true; changed;) {
      changed = false;
      for (const CellId c : star) {
        for (int i = 0; i < 4; ++i) {
          const CellId d = stages.triangulation.neighbor(c, i);
          if (root.count(d) == 0 || out[c] != out[d] || stages.triangulation.vertex(c, i) == v) {
            continue;
          }
          changed = changed || root[c] != root[d];
          root[c] = root[d] = std::min(root[c], root[d]);
        }
      }
    }
    std::set<CellId> roots;
    for (const auto& [c, r] : root) roots.insert(r);
    return roots.size();
  }

  using Edge = std::pair<VertexId, VertexId>;
  // How many surface facets there are at each edge of the surface.
  std::map<Edge, std::size_t> facets_at_edges() const {
    const Triangulation& t = stages.triangulation;
    std::map<Edge, std::size_t> facets;
    for (const CellId c : t.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (out[c] != 0 || out[t.neighbor(c, i)] == 0) continue;
        Triangle v = t.facet_vertices(facet_id(c, i));
        std::sort(v.begin(), v.end());
        for (const Edge& edge : {Edge(v[0], v[1]), {v[0], v[2]}, {v[1], v[2]}}) ++facets[edge];
      }
    }
    return facets;
  }
  std::ptrdiff_t euler() const {
    std::size_t sides = 0;
    std::set<VertexId> vertices;
    const std::map<Edge, std::size_t> facets = facets_at_edges();
    for (const auto& [edge, count] : facets) {
      sides += count;
      vertices.insert({edge.first, edge.second});
    }
    return static_cast<std::ptrdiff_t>(vertices.size() + sides / 3) -
           static_cast<std::ptrdiff_t>(facets.size());
  }

  // The whole energy, term by term from its definition.
  Energy total() {
    const Triangulation& t = stages.triangulation;
    Energy sum = 0;
    for (const CellId c : t.finite_cells()) {
      if (out[c] != 0) {
        sum += energy.preference(c);
        continue;
      }
      for (int i = 0; i < 4; ++i) {
        if (out[t.neighbor(c, i)] != 0) sum += energy.facet_cost(facet_id(c, i));
      }
    }
    for (const auto& [edge, facets] : facets_at_edges()) {
      sum += to_energy(options.defect_cost) * static_cast<Energy>(facets / 2 - 1);
    }
    for (const VertexId v : t.vertices()) {
      const std::size_t fans = parts(v);
      if (fans == 1) {
        sum += energy.is_wanted(v) ? to_energy(options.unused_cost) : 0;
        continue;
      }
      sum += to_energy(options.defect_cost) * static_cast<Energy>(fans - 2);
      const bool idle = is_idle(t, stages.stars.star(v), out, v, options.idle);
      sum += idle ? to_energy(options.idle_cost) : 0;
    }
    return sum - to_energy(options.handle_cost / 2) * static_cast<Energy>(euler());
  }

  CleanUpOptions options;
  Stages stages;
  BallCosines cosines;
  StarCache stars;
  CellMarks marks;
  IdVector<CellId, std::uint8_t> out;
  SpacingCache spacings;
  CellEnergy energy;
  FarReach far_reach;
};

// All of its triangulation.
inline DoubtfulRegion whole(Labeling& labeling) {
  const Triangulation& t = labeling.stages.triangulation;
  DoubtfulRegion region;
  region.rank = ZeroedArray<VertexId, std::uint32_t>(t.num_vertices());
  std::vector<VertexId> vertices;
  for (const VertexId v : t.vertices()) vertices.push_back(v);
  extend_region(labeling.stars, labeling.spacings, vertices, region);
  return region;
}

}  // namespace cocoon
