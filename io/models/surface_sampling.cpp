#include "io/models/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/search/box_tree.h"

namespace cocoon {
namespace {

constexpr double finite_difference_step = 1e-4;  // of the box size: far above rounding

// Reports every so often that `done` of `all` are done, in a part of the sampling.
void report_now_and_then(const Execution& execution, double begin, double end, std::size_t done,
                         std::size_t all) {
  constexpr std::size_t so_often = 4096;
  if (done % so_often != 0 || all == 0) return;
  const double share = static_cast<double>(done) / static_cast<double>(all);
  report_progress(execution, "sample_surface", begin + share * (end - begin));
}

// The neighbors of each point within `reach`: lists in the order of the search.
struct NeighborLists {
  std::vector<std::size_t> begin = {0};
  std::vector<std::uint32_t> neighbors;
};

NeighborLists neighbors_within(const std::vector<Point>& points, double reach,
                               const Execution& execution) {
  const BoxTree tree = tree_of_points(points);
  NeighborLists lists;
  for (std::size_t i = 0; i < points.size(); ++i) {
    report_now_and_then(execution, 0.5, 0.75, i, points.size());
    Box around{points[i], points[i]};
    around.enlarge(reach);
    tree.visit_overlapping(around, [&](std::uint32_t slot) {
      const std::uint32_t j = tree.items()[slot];
      if (j != i && squared_distance(points[i], points[j]) < reach * reach) {
        lists.neighbors.push_back(j);
      }
    });
    lists.begin.push_back(lists.neighbors.size());
    std::sort(lists.neighbors.begin() + static_cast<std::ptrdiff_t>(lists.begin[i]),
              lists.neighbors.end());
  }
  return lists;
}

// w = (1 - d / reach)^8
double crowding(const Point& a, const Point& b, double reach) {
  double weight = 1 - distance(a, b) / reach;
  for (int k = 0; k < 3; ++k) weight *= weight;
  return weight;
}

}  // namespace

std::vector<Point> eliminate_samples(const std::vector<Point>& points, std::size_t count,
                                     double radius, const Execution& execution) {
  const double reach = 2 * radius;
  const NeighborLists lists = neighbors_within(points, reach, execution);
  const auto for_each_neighbor = [&](std::size_t i, const auto& visit) {
    for (std::size_t k = lists.begin[i]; k < lists.begin[i + 1]; ++k) visit(lists.neighbors[k]);
  };
  struct Entry {
    double weight;
    std::size_t point;
    bool operator<(const Entry& other) const {  // the most crowded on top, then the smaller point
      return weight != other.weight ? weight < other.weight : point > other.point;
    }
  };
  std::vector<double> weight(points.size(), 0);
  std::priority_queue<Entry> queue;
  for (std::size_t i = 0; i < points.size(); ++i) {
    report_now_and_then(execution, 0.75, 0.85, i, points.size());
    for_each_neighbor(i,
                      [&](std::size_t j) { weight[i] += crowding(points[i], points[j], reach); });
    queue.push({weight[i], i});
  }
  std::vector<char> removed(points.size(), 0);
  for (std::size_t left = points.size(); left > count;) {
    report_now_and_then(execution, 0.85, 1, points.size() - left, points.size() - count);
    const Entry entry = queue.top();
    queue.pop();
    // An entry is out of date if a neighbor went since; a newer one is in the queue.
    if (removed[entry.point] != 0 || entry.weight != weight[entry.point]) continue;
    removed[entry.point] = 1;
    --left;
    for_each_neighbor(entry.point, [&](std::size_t j) {
      if (removed[j] != 0) return;
      weight[j] -= crowding(points[entry.point], points[j], reach);
      queue.push({weight[j], j});
    });
  }
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (removed[i] == 0) kept.push_back(points[i]);
  }
  return kept;
}

std::vector<Point> sample_surface(const ImplicitSolid& solid, const TriangleMesh& mesh,
                                  const SurfaceRegion& region, std::size_t count, Random& random,
                                  const Execution& execution) {
  constexpr std::size_t candidates_per_sample = 5;
  constexpr std::size_t tries_per_candidate = 100;
  constexpr std::size_t fewest_tries = 10000;  // of few candidates none may fall into the region
  const TrianglesByArea triangles(mesh);
  const std::size_t wanted = candidates_per_sample * count;
  const std::size_t most_tries = std::max(tries_per_candidate * wanted, fewest_tries);
  std::vector<Point> candidates;
  std::size_t tries = 0;
  const double area = triangles.area();
  const double step = finite_difference_step * norm(solid.box.size());
  while (candidates.size() < wanted) {
    report_now_and_then(execution, 0, 0.5, candidates.size(), wanted);
    if (area == 0 || ++tries > most_tries) {
      throw InputError("sampled region holds too little of the surface; give a larger one");
    }
    const TriangleId triangle = triangles.at(random.uniform(0, area));
    const Point p = project_to_surface(solid.value, random_point_in(mesh, triangle, random), step);
    if (region(p)) candidates.push_back(p);
  }
  if (count == 0) return {};
  // The largest radius at which `count` disks of the sampled area can be packed.
  const double sampled_area =
      area * static_cast<double>(candidates.size()) / static_cast<double>(tries);
  const double radius = std::sqrt(sampled_area / (2 * std::sqrt(3.0) * static_cast<double>(count)));
  return eliminate_samples(candidates, count, radius, execution);
}

}  // namespace cocoon
