#include "ref/cgal_noise_filter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref {
namespace {

using namespace on_cgal;

std::vector<VertexHandle> neighbors_of(const Delaunay& delaunay, VertexHandle v) {
  std::vector<VertexHandle> neighbors;
  delaunay.finite_adjacent_vertices(v, std::back_inserter(neighbors));
  return neighbors;
}

// The root mean square of the shortest edges at each vertex, by its id.
std::vector<double> spacings(const Delaunay& delaunay, std::size_t edges) {
  std::vector<double> spacing(delaunay.number_of_vertices());
  for (const VertexHandle v : delaunay.finite_vertex_handles()) {
    std::vector<double> squares;
    for (const VertexHandle w : neighbors_of(delaunay, v)) {
      squares.push_back(squared_norm(place(w) - place(v)));
    }
    std::sort(squares.begin(), squares.end());
    if (squares.size() > edges) squares.resize(edges);
    double sum = 0;
    for (const double square : squares) sum += square;
    spacing[v->info().id] = std::sqrt(sum / static_cast<double>(squares.size()));
  }
  return spacing;
}

bool is_outlier(const Delaunay& delaunay, const std::vector<double>& spacing, VertexHandle v,
                double ratio) {
  std::vector<double> around;
  for (const VertexHandle w : neighbors_of(delaunay, v)) around.push_back(spacing[w->info().id]);
  std::sort(around.begin(), around.end());
  return spacing[v->info().id] > ratio * around[around.size() / 2];
}

// Notes in the cells which of them the outside reaches.
class Outside {
 public:
  Outside(Delaunay& delaunay, const std::vector<double>& spacing, const NoiseOptions& options)
      : delaunay_(delaunay), spacing_(spacing), options_(options) {}

  void reach() {
    for (const CellHandle c : delaunay_.finite_cell_handles()) {
      c->info().center = to_vec3(delaunay_.dual(c));
    }
    std::vector<CellHandle> reached;
    for (const CellHandle c : delaunay_.all_cell_handles()) {
      if (delaunay_.is_infinite(c)) reached.push_back(c);
      c->info().reached = delaunay_.is_infinite(c);
    }
    while (!reached.empty()) {
      const CellHandle c = reached.back();
      reached.pop_back();
      for (int i = 0; i < 4; ++i) {
        const CellHandle behind = c->neighbor(i);
        if (behind->info().reached || !is_large(behind) || !are_deep({c, i})) continue;
        behind->info().reached = true;
        reached.push_back(behind);
      }
    }
  }

 private:
  static double radius(CellHandle c) { return norm(c->info().center - place(c->vertex(0))); }

  bool is_large(CellHandle c) const {
    for (int i = 0; i < 4; ++i) {
      if (radius(c) <= options_.large_ratio * spacing_[c->vertex(i)->info().id]) return false;
    }
    return true;
  }

  // Do the balls on both sides of the facet intersect deeply? By the law of cosines, in the
  // triangle of the centers and a sample; a half-space has its center far away.
  bool are_deep(const Facet& f) const {
    const Vec3 there = f.first->neighbor(f.second)->info().center;
    const Vec3 sample = place(corner(f, 0));
    if (delaunay_.is_infinite(f.first)) {
      const Vec3 x = there - sample;
      return dot(outward_normal(delaunay_, f.first), x) >= options_.deep_cosine * norm(x);
    }
    const Vec3 here = f.first->info().center;
    const double r1 = norm(here - sample);
    const double r2 = norm(there - sample);
    return squared_norm(here - there) <= r1 * r1 + r2 * r2 - 2 * r1 * r2 * options_.deep_cosine;
  }

  Delaunay& delaunay_;
  const std::vector<double>& spacing_;
  const NoiseOptions& options_;
};

}  // namespace

IdVector<PointId, SampleFate> cgal_noise_filter(Points points, const NoiseOptions& options,
                                                const IdVector<PointId, std::uint8_t>& spared) {
  IdVector<PointId, SampleFate> fates(points.size(), SampleFate::layer);
  for (bool changed = true; changed;) {
    std::vector<Point> left;
    std::vector<PointId> inputs;
    for (const PointId p : fates.ids()) {
      if (fates[p] == SampleFate::outlier) continue;
      left.push_back(points[p.index()]);
      inputs.push_back(p);
    }
    Delaunay delaunay = triangulation_of(left);
    const std::vector<double> spacing = spacings(delaunay, options.neighbors);
    changed = false;
    for (const VertexHandle v : delaunay.finite_vertex_handles()) {
      if (!is_outlier(delaunay, spacing, v, options.outlier_ratio)) continue;
      const PointId p = inputs[v->info().id];
      if (!spared.empty() && spared[p] != 0) continue;
      fates[p] = SampleFate::outlier;
      changed = true;
    }
    if (changed) continue;
    Outside(delaunay, spacing, options).reach();
    for (const CellHandle c : delaunay.all_cell_handles()) {
      for (int i = 0; i < 4 && c->info().reached; ++i) {
        const VertexHandle v = c->vertex(i);
        if (!delaunay.is_infinite(v)) fates[inputs[v->info().id]] = SampleFate::skin;
      }
    }
  }
  return fates;
}

}  // namespace cocoon::ref
