#include "cocone/prune_sharp_edges.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/triangle_fans.h"
#include "cocone/umbrella.h"

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 8192;

struct Edge {
  VertexId a;
  VertexId b;
};

struct FirstLook {
  std::vector<std::uint8_t> kept;  // per triangle: marked to stay
  std::vector<Edge> sharp;         // with an umbrella at both ends
};

// Smallest cosine = largest dihedral among the spokes of one edge; above every limit for one spoke.
double flattest_cosine(const TriangleFans& fans, std::span<const Spoke> edge) {
  double flattest = 2;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    for (std::size_t k = i + 1; k < edge.size(); ++k) {
      flattest = std::min(flattest, dihedral_cosine(fans, edge[i], edge[k]));
    }
  }
  return flattest;
}

// Looks at every edge once: which triangles stay, which edges are sharp.
FirstLook look_at_edges(const TriangleFans& fans, const VertexSet& umbrella,
                        const PruneOptions& options, const Execution& execution) {
  const std::size_t count = umbrella.size();
  const std::size_t chunks = (count + vertices_per_chunk - 1) / vertices_per_chunk;
  std::vector<std::vector<std::uint32_t>> kept(chunks);
  std::vector<std::vector<Edge>> sharp(chunks);
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    const std::size_t chunk = begin / vertices_per_chunk;
    std::vector<Spoke> spokes;
    for (VertexId v(begin); v.index() < end; ++v) {
      collect_spokes(fans, v, spokes);
      for_each_edge(spokes, [&](std::span<const Spoke> edge) {
        const VertexId other = edge[0].other;
        if (other < v) return;
        const double flattest = flattest_cosine(fans, edge);
        if (edge.size() == 2 && flattest <= options.keep_cosine) {
          kept[chunk].insert(kept[chunk].end(), {edge[0].triangle, edge[1].triangle});
        }
        if (flattest > options.sharp_cosine && umbrella[v] != 0 && umbrella[other] != 0) {
          sharp[chunk].push_back({v, other});
        }
      });
    }
  });
  FirstLook look{std::vector<std::uint8_t>(fans.size(), 0), {}};
  for (const auto& list : kept) {
    for (const std::uint32_t t : list) look.kept[t] = 1;
  }
  for (const auto& list : sharp) look.sharp.insert(look.sharp.end(), list.begin(), list.end());
  return look;
}

class Pruning {
 public:
  Pruning(const TriangleFans& fans, const VertexSet& umbrella, FirstLook look,
          const PruneOptions& options)
      : fans_(fans),
        umbrella_(umbrella),
        options_(options),
        kept_(std::move(look.kept)),
        work_(std::move(look.sharp)),
        present_(fans.size(), 1) {}

  // Returns one flag per triangle: still there.
  std::vector<std::uint8_t> run() {
    while (!work_.empty()) {
      const Edge edge = work_.back();
      work_.pop_back();
      collect_present(edge);
      if (spokes_.empty() || flattest_cosine(fans_, spokes_) <= options_.sharp_cosine) continue;
      for (const Spoke& spoke : spokes_) {
        if (kept_[spoke.triangle] == 0) remove(spoke.triangle);
      }
    }
    return std::move(present_);
  }

 private:
  void collect_present(const Edge& edge) {
    spokes_.clear();
    for (const std::uint32_t t : fans_.around(edge.a)) {
      if (present_[t] == 0) continue;
      const std::array<VertexId, 3>& corners = fans_.corners[t];
      const std::size_t i = corners[0] == edge.a ? 0 : corners[1] == edge.a ? 1 : 2;
      if (corners[(i + 1) % 3] == edge.b) spokes_.push_back({edge.b, t, 0, 1.0});
      if (corners[(i + 2) % 3] == edge.b) spokes_.push_back({edge.b, t, 0, -1.0});
    }
  }

  void remove(std::uint32_t triangle) {
    present_[triangle] = 0;
    const std::array<VertexId, 3>& corners = fans_.corners[triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge{corners[i], corners[(i + 1) % 3]};
      if (umbrella_[edge.a] != 0 && umbrella_[edge.b] != 0) work_.push_back(edge);
    }
  }

  const TriangleFans& fans_;
  const VertexSet& umbrella_;
  const PruneOptions& options_;
  std::vector<std::uint8_t> kept_;
  std::vector<Edge> work_;
  std::vector<std::uint8_t> present_;
  std::vector<Spoke> spokes_;
};

}  // namespace

PrunedCandidates prune_sharp_edges(const Triangulation& triangulation, const FacetSet& candidates,
                                   const PruneOptions& options, const Execution& execution) {
  report_progress(execution, "prune_sharp_edges", 0);
  const TriangleFans fans = triangle_fans(triangulation, candidates, execution);
  report_progress(execution, "prune_sharp_edges", 0.3);
  PrunedCandidates result;
  result.umbrella = vertices_with_umbrella(fans, options.sharp_cosine, execution);
  report_progress(execution, "prune_sharp_edges", 0.6);
  FirstLook look = look_at_edges(fans, result.umbrella, options, execution);
  const std::vector<std::uint8_t> present =
      Pruning(fans, result.umbrella, std::move(look), options).run();
  result.facets = candidates;
  for (std::size_t t = 0; t < fans.size(); ++t) {
    if (present[t] == 0) result.facets.erase(triangulation, fans.facets[t]);
  }
  result.candidates = fans.size();
  result.pruned = static_cast<std::size_t>(std::count(present.begin(), present.end(), 0));
  result.umbrellas =
      static_cast<std::size_t>(std::count(result.umbrella.begin(), result.umbrella.end(), 1));
  report_progress(execution, "prune_sharp_edges", 1);
  return result;
}

}  // namespace cocoon
