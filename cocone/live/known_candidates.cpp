#include "cocone/live/known_candidates.h"

#include <cstdint>
#include <utility>

namespace cocoon {

KnownCandidates known_candidates(const LiveCandidates& candidates) {
  KnownCandidates found;
  found.normals = candidates.state().normals;
  found.boundary.resize(found.normals.size());
  found.umbrella.resize(found.normals.size());
  for (const VertexId v : found.normals.ids()) {
    found.boundary[v] = candidates.is_boundary(v) ? 1 : 0;
    found.umbrella[v] = candidates.has_umbrella(v) ? 1 : 0;
  }
  candidates.count(found.counters);
  return found;
}

FacetSet candidates_left(const LiveCandidates& candidates) {
  IdVector<CellId, std::uint8_t> left(candidates.state().cell_flags.size());
  for (const CellId c : left.ids()) left[c] = static_cast<std::uint8_t>(candidates.left(c));
  return FacetSet(std::move(left));
}

}  // namespace cocoon
