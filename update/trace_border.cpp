#include "update/trace_border.h"

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geom/closest_on_segment.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

// Rounding of a crossing at the very end of the segment, relative to its length.
constexpr double end_slack = 1e-6;

// A way over the model between two located rim points.
struct Span {
  TriangleId from;
  TriangleId to;
  Point from_foot;
  Point to_foot;
};

// One straight walk: the cutting plane, and the direction along the segment.
struct CuttingPlane {
  Point origin;
  Vec3 normal;
  Vec3 along;  // unit

  // A corner on the plane counts as above: no walk meets a vertex.
  bool above(const Point& p) const { return dot(p - origin, normal) >= 0; }
  // How far along the segment the plane crosses the edge between a and b.
  double crossing(Point a, Point b) const {
    if (b < a) std::swap(a, b);  // the same bits from either side
    const double da = dot(a - origin, normal);
    const double db = dot(b - origin, normal);
    const double share = da == db ? 0 : da / (da - db);
    return dot(a + share * (b - a) - origin, along);
  }
};

struct Exit {
  int edge = -1;        // opposite corner i; -1 if the plane misses the facet
  double crossing = 0;  // how far along the segment
};

// The edge by which a walk leaves `t`: crossed by the plane, not the one it came in by, and of two
// the one farther along; of two at a corner that with the larger opposite one.
Exit exit_of(const TriangleMesh& mesh, const CuttingPlane& plane, TriangleId t, int entry) {
  const Triangle& corners = mesh.triangles[t];
  const auto opposite = [&](int i) { return mesh.points[corners[static_cast<std::size_t>(i)]]; };
  Exit best;
  for (int i = 0; i < 3; ++i) {
    if (i == entry) continue;
    const Point& a = mesh.points[corners[static_cast<std::size_t>((i + 1) % 3)]];
    const Point& b = mesh.points[corners[static_cast<std::size_t>((i + 2) % 3)]];
    if (plane.above(a) == plane.above(b)) continue;
    const double crossing = plane.crossing(a, b);
    if (best.edge >= 0 &&
        std::tuple(crossing, opposite(i)) <= std::tuple(best.crossing, opposite(best.edge))) {
      continue;
    }
    best = {i, crossing};
  }
  return best;
}

int edge_towards(const TriangleNeighbors& neighbors, TriangleId t, TriangleId neighbor) {
  for (int i = 0; i < 3; ++i) {
    if (neighbors[t][static_cast<std::size_t>(i)] == neighbor) return i;
  }
  return -1;
}

// Walks in the plane from one facet to the other; false if it does not arrive.
bool walk(const ModelIndex& model, const Span& span, std::size_t max_facets,
          std::vector<TriangleId>& path) {
  path.assign(1, span.from);
  if (span.from == span.to) return true;
  const Vec3 segment = span.to_foot - span.from_foot;
  const Vec3 mean_normal = model.normal(span.from) + model.normal(span.to);
  const CuttingPlane plane{span.from_foot, cross(segment, mean_normal), unit(segment)};
  const double end = norm(segment) * (1 + end_slack);

  int entry = -1;
  for (TriangleId t = span.from; path.size() < max_facets;) {
    const Exit exit = exit_of(model.mesh(), plane, t, entry);
    // The last facet holds the end of the segment: who leaves another one beyond it has missed.
    if (exit.edge < 0 || exit.crossing > end) return false;
    const TriangleId next = model.neighbors()[t][static_cast<std::size_t>(exit.edge)];
    if (next.is_none()) return false;
    path.push_back(next);
    if (next == span.to) return true;
    entry = edge_towards(model.neighbors(), next, t);
    t = next;
  }
  return false;
}

