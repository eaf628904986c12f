#include "bench/rivals/tetgen.h"

#define TETLIBRARY  // as its Debian package was compiled
#include <string>
#include <tetgen.h>

namespace cocoon::rivals {

TimedBuild tetgen_delaunay(Points points) {
  tetgenio input;
  input.firstnumber = 0;
  input.numberofpoints = static_cast<int>(points.size());
  input.pointlist = new REAL[3 * points.size()];  // tetgenio deletes it
  for (std::size_t i = 0; i < points.size(); ++i) {
    input.pointlist[3 * i] = points[i].x;
    input.pointlist[3 * i + 1] = points[i].y;
    input.pointlist[3 * i + 2] = points[i].z;
  }
  // Quiet; neither points nor faces of the hull in the output.
  std::string switches = "QNF";
  tetgenio output;
  const bench::Stopwatch stopwatch;
  tetrahedralize(switches.data(), &input, &output);
  return {stopwatch.elapsed(), static_cast<std::size_t>(output.numberoftetrahedra)};
}

}  // namespace cocoon::rivals
