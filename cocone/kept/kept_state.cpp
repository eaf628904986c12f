#include "cocone/kept/kept_state.h"

#include <cstddef>

#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {
namespace {

// What is known by slot, by number.
template <class IdType, class T>
IdVector<IdType, T> by_number(const IdVector<IdType, T>& by_slot,
                              const IdVector<IdType, IdType>& number, std::size_t count) {
  IdVector<IdType, T> values(count);
  for (const IdType slot : number.ids()) {
    if (!number[slot].is_none()) values[number[slot]] = by_slot[slot];
  }
  return values;
}

}  // namespace

SurfaceState kept_state(const LiveCandidates& candidates, const CertifiedSurface& certified,
                        const KeptStages& kept, const CompactDelaunay& whole) {
  SurfaceState state;
  if (!candidates.exists()) return state;
  const CandidateState& known = candidates.state();
  const std::size_t vertices = whole.triangulation.num_vertices();
  const std::size_t cells = whole.triangulation.num_cells();
  CandidateState& here = state.candidates;
  here.normals = by_number(known.normals, whole.vertex, vertices);
  here.vertex_flags = by_number(known.vertex_flags, whole.vertex, vertices);
  here.samples = by_number(known.samples, whole.vertex, vertices);
  here.steps = by_number(known.steps, whole.vertex, vertices);
  here.cell_flags = by_number(known.cell_flags, whole.cell, cells);
  here.pruned = by_number(known.pruned, whole.cell, cells);
  if (certified.exists()) {
    state.sides = by_number(certified.sides(), whole.cell, cells);
    state.sheets = by_number(certified.sheets(), whole.vertex, vertices);
    return state;
  }
  if (kept.marks.exists()) {
    state.marks.cells = by_number(kept.marks.state().cells, whole.cell, cells);
    state.marks.vertices = by_number(kept.marks.state().vertices, whole.vertex, vertices);
  }
  if (kept.body.exists()) state.out = by_number(kept.body.out(), whole.cell, cells);
  return state;
}

}  // namespace cocoon
