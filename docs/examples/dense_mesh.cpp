// A clamp of 28 triangles is sampled, and the samples become a mesh again. The gap between its jaws
// is narrower than the samples are apart: there more are needed, and the mesh tells what is inside.
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include "cocone/reconstruct.h"
#include "cocone/solid/conforming_samples.h"
#include "cocone/solid/labels_of_solid.h"
#include "geom/mesh/dense_samples.h"
#include "geom/mesh_measure.h"

using cocoon::VertexId;

void add_quad(cocoon::TriangleMesh& mesh, unsigned a, unsigned b, unsigned c, unsigned d) {
  mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  mesh.triangles.push_back({VertexId(a), VertexId(c), VertexId(d)});
}

// A profile like a C, counterclockwise, from z = 0 to 10.
cocoon::TriangleMesh clamp(double gap) {
  const double top = 3 + gap;
  const std::array<std::array<double, 2>, 8> profile = {
      {{0, 0}, {10, 0}, {10, 3}, {3, 3}, {3, top}, {10, top}, {10, top + 3}, {0, top + 3}}};
  constexpr std::array<std::array<unsigned, 4>, 3> quads = {
      {{0, 1, 2, 3}, {0, 3, 4, 7}, {4, 5, 6, 7}}};
  cocoon::TriangleMesh mesh;
  for (const double z : {0.0, 10.0}) {
    for (const auto& [x, y] : profile) mesh.points.push_back({x, y, z});
  }
  for (const auto& [a, b, c, d] : quads) {
    add_quad(mesh, d, c, b, a);
    add_quad(mesh, a + 8, b + 8, c + 8, d + 8);
  }
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned next = (i + 1) % 8;
    add_quad(mesh, i, next, next + 8, i + 8);
  }
  return mesh;
}

int main() {
  const auto mesh = std::make_shared<const cocoon::TriangleMesh>(clamp(0.3));
  constexpr double spacing = 0.8;

  std::vector<cocoon::Point> samples(mesh->points.begin(), mesh->points.end());
  for (const cocoon::Point& p : cocoon::dense_samples(*mesh, {.spacing = spacing})) {
    samples.push_back(p);
  }
  const auto alone = cocoon::reconstruct_tight(samples);

  const cocoon::SolidDistances solid(mesh);
  const auto more = cocoon::conforming_samples(solid, samples, {.spacing = spacing});
  samples.insert(samples.end(), more.added.begin(), more.added.end());

  const auto told =
      cocoon::reconstruct_tight_with_labels(samples, cocoon::labels_told_by(solid, samples));
  const double volume = cocoon::mesh_measure(*mesh).signed_volume;
  const double of_told = cocoon::mesh_measure(told.mesh).signed_volume;
  std::printf("%zu samples, %zu of them where cells crossed the mesh\n", samples.size(),
              more.added.size());
  std::printf(
      "volume %.2f; of the surface of the first samples alone %.2f, with more and the mesh %.2f\n",
      volume, cocoon::mesh_measure(alone.mesh).signed_volume, of_told);
  return of_told > 0.999 * volume && of_told < 1.001 * volume ? 0 : 1;
}
