#include <utility>

#include "app/commands.h"
#include "app/files.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "io/tetrahedra_file.h"

namespace cocoon::app {

void run_delaunay(const DelaunayArguments& arguments, Job& job) {
  require_outputs(job, {{arguments.file, {".vtu", ".mesh", ".tet"}}});
  const std::vector<Point> points = read_cloud(job, arguments.points, "input");
  DelaunayResult result =
      naming_input(arguments.points, [&] { return delaunay(points, {}, job.execution()); });
  const Triangulation triangulation = canonical_order(std::move(result.triangulation));
  timed(job.execution(), "write", [&] { write_tetrahedra(arguments.file, triangulation); });

  JsonReport& report = job.report();
  report.set("input/points", points.size());
  report.set("input/duplicates", triangulation.num_duplicates());
  report.set("delaunay/points", triangulation.num_vertices());
  report.set("delaunay/tetrahedra", triangulation.num_finite_cells());
  report.set("delaunay/hull_triangles",
             triangulation.num_cells() - triangulation.num_finite_cells());
  report.set("delaunay/counters/walk_steps", result.counters.walk_steps);
  report.set("delaunay/counters/conflict_tests", result.counters.conflict_tests);
  report.set("delaunay/counters/cells_created", result.counters.cells_created);
  report.set("delaunay/counters/exact_inspheres", result.counters.exact_inspheres);
  report.set("delaunay/counters/perturbed_inspheres", result.counters.perturbed_inspheres);
  job.say("{} points ({} duplicates), {} tetrahedra -> {}", triangulation.num_vertices(),
          triangulation.num_duplicates(), triangulation.num_finite_cells(), arguments.file);
  job.finish();
}

}  // namespace cocoon::app
