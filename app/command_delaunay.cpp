#include <utility>

#include "app/commands.h"
#include "app/files/files.h"
#include "app/report/verification.h"
#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "geom/messages/counted.h"
#include "io/tetrahedra_file.h"

namespace cocoon::app {

namespace {

// How the build went depends on how the threads meet, if there are several; a report does not.
void add_counters(JsonReport& report, const DelaunayCounters& counters) {
  report.set("delaunay/counters/walk_steps", counters.walk_steps);
  report.set("delaunay/counters/conflict_tests", counters.conflict_tests);
  report.set("delaunay/counters/cells_created", counters.cells_created);
  report.set("delaunay/counters/wide_inspheres", counters.wide_inspheres);
  report.set("delaunay/counters/exact_inspheres", counters.exact_inspheres);
  report.set("delaunay/counters/perturbed_inspheres", counters.perturbed_inspheres);
}

}  // namespace

void run(const DelaunayArguments& arguments, Job& job) {
  require_outputs(job, {{arguments.file, {".vtu", ".mesh", ".tet"}}}, {arguments.points});
  const std::vector<Point> points = read_cloud(job, arguments.points, "input");
  DelaunayResult result =
      naming_input(arguments.points, [&] { return delaunay(points, {}, job.execution()); });
  const Triangulation triangulation = canonical_order(std::move(result.triangulation));
  if (arguments.verify) {
    const DelaunayReport verified = timed(job.execution(), "verify", [&] {
      return check_delaunay(triangulation, {job.shared().threads, nullptr});
    });
    report_verification(job.report(), arguments.points, triangulation.num_finite_cells(), verified);
  }
  timed(job.execution(), "write", [&] {
    write_tetrahedra(arguments.file, triangulation, {.ascii = arguments.ascii}, job.outputs());
  });

  JsonReport& report = job.report();
  report.set("input/points", points.size());
  report.set("input/duplicates", triangulation.num_duplicates());
  report.set("delaunay/points", triangulation.num_vertices());
  report.set("delaunay/tetrahedra", triangulation.num_finite_cells());
  report.set("delaunay/hull_triangles",
             triangulation.num_cells() - triangulation.num_finite_cells());
  if (thread_count(job.execution()) == 1) add_counters(report, result.counters);
  job.say_outputs("{} ({}), {} -> {}", counted(triangulation.num_vertices(), "point"),
                  counted(triangulation.num_duplicates(), "duplicate"),
                  counted(triangulation.num_finite_cells(), "tetrahedron", "tetrahedra"),
                  arguments.file);
  job.finish();
}

}  // namespace cocoon::app
