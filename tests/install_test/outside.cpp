// Ten lines of somebody else's program, with a header of each library: a sample is updated.
#include <cstdio>

#include "io/sample_models.h"
#include "update/update_session.h"

int main() {
  const cocoon::SampleModel sample =
      cocoon::sample_model("block", {.points = 1500, .cloud_points = 1500});
  cocoon::UpdateSession session(sample.initial);
  const cocoon::UpdateResult result = session.apply(sample.clouds).result;
  std::printf("%zu triangles\n", session.model().triangles.size());
  return result.status == cocoon::UpdateStatus::ok ? 0 : 1;
}
