#include "update/checks/bridged_gaps.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/messages/require_size.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

namespace cocoon {
namespace {

// A triangle with a long edge.
struct Span {
  Point centroid;
  Point middle;        // of its longest edge
  double length = 0;   // of that edge
  double spacing = 0;  // of the samples there
};

Span span_of(Points vertices, const Triangle& t) {
  const std::array<Point, 3> corners =
      sorted_corners({vertices[t[0].index()], vertices[t[1].index()], vertices[t[2].index()]});
  Span span;
  span.centroid = corners[0] + (1.0 / 3) * ((corners[1] - corners[0]) + (corners[2] - corners[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % 3];
    const double length = distance(a, b);
    if (length <= span.length) continue;
    span.length = length;
    span.middle = 0.5 * a + 0.5 * b;
  }
  return span;
}

// The largest of those whose samples are among the corners.
double spacing_of(Points vertices, const Triangle& t, VertexId first_new,
                  std::span<const NearestPointTree> samples, std::span<const double> spacings) {
  double spacing = 0;
  for (std::size_t c = 0; c < samples.size(); ++c) {
    const bool is_there = std::any_of(t.begin(), t.end(), [&](VertexId v) {
      return v >= first_new && samples[c].any_near(vertices[v.index()], 0);
    });
    if (is_there) spacing = std::max(spacing, spacings[c]);
  }
  return spacing;
}

std::vector<Span> long_spans(Points vertices, std::span<const Triangle> triangles,
                             VertexId first_new, std::span<const NearestPointTree> samples,
                             std::span<const double> spacings, double reach) {
  std::vector<Span> found;
  const double least = *std::min_element(spacings.begin(), spacings.end());
  for (const Triangle& t : triangles) {
    if (std::none_of(t.begin(), t.end(), [&](VertexId v) { return v >= first_new; })) continue;
    Span span = span_of(vertices, t);
    if (span.length <= reach * least) continue;
    span.spacing = spacing_of(vertices, t, first_new, samples, spacings);
    if (span.spacing > 0 && span.length > reach * span.spacing) found.push_back(span);
  }
  return found;
}

}  // namespace

BridgedGaps bridged_gaps(const ModelIndex& model, Points vertices,
                         std::span<const Triangle> triangles, VertexId first_new,
                         std::span<const NearestPointTree> samples,
                         std::span<const double> spacings, const GapOptions& options) {
  require_options("bridged_gaps", options);
  require_size("bridged_gaps", "spacings", spacings.size(), samples.size());
  BridgedGaps gaps;
  if (samples.empty()) return gaps;
  const std::vector<Span> spans =
      long_spans(vertices, triangles, first_new, samples, spacings, options.reach);
  if (spans.empty()) return gaps;
  std::vector<Point> centroids;
  for (const Span& span : spans) centroids.push_back(span.centroid);
  const double largest = *std::max_element(spacings.begin(), spacings.end());
  const NearFacets facets(model, centroids, options.off_model * largest);
  for (const Span& span : spans) {
    const double off = options.off_model * span.spacing;
    if (!facets.closest(span.centroid, off * off).triangle.is_none()) continue;
    ++gaps.triangles;
    const double length = span.length / span.spacing;
    if (std::pair(-length, span.middle) >= std::pair(-gaps.longest, gaps.at)) continue;
    gaps.longest = length;
    gaps.at = span.middle;
  }
  return gaps;
}

double spacing_at(const ModelIndex& model, const Scan& scan, std::span<const TriangleId> facets) {
  std::vector<double> edges;
  edges.reserve(facets.size());
  for (const TriangleId t : facets) edges.push_back(median_edge(model.mesh(), t));
  return edges.empty() ? scan.spacing : std::max(scan.spacing, median(std::move(edges)));
}

}  // namespace cocoon
