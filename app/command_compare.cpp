#include <fmt/format.h>

#include "app/commands.h"
#include "app/files/files.h"
#include "app/shapes/deviation_map.h"
#include "geom/errors.h"
#include "geom/messages/place_name.h"
#include "geom/surface_distance.h"

namespace cocoon::app {

namespace {

void add_distances(JsonReport& report, const std::string& path, const DirectedDistance& distance,
                   bool with_tolerance) {
  report.set(path + "/max", distance.max);
  report.set(path + "/mean", distance.mean);
  report.set(path + "/rms", distance.rms);
  if (with_tolerance) report.set(path + "/within", distance.within);
  report.set(path + "/samples", distance.samples);
  const Point& p = distance.farthest;
  report.set(path + "/farthest", std::vector<double>{p.x, p.y, p.z});
}

void say_distances(Job& job, const std::string& name, const DirectedDistance& distance) {
  job.say("{:<8} max {:.6g} at {}, mean {:.6g}, RMS {:.6g}, {} samples", name, distance.max,
          place_name(distance.farthest), distance.mean, distance.rms, distance.samples);
}

}  // namespace

void run(const CompareArguments& arguments, Job& job) {
  require_outputs(job, {{arguments.mesh, {".ply"}}}, {arguments.a, arguments.b});
  const TriangleMesh a = read_shape(job, arguments.a, "input/a").mesh;
  const TriangleMesh b = read_shape(job, arguments.b, "input/b").mesh;
  for (const auto& [name, shape] : {std::pair(&arguments.a, &a), std::pair(&arguments.b, &b)}) {
    if (shape->points.empty())
      throw InputError(*name + ": holds no points; there is nothing to compare");
  }
  SurfaceDistanceOptions options;
  options.samples = arguments.samples;
  options.tolerance = arguments.tolerance;
  const SurfaceDistance distance = naming_input(arguments.a + " and " + arguments.b, [&] {
    return surface_distance(a, b, options, job.execution());
  });

  JsonReport& report = job.report();
  report.set("input/a/points", a.points.size());
  report.set("input/a/triangles", a.triangles.size());
  report.set("input/b/points", b.points.size());
  report.set("input/b/triangles", b.triangles.size());
  const bool with_tolerance = arguments.tolerance.has_value();
  add_distances(report, "distance/a_to_b", distance.a_to_b, with_tolerance);
  add_distances(report, "distance/b_to_a", distance.b_to_a, with_tolerance);
  report.set("distance/max", distance.max);
  report.set("distance/mean", distance.mean);
  report.set("distance/rms", distance.rms);
  say_distances(job, "A to B:", distance.a_to_b);
  say_distances(job, "B to A:", distance.b_to_a);
  job.say("both:    max {:.6g} (Hausdorff), mean {:.6g}, RMS {:.6g}", distance.max, distance.mean,
          distance.rms);
  if (with_tolerance) {
    report.set("parameters/tolerance", *arguments.tolerance);
    report.set("distance/f_score", distance.f_score);
    job.say("within {:.6g}: {:.2f} % of A, {:.2f} % of B, F-score {:.4f}", *arguments.tolerance,
            100 * distance.a_to_b.within, 100 * distance.b_to_a.within, distance.f_score);
  }
  if (!arguments.mesh.empty()) {
    write_deviation(job, a, b, {arguments.mesh, arguments.writing, arguments.tolerance});
  }
  job.finish();
}

}  // namespace cocoon::app
