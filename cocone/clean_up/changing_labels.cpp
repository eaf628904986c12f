#include "cocone/clean_up/changing_labels.h"

#include <algorithm>
#include <utility>

namespace cocoon {

namespace {

std::size_t most_clump_cells(const Triangulation& triangulation, const CleanUpOptions& options) {
  const double share = std::min(options.most_clump_share, 1.0) *
                       static_cast<double>(triangulation.num_finite_cells());
  return std::max(options.most_clump_cells, static_cast<std::size_t>(share));
}

}  // namespace

ChangingLabels::ChangingLabels(const Triangulation& of_cells, const CellMarks& marks,
                               const CleanUpOptions& options,
                               const IdVector<VertexId, CellId>* cell_at,
                               const Execution& execution)
    : triangulation(of_cells),
      stars(of_cells, cell_at, execution),
      out(marks.reached),
      cosines(of_cells, options.flat_ratio),
      spacings(of_cells, stars),
      energy(of_cells, cosines, stars, spacings, marks, options, out),
      region(find_doubtful_region(of_cells, marks, stars, spacings,
                                  most_clump_cells(of_cells, options), options.thin_support,
                                  execution)),
      split(of_cells, out),
      far_reach(of_cells, stars, spacings, marks, options, out) {
  for (const CellId c : region.undecided) {
    for (const VertexId v : of_cells.cell(c).vertices) energy.want(v);
  }
}

void ChangingLabels::flip(std::span<const CellId> cells) {
  energy.flip(cells);
  for (const CellId c : cells) touch(c);
}

void ChangingLabels::touch(CellId c) {
  const auto& vertices = triangulation.cell(c).vertices;
  touched_.insert(touched_.end(), vertices.begin(), vertices.end());
}

void ChangingLabels::find_flaws(const Execution& execution) {
  extend_region(stars, spacings, touched_, region);
  touched_.clear();
  flaws_ = find_surface_flaws(triangulation, region, out, execution);
}

const SurfaceFlaws& ChangingLabels::flaws() {
  if (!touched_.empty()) update_flaws();
  return flaws_;
}

std::vector<VertexId> ChangingLabels::flawed_vertices() {
  const SurfaceFlaws& found = flaws();
  std::vector<VertexId> flawed = found.pinched;
  for (const VertexId v : found.unused) {
    if (energy.is_wanted(v)) flawed.push_back(v);
  }
  return flawed;
}

// What was flawless elsewhere still is.
void ChangingLabels::update_flaws() {
  extend_region(stars, spacings, touched_, region);
  std::vector<VertexId> asked = std::move(touched_);
  std::erase_if(asked, [&](VertexId v) { return !region.contains(v); });
  asked.insert(asked.end(), flaws_.unused.begin(), flaws_.unused.end());
  asked.insert(asked.end(), flaws_.pinched.begin(), flaws_.pinched.end());
  std::sort(asked.begin(), asked.end(),
            [&](VertexId a, VertexId b) { return region.rank[a] < region.rank[b]; });
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  touched_.clear();
  flaws_ = {};
  for (const VertexId v : asked) {
    if (energy.is_unused(v)) {
      flaws_.unused.push_back(v);
    } else if (energy.extra_fans(v) > 0) {
      flaws_.pinched.push_back(v);
    }
  }
}

}  // namespace cocoon
