#include "cocone/prune_sharp_edges.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "cocone/facets/facet_removal.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/umbrella.h"

namespace cocoon {
namespace {

class Pruning {
 public:
  // `core`: only edges with a vertex of it are looked at; null: all.
  Pruning(const LinkedFacets& triangles, const VertexSet* core, const VertexSet& umbrella,
          const PruneOptions& options)
      : triangles_(triangles),
        core_(core),
        umbrella_(umbrella),
        options_(options),
        removed_(triangles.size(), 0) {}

  // From the steep edges on. Returns one flag per triangle: pruned.
  std::vector<std::uint8_t> run(std::span<const Halfedge> steep) {
    std::copy_if(steep.begin(), steep.end(), std::back_inserter(work_),
                 [&](Halfedge halfedge) { return may_prune_at(halfedge); });
    while (!work_.empty()) {
      const Halfedge halfedge = work_.back();
      work_.pop_back();
      collect_present(halfedge);
      if (present_.empty() || !is_sharp()) continue;
      for (const Halfedge spoke : present_) {
        if (!is_kept(triangle_of_halfedge(spoke))) remove(triangle_of_halfedge(spoke));
      }
    }
    return std::move(removed_);
  }

 private:
  bool is_looked_at(Halfedge halfedge) const {
    if (core_ == nullptr) return true;
    const auto [a, b] = triangles_.ends(halfedge);
    return (*core_)[a] != 0 || (*core_)[b] != 0;
  }

  // Between two vertices with an umbrella.
  bool may_prune_at(Halfedge halfedge) const {
    const auto [a, b] = triangles_.ends(halfedge);
    return umbrella_[a] != 0 && umbrella_[b] != 0 && is_looked_at(halfedge);
  }

  void collect_present(Halfedge halfedge) {
    present_.clear();
    for_each_at_edge(triangles_.links, halfedge, [&](Halfedge other) {
      if (removed_[triangle_of_halfedge(other)] == 0) present_.push_back(other);
    });
  }

  // Do all present candidates at the edge lie within the limit? One alone always does.
  bool is_sharp() const {
    for (std::size_t i = 0; i < present_.size(); ++i) {
      for (std::size_t k = i + 1; k < present_.size(); ++k) {
        const double cosine = dihedral_cosine(triangles_, present_[i], present_[k]);
        if (cosine <= options_.sharp_cosine) return false;
      }
    }
    return true;
  }

  // Was the triangle, before anything went, one of two that lay nearly flat at some edge?
  bool is_kept(std::uint32_t triangle) const {
    for (Halfedge halfedge = 3 * triangle; halfedge < 3 * triangle + 3; ++halfedge) {
      if (triangles_.has_two_triangles(halfedge) && is_looked_at(halfedge) &&
          dihedral_cosine(triangles_, halfedge, triangles_.links[halfedge]) <=
              options_.keep_cosine) {
        return true;
      }
    }
    return false;
  }

  void remove(std::uint32_t triangle) {
    removed_[triangle] = 1;
    for (Halfedge halfedge = 3 * triangle; halfedge < 3 * triangle + 3; ++halfedge) {
      if (may_prune_at(halfedge)) work_.push_back(halfedge);
    }
  }

  const LinkedFacets& triangles_;
  const VertexSet* core_;
  const VertexSet& umbrella_;
  const PruneOptions& options_;
  std::vector<std::uint8_t> removed_;
  std::vector<Halfedge> work_;
  std::vector<Halfedge> present_;
};

PrunedCandidates prune(const Triangulation& triangulation, LinkedFacets triangles,
                       const PruneOptions& options, const Execution& execution) {
  report_progress(execution, "prune_sharp_edges", 0.5);
  PrunedCandidates result;
  const std::vector<Halfedge> steep = steep_edges(triangles, options.sharp_cosine, execution);
  result.umbrella = vertices_with_umbrella(triangles, steep, triangulation.num_vertices(),
                                           options.sharp_cosine, execution);
  report_progress(execution, "prune_sharp_edges", 0.7);
  const std::vector<std::uint8_t> removed =
      Pruning(triangles, nullptr, result.umbrella, options).run(steep);
  result.candidates = triangles.size();
  result.pruned = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 1));
  result.umbrellas =
      static_cast<std::size_t>(std::count(result.umbrella.begin(), result.umbrella.end(), 1));
  result.left = without(triangulation, std::move(triangles), removed);
  report_progress(execution, "prune_sharp_edges", 1);
  return result;
}

}  // namespace

PrunedCandidates prune_sharp_edges(const Triangulation& triangulation, FacetSet candidates,
                                   const PruneOptions& options, const Execution& execution) {
  require_options("prune_sharp_edges", options);
  require_facets("prune_sharp_edges", triangulation, candidates);
  report_progress(execution, "prune_sharp_edges", 0);
  return prune(triangulation, link_facets(triangulation, std::move(candidates), execution), options,
               execution);
}

PrunedCandidates prune_sharp_edges(const Triangulation& triangulation,
                                   CandidateTriangles candidates, const PruneOptions& options,
                                   const Execution& execution) {
  require_options("prune_sharp_edges", options);
  require_facets("prune_sharp_edges", triangulation, candidates.set);
  report_progress(execution, "prune_sharp_edges", 0);
  return prune(triangulation, link_facets(triangulation, std::move(candidates), execution), options,
               execution);
}

std::vector<std::uint8_t> prune_part(const LinkedFacets& triangles, const VertexSet& core,
                                     const VertexSet& umbrella, const PruneOptions& options) {
  const std::vector<Halfedge> steep = steep_edges(triangles, options.sharp_cosine);
  return Pruning(triangles, &core, umbrella, options).run(steep);
}

}  // namespace cocoon
