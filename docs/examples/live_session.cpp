// A session keeps a model and its triangulation from one update to the next: each costs what it
// changes, can be taken back, and gives the same bits as starting over.
#include <cstdio>
#include <vector>

#include "cocone/reconstruct.h"
#include "docs/examples/bump.h"
#include "update/update_model.h"
#include "update/update_session.h"

int main() {
  const cocoon::TriangleMesh model = cocoon::reconstruct_tight(cap(4000, 4, 0)).mesh;
  const std::vector<std::vector<cocoon::Point>> north = {cap(6000, 0.8, 0.3)};
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
