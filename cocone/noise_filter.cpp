#include "cocone/noise_filter.h"

#include <algorithm>
#include <array>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/circulate.h"
#include "geom/messages/require_number.h"
#include "geom/messages/require_size.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = 4096;  // vertices a chunk

VertexId vertex_at(std::size_t k) { return VertexId(k); }

class Flood {
 public:
  Flood(const Triangulation& triangulation, const Dual& dual,
        const IdVector<VertexId, double>& spacing, const NoiseOptions& options)
      : triangulation_(triangulation), dual_(dual), spacing_(spacing), options_(options) {}

  // Into cells where may_enter(c).
  template <typename MayEnter>
  OuterSkin run(const MayEnter& may_enter) {
    OuterSkin skin;
    skin.touched = VertexSet(triangulation_.num_vertices(), 0);
    skin.balls = IdVector<CellId, BallSize>(triangulation_.num_cells(), BallSize::small);
    for (const CellId c : triangulation_.finite_cells()) {
      if (!is_large(c)) continue;
      skin.balls[c] = BallSize::large;
      ++skin.large_cells;
    }
    std::vector<CellId> outer;
    for (const CellId c : triangulation_.infinite_cells()) outer.push_back(c);
    for (std::size_t next = 0; next < outer.size(); ++next) {
      const CellId c = outer[next];
      for (const VertexId v : triangulation_.cell(c).vertices) {
        if (v != infinite_vertex) skin.touched[v] = 1;
      }
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation_.neighbor(c, i);
        if (skin.balls[behind] != BallSize::large || !may_enter(behind)) continue;
        if (!intersect_deeply(facet_id(c, i), behind)) continue;
        skin.balls[behind] = BallSize::outer;
        outer.push_back(behind);
        ++skin.outer_cells;
      }
    }
    return skin;
  }

 private:
  bool is_large(CellId c) const {
    double largest = 0;
    for (const VertexId v : triangulation_.cell(c).vertices) {
      largest = std::max(largest, spacing_[v]);
    }
    const Point& sample = first_of(triangulation_.cell(c).vertices);
    return distance(center(c), sample) > options_.large_ratio * largest;
  }

  Point center(CellId c) const { return center_of(triangulation_, dual_, c); }

  // Lexicographically, of a cell or a facet. By addresses: no branch depends on which it is.
  template <std::size_t n>
  const Point& first_of(const std::array<VertexId, n>& vertices) const {
    const Point* smallest = &triangulation_.point(vertices[0]);
    for (std::size_t i = 1; i < n; ++i) {
      const Point* other = &triangulation_.point(vertices[i]);
      smallest = *other < *smallest ? other : smallest;
    }
    return *smallest;
  }

  // |c1 - c2|^2 = r1^2 + r2^2 - 2 r1 r2 cos(angle) at every sample that both balls touch; the
  // half-space of an infinite cell has its "center" in the direction of the ray.
  bool intersect_deeply(FacetId f, CellId behind) const {
    const CellId c = cell_of(f);
    const Point& sample = first_of(triangulation_.facet_vertices(f));
    const Vec3 here = triangulation_.is_infinite(c) ? center(c) : unit(center(c) - sample);
    return dot(here, unit(center(behind) - sample)) >= options_.deep_cosine;
  }

  const Triangulation& triangulation_;
  const Dual& dual_;
  const IdVector<VertexId, double>& spacing_;
  const NoiseOptions& options_;
};

void require_stars(const char* stage, const Triangulation& triangulation,
                   const VertexStars& stars) {
  require_size(stage, "stars of vertices", stars.num_vertices(), triangulation.num_vertices());
}

void require_spacing(const char* stage, const Triangulation& triangulation,
                     const IdVector<VertexId, double>& spacing) {
  require_size(stage, "spacings of samples", spacing.size(), triangulation.num_vertices());
}

void require_inputs(const Triangulation& triangulation, const Dual& dual,
                    const IdVector<VertexId, double>& spacing, const NoiseOptions& options) {
  require_options("outer_skin", options);
  require_dual("outer_skin", triangulation, dual);
  require_spacing("outer_skin", triangulation, spacing);
}

}  // namespace

IdVector<VertexId, double> sample_spacing(const Triangulation& triangulation,
                                          const VertexStars& stars, std::size_t neighbors,
                                          const Execution& execution) {
  require_stars("sample_spacing", triangulation, stars);
  require_neighbors("sample_spacing", neighbors);
  IdVector<VertexId, double> spacing(triangulation.num_vertices(), 0);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    SpacingBuffer shortest;
    visit_stars(triangulation, stars, begin, end, vertex_at, [&](std::size_t k) {
      const VertexId v(k);
      spacing[v] = sample_spacing(triangulation, stars.star(v), v, neighbors, shortest);
    });
  };
  parallel_chunks(execution, triangulation.num_vertices(), grain, measure);
  return spacing;
}

VertexSet outlier_samples(const Triangulation& triangulation, const VertexStars& stars,
                          const IdVector<VertexId, double>& spacing, double ratio,
                          const Execution& execution) {
  require_stars("outlier_samples", triangulation, stars);
  require_spacing("outlier_samples", triangulation, spacing);
  require_amounts("outlier_samples", {{"ratio", ratio}});
  VertexSet outlier(triangulation.num_vertices(), 0);
  const auto judge = [&](std::size_t begin, std::size_t end) {
    std::vector<VertexId> around;
    const auto spacing_of = [&](VertexId w) { return spacing[w]; };
    visit_stars(triangulation, stars, begin, end, vertex_at, [&](std::size_t k) {
      const VertexId v(k);
      collect_neighbors(triangulation, stars.star(v), v, around);
      outlier[v] = is_outlying(spacing[v], ratio, around, spacing_of) ? 1 : 0;
    });
  };
  parallel_chunks(execution, triangulation.num_vertices(), grain, judge);
  return outlier;
}

OuterSkin outer_skin(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, double>& spacing, const NoiseOptions& options) {
  require_inputs(triangulation, dual, spacing, options);
  return Flood(triangulation, dual, spacing, options).run([](CellId) { return true; });
}

OuterSkin outer_skin(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, double>& spacing, const NoiseOptions& options,
                     const IdVector<CellId, std::uint8_t>& outside) {
  require_inputs(triangulation, dual, spacing, options);
  require_size("outer_skin", "flags of cells", outside.size(), triangulation.num_cells());
  return Flood(triangulation, dual, spacing, options).run([&](CellId c) {
    return outside[c] != 0;
  });
}

}  // namespace cocoon
