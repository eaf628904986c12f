#include "geom/mesh/repeated_triangles.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/id_vector.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {

namespace {

// A triangle by the places of its corners, of which the smallest is told by where this is listed.
struct PlacedTriangle {
  VertexId middle;
  VertexId largest;
  TriangleId triangle;

  friend auto operator<=>(const PlacedTriangle&, const PlacedTriangle&) = default;
};

bool have_same_corners(const PlacedTriangle& a, const PlacedTriangle& b) {
  return a.middle == b.middle && a.largest == b.largest;
}

// An edge of a triangle, by vertices, not by places: sheets that share no vertices do not hang
// together.
struct EdgeOfTriangle {
  VertexId from;
  VertexId to;                            // larger
  std::optional<std::uint32_t> repeated;  // which of the repeated triangles; none: it is not
};

bool is_same_edge(const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
  return a.from == b.from && a.to == b.to;
}

// Of each vertex the first one at its place.
IdVector<VertexId, VertexId> places_of(std::size_t vertices,
                                       std::span<const RepeatedPoint> repeated) {
  IdVector<VertexId, VertexId> place_of(vertices);
  for (const VertexId v : place_of.ids()) place_of[v] = v;
  for (const RepeatedPoint& r : repeated) place_of[VertexId(r.point)] = VertexId(r.first);
  return place_of;
}

// Triangles with the corners of an earlier one, in increasing order.
std::vector<TriangleId> repeated_triangles(const TriangleMesh& mesh,
                                           std::span<const RepeatedPoint> repeated,
                                           const Execution& execution) {
  const IdVector<VertexId, VertexId> place_of =
      repeated.empty() ? IdVector<VertexId, VertexId>() : places_of(mesh.points.size(), repeated);
  OverwriteVector<PlacedTriangle> listed;
  const std::vector<std::uint32_t> begins = sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), execution,
      [&](std::size_t count) { listed.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          Triangle corners = mesh.triangles[t];
          if (!place_of.empty()) {
            for (VertexId& corner : corners) corner = place_of[corner];
          }
          std::sort(corners.begin(), corners.end());
          put(corners[0], [&](std::uint32_t at) { listed[at] = {corners[1], corners[2], t}; });
        }
      });
  constexpr std::size_t vertices_per_chunk = 4096;
  std::vector<TriangleId> result = parallel_list<TriangleId>(
      execution, mesh.points.size(), vertices_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<TriangleId>& found) {
        for (std::size_t v = begin; v < end; ++v) {
          const auto first = listed.begin() + begins[v];
          const auto last = listed.begin() + begins[v + 1];
          std::sort(first, last);
          for (auto t = first; t != last; ++t) {
            if (t != first && have_same_corners(*(t - 1), *t)) found.push_back(t->triangle);
          }
        }
      });
  std::sort(result.begin(), result.end());
  return result;
}

// All edges between vertices of `repeated`, grouped.
std::vector<EdgeOfTriangle> edges_near(const TriangleMesh& mesh,
                                       const std::vector<TriangleId>& repeated) {
  IdVector<VertexId, std::uint8_t> is_near(mesh.points.size());
  for (const TriangleId t : repeated) {
    for (const VertexId corner : mesh.triangles[t]) is_near[corner] = 1;
  }
  std::vector<EdgeOfTriangle> edges;
  std::uint32_t next = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& corners = mesh.triangles[t];
    std::optional<std::uint32_t> of;
    if (next < repeated.size() && repeated[next] == t) of = next++;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = std::minmax(corners[i], corners[(i + 1) % 3]);
      if (is_near[from] != 0 && is_near[to] != 0) edges.push_back({from, to, of});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return edges;
}

// Which of the repeated triangles go. Those of one set hang together by edges.
std::vector<std::uint8_t> superfluous(const std::vector<EdgeOfTriangle>& edges,
                                      std::size_t num_repeated) {
  DisjointSets sets(num_repeated);
  std::vector<std::int64_t> more_odd(num_repeated);  // at edges, by their first ones
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if_not(
        begin, edges.end(), [&](const EdgeOfTriangle& edge) { return is_same_edge(*begin, edge); });
    std::size_t going = 0;
    std::uint32_t first = 0;
    for (auto edge = begin; edge != end; ++edge) {
      if (!edge->repeated) continue;
      if (going++ == 0) first = *edge->repeated;
      sets.join(first, *edge->repeated);
    }
    if (going % 2 == 1) more_odd[first] += (end - begin) % 2 == 0 ? 1 : -1;
    begin = end;
  }
  std::vector<std::int64_t> of_set(num_repeated);
  for (std::uint32_t t = 0; t < num_repeated; ++t) of_set[sets.root(t)] += more_odd[t];
  std::vector<std::uint8_t> result(num_repeated);
  for (std::uint32_t t = 0; t < num_repeated; ++t) result[t] = of_set[sets.root(t)] <= 0 ? 1 : 0;
  return result;
}

}  // namespace

std::size_t leave_out_repeated_triangles(TriangleMesh& mesh,
                                         std::span<const RepeatedPoint> repeated,
                                         const Execution& execution) {
  const std::vector<TriangleId> found = repeated_triangles(mesh, repeated, execution);
  if (found.empty()) return 0;
  const std::vector<std::uint8_t> goes = superfluous(edges_near(mesh, found), found.size());
  std::size_t next = 0;
  TriangleId kept(0U);
  for (const TriangleId t : mesh.triangles.ids()) {
    const bool is_found = next < found.size() && found[next] == t;
    if (is_found && goes[next++] != 0) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    ++kept;
  }
  const std::size_t gone = mesh.triangles.size() - kept.index();
  mesh.triangles.resize(kept.index());
  return gone;
}

}  // namespace cocoon
