#include "update/stray_samples.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/outlier_rounds.h"
#include "cocone/sample_spacing.h"
#include "delaunay/vertex_stars.h"
#include "geom/disjoint_sets.h"
#include "geom/working_scale.h"

namespace cocoon {

namespace {

// The points still in, and what becomes of them.
class Strays {
 public:
  Strays(Points cloud, const StrayOptions& options, const DelaunayOptions& delaunay_options,
         const Execution& execution)
      : options_(options), delaunay_options_(delaunay_options), execution_(execution) {
    const double scale = working_scale(cloud);
    points_.reserve(cloud.size());
    for (const Point& p : cloud) points_.push_back(scale * p);
    for (std::size_t i = 0; i < cloud.size(); ++i) inputs_.push_back(PointId(i));
    result_.kept = IdVector<PointId, std::uint8_t>(cloud.size(), 1);
  }

  StraySamples run() {
    // Small parts first: beside a dense one a good sample would stand alone. And again after the
    // outliers, by which some may hang together with the rest.
    triangulate();
    if (leave_out_small_parts()) triangulate();
    if (leave_out_outliers()) {
      triangulate();
      leave_out_small_parts();
    }
    return std::move(result_);
  }

 private:
  void triangulate() {
    triangulation_ = delaunay(points_, delaunay_options_, execution_).triangulation;
    stars_ = vertex_stars(triangulation_);
    spacing_ = sample_spacing(triangulation_, stars_, options_.neighbors, execution_);
  }

  void leave_out(const VertexSet& out, const IdVector<PointId, VertexId>& vertex_of_point) {
    std::vector<Point> points;
    std::vector<PointId> inputs;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (out[vertex_of_point[PointId(i)]] != 0) {
        result_.kept[inputs_[i]] = 0;
      } else {
        points.push_back(points_[i]);
        inputs.push_back(inputs_[i]);
      }
    }
    points_ = std::move(points);
    inputs_ = std::move(inputs);
  }

  // Whether there were any; then there is no triangulation any more.
  bool leave_out_outliers() {
    VertexSet first =
        outlier_samples(triangulation_, stars_, spacing_, options_.outlier_ratio, execution_);
    if (std::find(first.begin(), first.end(), 1) == first.end()) return false;
    const IdVector<PointId, VertexId> vertex_of_point = triangulation_.vertex_of_point();
    NoiseOptions noise;
    noise.neighbors = options_.neighbors;
    noise.outlier_ratio = options_.outlier_ratio;
    const OutlierRounds outliers = outlier_rounds(std::move(triangulation_), std::move(spacing_),
                                                  std::move(first), noise, execution_);
    result_.outliers = outliers.count;
    leave_out(outliers.out, vertex_of_point);
    return true;
  }

  // Whether there were any; then the triangulation is still that with them.
  bool leave_out_small_parts() {
    const std::vector<std::uint32_t> part = parts();
    std::vector<std::size_t> size(part.size(), 0);
    for (const VertexId v : triangulation_.vertices()) ++size[part[v.index()]];
    const std::size_t largest = *std::max_element(size.begin(), size.end());
    const std::size_t enough = std::min(options_.min_part, largest);
    VertexSet out(triangulation_.num_vertices(), 0);
    for (const VertexId v : triangulation_.vertices()) {
      if (size[part[v.index()]] >= enough) continue;
      out[v] = 1;
      ++result_.in_small_parts;
      result_.small_parts += part[v.index()] == v.index() ? 1U : 0U;  // its root
    }
    const bool found = std::find(out.begin(), out.end(), 1) != out.end();
    if (found) leave_out(out, triangulation_.vertex_of_point());
    return found;
  }

  // The part of each vertex among those that hang together: the smallest vertex of it.
  std::vector<std::uint32_t> parts() {
    DisjointSets sets(triangulation_.num_vertices());
    std::vector<VertexId> around;
    for (const VertexId v : triangulation_.vertices()) {
      collect_neighbors(triangulation_, stars_.star(v), v, around);
      for (const VertexId w : around) {
        if (w < v) continue;
        const double reach = options_.link_ratio * std::min(spacing_[v], spacing_[w]);
        if (distance(triangulation_.point(v), triangulation_.point(w)) > reach) continue;
        sets.join(v.value, w.value);
      }
    }
    std::vector<std::uint32_t> part(triangulation_.num_vertices());
    for (const VertexId v : triangulation_.vertices()) part[v.index()] = sets.root(v.value);
    return part;
  }

  const StrayOptions& options_;
  const DelaunayOptions& delaunay_options_;
  const Execution& execution_;
  std::vector<Point> points_;
  std::vector<PointId> inputs_;
  Triangulation triangulation_;
  VertexStars stars_;
  IdVector<VertexId, double> spacing_;
  StraySamples result_;
};

}  // namespace

StraySamples stray_samples(Points cloud, const StrayOptions& options,
                           const DelaunayOptions& delaunay_options, const Execution& execution) {
  report_progress(execution, "noise", 0);
  PrefixedProgress nested("noise", execution.progress);
  StraySamples samples =
      Strays(cloud, options, delaunay_options,
             {execution.threads, execution.progress == nullptr ? nullptr : &nested})
          .run();
  report_progress(execution, "noise", 1);
  return samples;
}

}  // namespace cocoon
