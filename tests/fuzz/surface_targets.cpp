// Reconstruction, update and the judges of meshes.
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "cocone/boundary_loops.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/self_intersection.h"
#include "geom/surface_distance.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/gallery.h"
#include "update/report/vertex_origins.h"
#include "update/update_model.h"

namespace cocoon::fuzz {

namespace {

constexpr std::size_t most_points = 64;

void require_input_points(const ReconstructResult& result, Points points) {
  require(result.mesh.points.size() + result.unused_points + result.duplicates == points.size(),
          "every point is a vertex, unused, or a duplicate");
  for (const VertexId v : result.mesh.points.ids()) {
    const Point& p = points[result.point_of_vertex[v].index()];
    require(std::memcmp(&p, &result.mesh.points[v], sizeof p) == 0, "vertices are input points");
  }
}

// The part of a sphere about one of its points, its radius stretched, its points moved a little:
// clouds that an update may accept.
std::vector<Point> bent_cap(ByteReader& bytes) {
  const double reach = 1 - bytes.byte() / 128.0;
  const double stretch = 0.9 + bytes.byte() / 1024.0;
  std::vector<Point> cap;
  for (const Point& p : gallery::even_sphere(120)) {
    if (p.z < reach) continue;
    const double height = 1 + (stretch - 1) * (p.z - reach);
    cap.push_back(height * p + (bytes.byte() % 16 / 2048.0) * Vec3{p.y, p.z, p.x});
  }
  return cap;
}

}  // namespace

void reconstruct_target(Bytes bytes) {
  ByteReader reader(bytes);
  ReconstructOptions options;
  const std::uint8_t choice = reader.byte();
  options.mode = choice % 2 == 0 ? Mode::robust : Mode::paper;
  options.keep_cavities = choice / 2 % 2 != 0;
  const bool noisy = choice / 4 % 2 != 0;
  NoiseOptions noise;
  noise.keep_good = choice / 8 % 2 == 0;
  noise.outlier_ratio = choice / 16 % 2 == 0 ? 3 : 1.2;
  noise.spare_good = choice / 96 % 2 == 0;
  noise.max_leak = choice / 32 % 3 / 2.0;
  const std::vector<Point> points = take_points(reader, most_points);
  try {
    const ReconstructResult tight = noisy ? reconstruct_robust(points, noise, options).surface
                                          : reconstruct_tight(points, options);
    require_input_points(tight, points);
    require((tight.status == SurfaceStatus::ok) == !tight.mesh.triangles.empty(), "status tells");
    if (tight.status == SurfaceStatus::ok) {
      const MeshReport report = mesh_check(tight.mesh);
      require(report.balanced, "a tight surface bounds a volume");
      require(self_intersection(tight.mesh).count == 0, "facets of cells do not cross");
    }
    const ReconstructResult open = reconstruct_cocone(points, options);
    require_input_points(open, points);
    if (open.status == SurfaceStatus::ok) boundary_loops(open.mesh);
  } catch (const InputError&) {
  }
}

void update_target(Bytes bytes) {
  ByteReader reader(bytes);
  const std::uint8_t kind = reader.byte();
  static const TriangleMesh ball = reconstruct_tight(gallery::even_sphere(150)).mesh;
  TriangleMesh model = ball;
  if (kind % 4 == 3) {
    std::vector<Point> points = take_points(reader, 16);
    model = take_mesh(reader, std::move(points), 24);
  }
  std::vector<std::vector<Point>> clouds;
  for (int c = 0; c <= kind / 128; ++c) {
    clouds.push_back(kind % 2 == 0 ? bent_cap(reader) : take_points(reader, most_points));
  }
  try {
    const UpdateResult result = update_model(model, clouds);
    require((result.status == UpdateStatus::ok) == result.message.empty(),
            "failures are explained");
    if (result.status != UpdateStatus::ok) return;
    require(mesh_check(result.mesh).balanced, "an updated model bounds a volume");
    const IdVector<VertexId, VertexOrigin> origins = vertex_origins(result);
    for (const VertexId v : origins.ids()) {
      const VertexOrigin& from = origins[v];
      const Point& p = from.input == 0 ? model.points[VertexId(std::size_t{from.index})]
                                       : clouds.at(from.input - 1).at(from.index);
      require(p == result.mesh.points[v], "vertices are input points");
    }
  } catch (const InputError&) {
  }
}

void mesh_target(Bytes bytes) {
  ByteReader reader(bytes);
  std::vector<Point> points = take_points(reader, 2 + reader.byte() % 24);
  const TriangleMesh mesh = take_mesh(reader, std::move(points), 40);
  const MeshReport report = mesh_check(mesh);
  require(report.used_vertices + report.unused_vertices == report.vertices, "vertices add up");
  require(report.triangles == mesh.triangles.size(), "triangles are counted");
  self_intersection(mesh);
  mesh_measure(mesh);
  boundary_loops(mesh);
  TriangleMesh turned = mesh;
  canonicalize_triangles(turned);
  const MeshReport same = mesh_check(turned);
  require(same.edges == report.edges && same.pinched_vertices == report.pinched_vertices &&
              same.components == report.components && same.balanced == report.balanced,
          "order does not change the certificate");
}

}  // namespace cocoon::fuzz
