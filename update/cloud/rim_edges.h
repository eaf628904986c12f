// The edges along which a cloud ends, and the samples beside and beyond them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

struct RimEdge {
  std::size_t loop;
  std::size_t index;
  Point middle;
  Vec3 outward;  // unit, in the plane of its triangle, away from it
};

// A sample beyond an edge, each by its place in a list.
struct SampleBeyond {
  std::size_t edge;
  std::uint32_t sample;
};

// The edges of all loops that have no cloud beyond them (RimLoop::inner). Complexity: O(rim).
std::vector<RimEdge> ends_of_cloud(const CloudRim& rim);

// The samples of all clouds within reach of the middle of an edge, and some more. Complexity:
// O(samples + edges).
std::vector<Point> samples_near(std::span<const std::vector<Point>> clouds,
                                const std::vector<RimEdge>& edges, double reach);

// The pairs of an edge and a sample within `reach` of its middle that lies at least `outward`
// beyond it (less than 0: no farther inward); in the order of edges. Complexity: O(n log n) for n
// samples near the edges.
std::vector<SampleBeyond> samples_beyond(const std::vector<RimEdge>& edges,
                                         const std::vector<Point>& samples, double reach,
                                         double outward);

struct StepBounds {
  double min_step = 0;
  double farthest = 0;  // distances from the model beyond this count as infinite
  // Of edges farther from the model than this nothing more is asked.
  double off_model = 0;
};

// 1 for the edges with a sample beyond them whose distance from the model differs from that of the
// middle of the edge by more than min_step, or with any if its middle is off the model. Complexity:
// what NearFacets takes for edges and samples in pairs; O(edges) if there are none.
std::vector<std::uint8_t> edges_with_steps(const ModelIndex& model,
                                           const std::vector<RimEdge>& edges,
                                           const std::vector<Point>& samples,
                                           const std::vector<SampleBeyond>& beyond,
                                           const StepBounds& bounds);

}  // namespace cocoon
