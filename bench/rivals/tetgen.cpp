#include "bench/rivals/tetgen.h"

#define TETLIBRARY  // as its Debian package was compiled
#include <array>
#include <string>
#include <tetgen.h>

#include "ref/cell_set.h"

namespace cocoon::rivals {
namespace {

// `input` deletes its list itself.
void put(Points points, tetgenio& input) {
  input.firstnumber = 0;
  input.numberofpoints = static_cast<int>(points.size());
  input.pointlist = new REAL[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) {
    input.pointlist[3 * i] = points[i].x;
    input.pointlist[3 * i + 1] = points[i].y;
    input.pointlist[3 * i + 2] = points[i].z;
  }
}

void triangulate(tetgenio& input, tetgenio& output) {
  // Quiet; neither points nor faces of the hull in the output.
  std::string switches = "QNF";
  tetrahedralize(switches.data(), &input, &output);
}

}  // namespace

TimedBuild tetgen_delaunay(Points points) {
  tetgenio input;
  put(points, input);
  tetgenio output;
  const bench::Stopwatch stopwatch;
  triangulate(input, output);
  return {stopwatch.elapsed(), static_cast<std::size_t>(output.numberoftetrahedra)};
}

std::uint64_t tetgen_cell_set_hash(Points points) {
  tetgenio input;
  put(points, input);
  tetgenio output;
  triangulate(input, output);
  std::uint64_t sum = 0;
  const int* corner = output.tetrahedronlist;
  for (int cell = 0; cell < output.numberoftetrahedra; ++cell, corner += output.numberofcorners) {
    std::array<PointId, 4> ids;
    for (std::size_t i = 0; i < 4; ++i) ids[i] = PointId(static_cast<std::size_t>(corner[i]));
    sum += ref::cell_hash(ids);
  }
  return sum;
}

}  // namespace cocoon::rivals
