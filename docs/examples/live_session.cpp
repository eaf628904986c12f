// A session keeps a model and its triangulation from one update to the next: each costs what it
// changes, can be taken back, and gives the same bits as starting over.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "update/update_model.h"
#include "update/update_session.h"

// Evenly spread over the unit sphere, up to `reach` radians from the pole on the side of `pole`;
// within 0.6 radians moved outward to a bump of height `bump`.
std::vector<cocoon::Point> cap(int n, double reach, double bump, double pole) {
  std::vector<cocoon::Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2.0 * i + 1) / n;
    const double latitude = std::acos(z);
    if (latitude > reach) break;
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - z * z);
    const double rise = std::min(1.0, latitude / 0.6) * std::numbers::pi;
    const double height = 1 + bump * (std::cos(rise) + 1) / 2;
    points.push_back(height * cocoon::Vec3{r * std::cos(angle), r * std::sin(angle), pole * z});
  }
  return points;
}

int main() {
  const cocoon::TriangleMesh model = cocoon::reconstruct_tight(cap(4000, 4, 0, 1)).mesh;
  const std::vector<std::vector<cocoon::Point>> north = {cap(6000, 0.8, 0.3, 1)};
  const std::vector<std::vector<cocoon::Point>> south = {cap(6000, 0.8, -0.2, -1)};

  cocoon::UpdateSession session(model);
  session.apply(north);
  const cocoon::SessionUpdate update = session.apply(south);
  std::printf("%zu of %zu triangles are new, %zu have gone\n", update.change.added.size(),
              session.model().triangles.size(), update.change.removed.size());

  // The same two updates, each from scratch.
  const cocoon::TriangleMesh once = cocoon::update_model(model, north).mesh;
  const bool same = session.model() == cocoon::update_model(once, south).mesh;
  session.undo();
  const bool undone = session.model() == once;
  std::printf("as from scratch: %d; after the undo: %d\n", same ? 1 : 0, undone ? 1 : 0);
  return same && undone ? 0 : 1;
}
