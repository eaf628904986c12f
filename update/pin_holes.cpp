#include "update/pin_holes.h"

#include <algorithm>
#include <cstdint>

#include "geom/box.h"
#include "geom/search/box_tree.h"
#include "geom/search/nearest_point.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// The loops of which each point has the model within `reach`.
std::vector<RimLoop> loops_on_model(const ModelIndex& model, const std::vector<RimLoop>& loops,
                                    double reach) {
  std::vector<Point> points;
  for (const RimLoop& loop : loops) {
    points.insert(points.end(), loop.points.begin(), loop.points.end());
  }
  const NearFacets near(model, points, reach);
  const auto is_near = [&](const Point& p) {
    return !near.closest(p, reach * reach).triangle.is_none();
  };
  std::vector<RimLoop> result;
  for (const RimLoop& loop : loops) {
    if (std::all_of(loop.points.begin(), loop.points.end(), is_near)) result.push_back(loop);
  }
  return result;
}

// What a loop looks at: a ball about its middle.
struct View {
  Point middle;
  double reach = 0;

  Box box() const {
    Box box;
    box.include(middle);
    box.enlarge(reach);
    return box;
  }
};

View view_of(const RimLoop& loop) {
  Vec3 sum{};
  for (const Point& p : loop.points) sum = sum + p;
  return {(1 / static_cast<double>(loop.size())) * sum, loop.perimeter};
}

// For each view: is there a vertex of the model in it without a sample within `beyond`?
std::vector<std::uint8_t> model_goes_on(const ModelIndex& model, Points cloud,
                                        const std::vector<View>& views, double beyond) {
  std::vector<std::uint8_t> result(views.size(), 0);
  if (views.empty()) return result;
  std::vector<Box> boxes;
  Box all;
  for (const View& view : views) {
    boxes.push_back(view.box());
    all.include(boxes.back());
  }
  const BoxTree tree(boxes);
  const NearestPointTree samples(cloud);
  const TriangleMesh& mesh = model.mesh();
  for (const VertexId v : mesh.points.ids()) {
    const Point& p = mesh.points[v];
    if (squared_distance(p, all) > 0 || !model.is_used(v)) continue;
    bool asked = false;
    bool is_beyond = false;
    tree.visit_near(p, 0, [&](std::uint32_t slot) {
      const std::uint32_t k = tree.items()[slot];
      const double reach = views[k].reach;
      if (result[k] == 0 && squared_distance(p, views[k].middle) <= reach * reach) {
        if (!asked) is_beyond = !samples.any_near(p, beyond);
        asked = true;
        result[k] = is_beyond ? 1 : 0;
      }
      return 0.0;
    });
  }
  return result;
}

}  // namespace

std::vector<RimLoop> open_pin_holes(const ModelIndex& model, Points cloud, const CloudRim& rim,
                                    const PinHoleOptions& options) {
  require_options("open_pin_holes", options);
  if (rim.pin_hole_loops.empty() || !(options.max_distance > 0)) return {};
  std::vector<RimLoop> loops =
      loops_on_model(model, rim.pin_hole_loops, options.max_distance * rim.median_edge);
  std::vector<View> views;
  views.reserve(loops.size());
  for (const RimLoop& loop : loops) views.push_back(view_of(loop));
  const std::vector<std::uint8_t> goes_on =
      model_goes_on(model, cloud, views, options.min_beyond * rim.median_edge);
  std::vector<RimLoop> opened;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (goes_on[l] != 0) opened.push_back(std::move(loops[l]));
  }
  return opened;
}

}  // namespace cocoon
