#include "update/replace_points.h"

#include <cstdint>
#include <utility>

#include "geom/arrays/large_pages.h"
#include "geom/arrays/list_edit.h"
#include "geom/box.h"
#include "geom/messages/require_size.h"
#include "geom/search/equal_points.h"
#include "update/model/require_ascending.h"

namespace cocoon {

namespace {

// Merges equal points, keeping the first of each in place; returns the new position of every old
// one.
std::vector<PointId> merge_equal(std::vector<Point>& points,
                                 std::span<const RepeatedPoint> repeated) {
  std::vector<PointId> new_position(points.size());
  auto next = repeated.begin();
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next != repeated.end() && next->point == i) {
      new_position[i] = new_position[next->first];
      ++next;
      continue;
    }
    if (count != i) points[count] = points[i];
    new_position[i] = PointId(count++);
  }
  points.resize(count);
  return new_position;
}

// The points that stay, and then the clouds.
std::vector<Point> gather(Points model, const ListEdit<VertexId>& edit,
                          std::span<const std::vector<Point>> clouds) {
  std::vector<Point> points;
  std::size_t count = edit.size_after(model.size());
  for (const std::vector<Point>& cloud : clouds) count += cloud.size();
  points.reserve(count);
  prefer_large_pages(points);
  for (const KeptRun& run : kept_runs(edit, model.size())) {
    const Points kept = model.subspan(run.from, run.count);
    points.insert(points.end(), kept.data(), kept.data() + kept.size());
  }
  for (const std::vector<Point>& cloud : clouds) {
    points.insert(points.end(), cloud.begin(), cloud.end());
  }
  return points;
}

// Where the vertices of the model that stay and lie in the box came to lie among the points.
std::vector<std::uint32_t> kept_in(const ModelIndex& model, const Box& box,
                                   const ListEdit<VertexId>& edit) {
  std::vector<std::uint32_t> kept;
  auto removed = edit.removed.begin();
  model.for_each_vertex_in(box, [&](VertexId v) {
    while (removed != edit.removed.end() && *removed < v) ++removed;
    if (removed != edit.removed.end() && *removed == v) return;
    kept.push_back(v.value - static_cast<std::uint32_t>(removed - edit.removed.begin()));
  });
  return kept;
}

// Those that are equal to others. The first `kept` are of the model.
std::vector<RepeatedPoint> repeated_among(Points points, std::size_t kept, const ModelIndex& model,
                                          const ListEdit<VertexId>& edit) {
  if (!model.has_distinct_points()) return repeated_points(points);
  return repeated_points(points, kept, kept_in(model, box_of(points.subspan(kept)), edit));
}

// Fills in the updated points: those that stay, then the clouds, equal ones once. Returns where
// each came to lie; nothing if all are different.
std::vector<PointId> add_clouds(const ModelIndex& model, const ListEdit<VertexId>& edit,
                                std::span<const std::vector<Point>> clouds, Replacement& result) {
  result.points = gather(model.mesh().points.span(), edit, clouds);
  const std::vector<RepeatedPoint> repeated =
      repeated_among(result.points, result.vertices.kept, model, edit);
  result.duplicates = repeated.size();
  result.kept_are_distinct = repeated.empty() || repeated.front().point >= result.vertices.kept;
  if (repeated.empty()) return {};
  return merge_equal(result.points, repeated);
}

// Where the model vertices went, and the points of the clouds behind them.
void tell_positions(const ListEdit<VertexId>& edit, std::size_t num_vertices,
                    std::span<const std::vector<Point>> clouds,
                    std::span<const PointId> new_position, Replacement& result) {
  const auto position = [&](std::size_t gathered) {
    return new_position.empty() ? PointId(gathered) : new_position[gathered];
  };
  result.point_of_vertex.reserve(num_vertices);
  prefer_large_pages(result.point_of_vertex.raw());
  result.point_of_vertex.resize(num_vertices);
  for (const KeptRun& run : kept_runs(edit, num_vertices)) {
    for (std::size_t k = 0; k < run.count; ++k) {
      result.point_of_vertex[VertexId(run.from + k)] = position(run.to + k);
    }
  }
  std::size_t next = edit.size_after(num_vertices);
  for (const std::vector<Point>& cloud : clouds) {
    IdVector<PointId, PointId> positions;
    for (std::size_t k = 0; k < cloud.size(); ++k) positions.push_back(position(next++));
    result.point_of_cloud_point.push_back(std::move(positions));
  }
}

Replacement replace_by_all(const ModelIndex& index, ReplacedVertices vertices,
                           std::span<const std::vector<Point>> added) {
  const std::size_t num_vertices = index.mesh().points.size();
  require_ascending("replace_points", "removed vertices", vertices.removed, num_vertices);
  ListEdit<VertexId> edit;
  edit.removed = std::move(vertices.removed);
  Replacement result{std::move(vertices), {}, {}, {}};
  result.vertices.kept = edit.size_after(num_vertices);
  const std::vector<PointId> new_position = add_clouds(index, edit, added, result);
  tell_positions(edit, num_vertices, added, new_position, result);
  result.vertices.removed = std::move(edit.removed);
  return result;
}

std::vector<std::vector<Point>> without(std::span<const std::vector<Point>> clouds,
                                        std::span<const SampleFlags> left_out) {
  std::vector<std::vector<Point>> rest(clouds.size());
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    require_size("replace_points", "flags", left_out[c].size(), clouds[c].size());
    for (const PointId p : left_out[c].ids()) {
      if (left_out[c][p] == 0) rest[c].push_back(clouds[c][p.index()]);
    }
  }
  return rest;
}

// From positions of those that came in to positions of all samples of the cloud.
IdVector<PointId, PointId> with_left_out(const IdVector<PointId, PointId>& positions,
                                         const SampleFlags& left_out) {
  IdVector<PointId, PointId> of_all(left_out.size());
  std::size_t next = 0;
  for (const PointId p : left_out.ids()) {
    if (left_out[p] == 0) of_all[p] = positions[PointId(next++)];
  }
  return of_all;
}

}  // namespace

Replacement replace_points(const ModelIndex& index, ReplacedVertices vertices,
                           std::span<const std::vector<Point>> added,
                           std::span<const SampleFlags> left_out) {
  if (left_out.empty()) return replace_by_all(index, std::move(vertices), added);
  require_size("replace_points", "clouds with flags", left_out.size(), added.size());
  Replacement result = replace_by_all(index, std::move(vertices), without(added, left_out));
  for (std::size_t c = 0; c < added.size(); ++c) {
    IdVector<PointId, PointId>& positions = result.point_of_cloud_point[c];
    result.left_out += added[c].size() - positions.size();
    positions = with_left_out(positions, left_out[c]);
  }
  return result;
}

Replacement replace_points(const ModelIndex& index, const Regions& regions,
                           const RegionChoice& choice, std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds,
                           std::span<const std::vector<Point>> added, const ReplaceOptions& options,
                           const SaidVertices& said) {
  return replace_points(
      index, replaced_vertices(index, regions, choice, rims, clouds, options, said), added);
}

}  // namespace cocoon
