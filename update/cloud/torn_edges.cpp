#include "update/cloud/torn_edges.h"

#include <cstdint>
#include <vector>

#include "update/cloud/rim_edges.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

bool is_torn_all_along(const RimLoop& loop, std::size_t torn, const TornEdgeOptions& options) {
  const std::size_t inner = loop.inner_edges();
  const auto size = static_cast<double>(loop.size());
  const auto others = static_cast<double>(loop.size() - inner);
  return static_cast<double>(torn) > options.min_torn_share * others &&
         static_cast<double>(torn + inner) > options.max_seam_share * size;
}

// Leaves out the edges of loops that are no seams even if all of their edges with a sample beyond
// them are torn: that is most loops, and saves the heights there.
void leave_out_rims(const CloudRim& rim, const std::vector<RimEdge>& edges,
                    const TornEdgeOptions& options, std::vector<SampleBeyond>& beyond) {
  std::vector<std::size_t> most(rim.loops.size(), 0);
  for (std::size_t k = 0; k < beyond.size(); ++k) {  // in the order of edges
    if (k == 0 || beyond[k - 1].edge != beyond[k].edge) ++most[edges[beyond[k].edge].loop];
  }
  std::vector<std::uint8_t> may_be_seam(rim.loops.size());
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    may_be_seam[l] = is_torn_all_along(rim.loops[l], most[l], options) ? 1 : 0;
  }
  std::erase_if(beyond,
                [&](const SampleBeyond& pair) { return may_be_seam[edges[pair.edge].loop] == 0; });
}

// How many edges of each loop are torn, as far as it can be a seam.
std::vector<std::size_t> count_torn(const ModelIndex& model,
                                    std::span<const std::vector<Point>> clouds, const CloudRim& rim,
                                    const TornEdgeOptions& options) {
  const double reach = options.reach * rim.spacing;
  const std::vector<RimEdge> edges = ends_of_cloud(rim);
  const std::vector<Point> samples = samples_near(clouds, edges, reach);
  std::vector<SampleBeyond> beyond =
      samples_beyond(edges, samples, reach, options.min_outward * rim.spacing);
  leave_out_rims(rim, edges, options, beyond);
  std::vector<std::size_t> torn(rim.loops.size(), 0);
  const std::vector<std::uint8_t> is_torn =
      edges_with_steps(model, edges, samples, beyond, {options.min_step * rim.spacing, 2 * reach});
  for (std::size_t k = 0; k < edges.size(); ++k) torn[edges[k].loop] += is_torn[k];
  return torn;
}

}  // namespace

void mark_torn_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const TornEdgeOptions& options) {
  require_options("mark_torn_edges", options);
  if (rim.loops.size() < 2) return;  // a rim has to be left
  const std::vector<std::size_t> torn = count_torn(model, clouds, rim, options);
  std::vector<std::size_t> seams;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (is_torn_all_along(rim.loops[l], torn[l], options)) seams.push_back(l);
  }
  if (seams.size() == rim.loops.size()) return;
  for (const std::size_t l : seams) {
    rim.loops[l].is_seam = true;
    rim.loops[l].inner.assign(rim.loops[l].size(), 1);
    rim.torn_edges += torn[l];
    rim.seam_edges += torn[l];
  }
}

}  // namespace cocoon
