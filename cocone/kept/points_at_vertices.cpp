#include "cocone/kept/points_at_vertices.h"

namespace cocoon {

void PointsAtVertices::list(const IdVector<PointId, VertexId>& vertex_of_point, PointId first,
                            std::size_t slots) {
  points_.resize(slots);
  constexpr std::size_t ahead = 16;  // vertices come in any order: asked for early
  for (PointId p = first; p.index() < vertex_of_point.size(); ++p) {
    if (p.index() + ahead < vertex_of_point.size()) {
      __builtin_prefetch(&points_[vertex_of_point[PointId(p.index() + ahead)]], 1);
    }
    points_[vertex_of_point[p]] = p;
  }
}

void PointsAtVertices::forget(std::span<const VertexId> removed, std::size_t slots) {
  for (const VertexId v : removed) points_[v] = PointId();
  points_.resize(slots);  // those of removed vertices may hold new ones
}

void PointsAtVertices::renumber(std::span<const Renumbering::Move> moves, std::size_t slots) {
  if (!is_known()) return;
  for (const auto& [from, to] : moves) points_[to] = points_[from];
  points_.resize(slots);
}

}  // namespace cocoon
