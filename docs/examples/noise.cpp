// Noisy samples of a ball, and some that belong to nothing: what Tight Cocone alone makes of them,
// and Robust Cocone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "cocone/robust_cocone.h"
#include "geom/mesh_check.h"

// Of the vertices.
double farthest(const cocoon::TriangleMesh& mesh) {
  double distance = 0;
  for (const cocoon::Point& p : mesh.points.raw()) {
    distance = std::max(distance, std::fabs(std::sqrt(squared_norm(p)) - 1));
  }
  return distance;
}

int main() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<cocoon::Point> ball;
  for (int i = 0; i < 4000; ++i) {
    const cocoon::Vec3 v{normal(random), normal(random), normal(random)};
    const double radius = i < 40 ? 1 + std::fabs(normal(random)) : 1 + 0.02 * normal(random);
    ball.push_back((radius / std::sqrt(squared_norm(v))) * v);
  }

  const cocoon::ReconstructResult plain = cocoon::reconstruct_tight(ball);
  const cocoon::RobustResult robust = cocoon::reconstruct_robust(ball);
  const cocoon::MeshReport after = cocoon::mesh_check(robust.surface.mesh);
  std::printf("farthest from the ball: %.2f plain, %.2f robust\n", farthest(plain.mesh),
              farthest(robust.surface.mesh));
  std::printf("left out: %zu outliers, %zu samples inside the layer of noise\n",
              robust.noise.outliers, robust.noise.layer_samples);
  const bool is_clean = after.is_closed_manifold() && after.euler == 2;
  return is_clean && farthest(plain.mesh) > 0.5 && farthest(robust.surface.mesh) < 0.15 ? 0 : 1;
}
