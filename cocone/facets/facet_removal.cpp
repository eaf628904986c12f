#include "cocone/facets/facet_removal.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cocoon {
namespace {

// The halfedge whose link leads to this one.
Halfedge halfedge_before(const LinkedFacets& triangles, Halfedge halfedge) {
  Halfedge before = halfedge;
  while (triangles.links[before] != halfedge) before = triangles.links[before];
  return before;
}

// To a place where no triangle is.
void move_triangle(LinkedFacets& triangles, std::uint32_t from, std::uint32_t to) {
  triangles.facets[to] = triangles.facets[from];
  triangles.mirrors[to] = triangles.mirrors[from];
  triangles.corners[to] = triangles.corners[from];
  triangles.normals[to] = triangles.normals[from];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Halfedge before = halfedge_before(triangles, 3 * from + i);
    triangles.links[3 * to + i] = triangles.links[3 * from + i];
    triangles.links[before == 3 * from + i ? 3 * to + i : before] = 3 * to + i;
  }
}

// Closes the rings at its edges.
RemovedFacets::One take_out(const Triangulation& triangulation, LinkedFacets& triangles,
                            std::uint32_t t) {
  RemovedFacets::One one{
      t, triangles.facets[t], triangles.mirrors[t], triangles.corners[t], triangles.normals[t], {}};
  triangles.set.erase(triangulation, one.facet);
  for (std::uint32_t i = 0; i < 3; ++i) {
    one.before[i] = halfedge_before(triangles, 3 * t + i);
    triangles.links[one.before[i]] = triangles.links[3 * t + i];
  }
  return one;
}

void put_in(const RemovedFacets::One& one, LinkedFacets& triangles) {
  const std::uint32_t t = one.place;
  triangles.facets[t] = one.facet;
  triangles.mirrors[t] = one.mirror;
  triangles.corners[t] = one.corners;
  triangles.normals[t] = one.normal;
  triangles.set.insert(one.facet, one.mirror);
  for (std::uint32_t i = 3; i-- > 0;) {
    const Halfedge before = one.before[i];
    triangles.links[3 * t + i] = before == 3 * t + i ? before : triangles.links[before];
    triangles.links[before] = 3 * t + i;
  }
}

// The halfedges, some of whose triangles have moved to places before `end`.
std::vector<Halfedge> moved(std::vector<Halfedge> halfedges, const std::vector<TriangleMove>& moves,
                            std::size_t end, std::size_t size) {
  std::vector<std::uint32_t> places(size - end);
  for (const auto& [from, to] : moves) places[from - end] = to;
  for (Halfedge& halfedge : halfedges) {
    const std::uint32_t t = triangle_of_halfedge(halfedge);
    if (t >= end) halfedge = 3 * places[t - end] + corner_of_halfedge(halfedge);
  }
  return halfedges;
}

// The steep ones of the edges with one of these halfedges.
std::vector<Halfedge> steep_among(const LinkedFacets& triangles, std::vector<Halfedge> halfedges) {
  for (Halfedge& halfedge : halfedges) halfedge = first_at_edge(triangles.links, halfedge);
  std::sort(halfedges.begin(), halfedges.end());
  halfedges.erase(std::unique(halfedges.begin(), halfedges.end()), halfedges.end());
  std::erase_if(halfedges, [&](Halfedge halfedge) {
    return !is_steep(triangles, halfedge, LinkedFacets::steep_cosine);
  });
  return halfedges;
}

}  // namespace

std::vector<TriangleMove> moves_into_places(const std::vector<std::uint8_t>& removed) {
  std::vector<TriangleMove> moves;
  auto end = static_cast<std::uint32_t>(removed.size());
  for (std::uint32_t hole = 0; hole < end; ++hole) {
    if (removed[hole] == 0) continue;
    do {
      --end;
    } while (removed[end] != 0 && end > hole);
    if (end > hole) moves.push_back({end, hole});
  }
  return moves;
}

LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed, RemovedFacets* gone) {
  const std::size_t size = triangles.size();
  if (gone != nullptr) gone->steep = triangles.steep;
  std::vector<Halfedge> doubtful = std::move(triangles.steep);  // at edges that may be steep
  for (std::uint32_t t = 0; t < size; ++t) {
    if (removed[t] == 0) continue;
    const RemovedFacets::One one = take_out(triangulation, triangles, t);
    doubtful.insert(doubtful.end(), one.before.begin(), one.before.end());
    if (gone != nullptr) gone->triangles.push_back(one);
  }
  std::erase_if(doubtful,
                [&](Halfedge halfedge) { return removed[triangle_of_halfedge(halfedge)] != 0; });
  const std::vector<TriangleMove> moves = moves_into_places(removed);
  for (const auto& [from, to] : moves) move_triangle(triangles, from, to);
  const auto end = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 0));
  triangles.steep = steep_among(triangles, moved(std::move(doubtful), moves, end, size));
  triangles.resize(end);
  return triangles;
}

LinkedFacets put_back(LinkedFacets triangles, RemovedFacets gone) {
  const std::size_t size = triangles.size() + gone.triangles.size();
  std::vector<std::uint8_t> removed(size, 0);
  for (const RemovedFacets::One& one : gone.triangles) removed[one.place] = 1;
  triangles.resize(size);
  const std::vector<TriangleMove> moves = moves_into_places(removed);
  for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
    move_triangle(triangles, move->to, move->from);
  }
  for (auto one = gone.triangles.rbegin(); one != gone.triangles.rend(); ++one) {
    put_in(*one, triangles);
  }
  triangles.steep = std::move(gone.steep);
  return triangles;
}

}  // namespace cocoon
