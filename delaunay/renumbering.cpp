#include "delaunay/renumbering.h"

#include "geom/id_vector.h"

namespace cocoon {

void rename_vertices(std::span<const Renumbering::Move> moves, std::size_t slots,
                     std::span<VertexId> vertices) {
  if (moves.empty()) return;
  IdVector<VertexId, VertexId> now(slots);
  for (const auto& [from, to] : moves) now[from] = to;
  for (VertexId& v : vertices) {
    if (!now[v].is_none()) v = now[v];
  }
}

}  // namespace cocoon
