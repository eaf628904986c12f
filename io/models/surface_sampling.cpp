#include "io/models/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <queue>
#include <span>
#include <utility>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/parallel/parallel_list.h"
#include "geom/search/box_tree.h"

namespace cocoon {
namespace {

constexpr const char* stage = "sample_surface";
constexpr std::size_t points_per_chunk = 2048;
constexpr double finite_difference_step = 1e-4;  // of the box size: far above rounding

// w = (1 - d / reach)^8
double crowding(const Point& a, const Point& b, double reach) {
  double weight = 1 - distance(a, b) / reach;
  for (int k = 0; k < 3; ++k) weight *= weight;
  return weight;
}

// The points in an order in which neighbors are close in memory, too: by slots of a tree.
class Crowd {
 public:
  Crowd(const std::vector<Point>& points, double reach, const Execution& execution)
      : tree_(tree_of_points(points)), reach_(reach), points_(points.size()) {
    for (std::size_t slot = 0; slot < points.size(); ++slot) points_[slot] = points[name(slot)];
    find_neighbors(execution);
  }

  std::size_t size() const { return points_.size(); }
  // Its position in the list of the user.
  std::uint32_t name(std::size_t slot) const { return tree_.items()[slot]; }
  // Slots within reach of that of a point, in the order of their names.
  std::span<const std::uint32_t> neighbors(std::size_t slot) const {
    return std::span(neighbors_).subspan(begins_[slot], begins_[slot + 1] - begins_[slot]);
  }
  // How much one crowds the other.
  double weight(std::size_t slot, std::size_t neighbor) const {
    return crowding(points_[slot], points_[neighbor], reach_);
  }
  // By all neighbors. Complexity: O(neighbors).
  double weight(std::size_t slot) const {
    double sum = 0;
    for (const std::uint32_t neighbor : neighbors(slot)) sum += weight(slot, neighbor);
    return sum;
  }

 private:
  void append_neighbors(std::size_t slot, std::vector<std::uint32_t>& list) const {
    Box around{points_[slot], points_[slot]};
    around.enlarge(reach_);
    const std::size_t first = list.size();
    tree_.visit_overlapping(around, [&](std::uint32_t other) {
      if (other != slot && squared_distance(points_[slot], points_[other]) < reach_ * reach_) {
        list.push_back(other);
      }
    });
    std::sort(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
              [&](std::uint32_t a, std::uint32_t b) { return name(a) < name(b); });
  }

  void find_neighbors(const Execution& execution) {
    begins_.assign(size() + 1, 0);
    neighbors_ = parallel_list<std::uint32_t>(
        execution, {stage, 0.5, 0.8}, size(), points_per_chunk,
        [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
          for (std::size_t slot = begin; slot < end; ++slot) {
            const std::size_t before = found.size();
            append_neighbors(slot, found);
            begins_[slot + 1] = found.size() - before;
          }
        });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  }

  BoxTree tree_;
  double reach_;
  std::vector<Point> points_;
  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> neighbors_;
};

// A point that may go next.
struct Candidate {
  double weight;       // as it was when this was listed; it is no larger now
  std::uint32_t name;  // its position in the list of the user
  std::uint32_t slot;

  bool operator<(const Candidate& other) const {  // the most crowded on top, then the first
    return weight != other.weight ? weight < other.weight : name > other.name;
  }
};

}  // namespace

std::vector<Point> eliminate_samples(const std::vector<Point>& points, std::size_t count,
                                     double radius, const Execution& execution) {
  const Crowd crowd(points, 2 * radius, execution);
  std::vector<double> weights(points.size());
  std::vector<Candidate> candidates(points.size());
  parallel_chunks(
      execution, points.size(), points_per_chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
          weights[slot] = crowd.weight(slot);
          candidates[slot] = {weights[slot], crowd.name(slot), static_cast<std::uint32_t>(slot)};
        }
      });
  std::priority_queue<Candidate> queue({}, std::move(candidates));
  std::vector<char> is_removed(points.size(), 0);
  constexpr std::size_t removals_per_report = 4096;
  const std::size_t removals = points.size() - std::min(count, points.size());
  for (std::size_t gone = 0; gone < removals;) {
    Candidate top = queue.top();
    queue.pop();
    const bool is_up_to_date = top.weight == weights[top.slot];
    if (!is_up_to_date) {  // a neighbor went since
      top.weight = weights[top.slot];
      queue.push(top);
      continue;
    }
    is_removed[top.name] = 1;
    if (++gone % removals_per_report == 0) {
      const double done = static_cast<double>(gone) / static_cast<double>(removals);
      report_progress(execution, stage, 0.8 + 0.2 * done);
    }
    for (const std::uint32_t neighbor : crowd.neighbors(top.slot)) {
      weights[neighbor] -= crowd.weight(top.slot, neighbor);
    }
  }
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_removed[i] == 0) kept.push_back(points[i]);
  }
  return kept;
}

std::vector<Point> sample_surface(const ImplicitSolid& solid, const TriangleMesh& mesh,
                                  const SurfaceRegion& region, std::size_t count, Random& random,
                                  const Execution& execution) {
  constexpr std::size_t candidates_per_sample = 5;
  constexpr std::size_t tries_per_candidate = 100;
  constexpr std::size_t most_tries_at_once = std::size_t{1} << 16;
  constexpr std::size_t fewest_tries = 10000;  // of few candidates none may fall into the region
  const TrianglesByArea triangles(mesh);
  const std::size_t wanted = candidates_per_sample * count;
  const std::size_t most_tries = std::max(tries_per_candidate * wanted, fewest_tries);
  std::vector<Point> candidates;
  std::vector<Point> tried;
  std::size_t tries = 0;
  const double area = triangles.area();
  const double step = finite_difference_step * norm(solid.box.size());
  while (candidates.size() < wanted) {
    const double done = static_cast<double>(candidates.size()) / static_cast<double>(wanted);
    report_progress(execution, stage, 0.5 * done);
    // Never more than are missing, so that nothing is drawn that one by one would not be.
    const std::size_t next =
        std::min({wanted - candidates.size(), most_tries - tries, most_tries_at_once});
    if (area == 0 || next == 0) {
      throw InputError("sampled region holds too little of the surface; give a larger one");
    }
    tries += next;
    tried.resize(next);
    for (Point& p : tried) {
      p = random_point_in(mesh, triangles.at(random.uniform(0, area)), random);
    }
    parallel_chunks(execution, next, points_per_chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        tried[i] = project_to_surface(solid.value, tried[i], step);
      }
    });
    std::copy_if(tried.begin(), tried.end(), std::back_inserter(candidates), region);
  }
  if (count == 0) return {};
  // The largest radius at which `count` disks of the sampled area can be packed.
  const double sampled_area =
      area * static_cast<double>(candidates.size()) / static_cast<double>(tries);
  const double radius = std::sqrt(sampled_area / (2 * std::sqrt(3.0) * static_cast<double>(count)));
  return eliminate_samples(candidates, count, radius, execution);
}

}  // namespace cocoon
