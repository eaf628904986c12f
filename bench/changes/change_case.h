// One case of the benchmark of changes: a part before and after a change, and scans of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/changes/simulated_scan.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::bench {

struct ChangeCase {
  std::string part;
  std::string change;
  ScanSetting setting;
  TriangleMesh model;  // reconstructed from about one sample per square unit, with its topology
  std::vector<Point> wrong;  // samples of the model that the change made wrong
  std::vector<Point> right;  // the others
  std::vector<std::vector<Point>> clouds;
  TriangleMesh truth;  // the surface after the change: one part
  double gap = 0;      // the largest distance from a changed place of the truth to a sample
};

// The case of that number for that kind of scan. Parts, changes and places are drawn until the
// initial model is reconstructed rightly, the change leaves one part, at most a third of the
// samples are wrong (at least one), no cloud has less than 20 samples, and half of the changed places
// have one within 1.5 units.
// A function of both arguments.
ChangeCase change_case(std::uint64_t seed, ScanKind kind);

// Whether `mesh` is a closed manifold with parts and handles of `truth`, at most `reach` away from
// it both ways.
bool is_right(const TriangleMesh& mesh, const TriangleMesh& truth, double reach);

}  // namespace cocoon::bench