// Shortest path over neighboring facets (Dijkstra); false if there is none within the limit.
bool search(const ModelIndex& model, const Span& span, std::size_t max_facets,
            std::vector<TriangleId>& path) {
  struct Reached {
    double cost;
    TriangleId from;
    bool done = false;
  };
  struct Entry {
    double cost;
    TriangleId facet;
  };
  const auto later = [&](const Entry& a, const Entry& b) {
    if (a.cost != b.cost) return a.cost > b.cost;
    return sorted_corners(corners_of(model.mesh(), a.facet)) >
           sorted_corners(corners_of(model.mesh(), b.facet));
  };
  std::unordered_map<TriangleId, Reached> reached;
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  reached[span.from] = {0, {}, false};
  queue.push({0, span.from});
  for (std::size_t looked_at = 0; !queue.empty() && looked_at < max_facets;) {
    const auto [cost, t] = queue.top();
    queue.pop();
    if (std::exchange(reached[t].done, true)) continue;
    ++looked_at;
    if (t == span.to) break;
    const Point center = model.centroid(t);
    for (const TriangleId next : model.neighbors()[t]) {
      if (next.is_none()) continue;
      const Point next_center = model.centroid(next);
      const double next_cost =
          cost + distance(center, next_center) +
          2 * distance(next_center, closest_on_segment(next_center, span.from_foot, span.to_foot));
      const auto [entry, is_new] = reached.try_emplace(next, Reached{next_cost, t});
      if (!is_new && (entry->second.done || entry->second.cost <= next_cost)) continue;
      entry->second = {next_cost, t};
      queue.push({next_cost, next});
    }
  }
  const auto target = reached.find(span.to);
  if (target == reached.end() || !target->second.done) return false;
  path.clear();
  for (TriangleId t = span.to; !t.is_none(); t = reached.at(t).from) path.push_back(t);
  std::reverse(path.begin(), path.end());
  return true;
}

// Fills `path` one way or the other and counts which.
bool find_way(const ModelIndex& model, const Span& span, const TraceOptions& options,
              BorderFigures& counts, std::vector<TriangleId>& path) {
  if (walk(model, span, options.max_walk_facets, path)) {
    ++counts.walks;
    return true;
  }
  if (search(model, span, options.max_search_facets, path)) {
    ++counts.searches;
    return true;
  }
  ++counts.breaks;
  path.clear();
  return false;
}

LoopBorder trace_loop(const ModelIndex& model, const LoopOverlap& overlap,
                      const TraceOptions& options, BorderFigures& counts) {
  const std::size_t n = overlap.facets.size();
  auto matched = [&](std::size_t i) { return !overlap.facets[i % n].is_none(); };
  LoopBorder band;
  std::vector<TriangleId> path;
  for (std::size_t i = 0; i < n; ++i) {
    band.begin.push_back(static_cast<std::uint32_t>(band.facets.size()));
    if (!matched(i)) continue;
    std::size_t j = i + 1;
    while (!matched(j)) ++j;            // ends at i + n at the latest
    if (j % n == i && n > 1) continue;  // the only matched point: no way to go
    const Span span{overlap.facets[i], overlap.facets[j % n], overlap.feet[i], overlap.feet[j % n]};
    band.closed &= find_way(model, span, options, counts, path);
    std::vector<TriangleId>& target = j == i + 1 ? band.facets : band.bridges;
    target.insert(target.end(), path.begin(), path.end());
  }
  band.begin.push_back(static_cast<std::uint32_t>(band.facets.size()));
  return band;
}

}  // namespace

Border trace_border(const ModelIndex& model, const CloudRim& rim, const Overlap& overlap,
                    const TraceOptions& options, const Execution& execution) {
  require_size("trace_border", "loops of the overlap", overlap.loops.size(), rim.loops.size());
  report_progress(execution, "trace_border", 0);
  Border border;
  border.facets = TriangleSet(model.mesh().triangles.size(), 0);
  border.loops.resize(rim.loops.size());
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (overlap.loops[l].match != LoopMatch::on_model) continue;
    LoopBorder& band = border.loops[l];
    band = trace_loop(model, overlap.loops[l], options, border.figures);
    band.for_each_facet([&](TriangleId t) {
      if (std::exchange(border.facets[t], 1) == 0) ++border.figures.facets;
    });
    report_progress(execution, "trace_border",
                    static_cast<double>(l + 1) / static_cast<double>(rim.loops.size()));
  }
  report_progress(execution, "trace_border", 1);
  return border;
}

}  // namespace cocoon
