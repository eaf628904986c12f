#include "cocone/samples/facet_doubts.h"

#include <algorithm>
#include <array>
#include <span>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/samples/facet_doubts.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/gather-inl.h"
// clang-format on

#ifndef COCOON_JUDGED_FACETS
#define COCOON_JUDGED_FACETS
namespace cocoon::facet_doubts_detail {

// Facets by their corners, and what is known of these.
struct JudgedFacets {
  std::span<const Triangle> facets;
  const Point* points;
  const Vec3* normals;
  const double* heights;
};

struct Limits {
  double alpha_cosine;
  double cone_cosine;
  double rho;
  RadiusMode mode;
};

}  // namespace cocoon::facet_doubts_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

using namespace facet_doubts_detail;

// Neither thinner nor steeper than this, squared: then the roundings below, at most a few hundred
// units of 2^-53 relative to the products that are formed, divided by 2^-30 at most, are far below
// the room that the bounds have.
constexpr double least_squared_sine = 0x1p-20;
constexpr double room = 1 + 0x1p-10;

// What facets look at is asked for so many facets before: later the processor would wait for it.
constexpr std::size_t facets_ahead = 48;

// The facets k, k + 1, ... in lanes, by corner; the last facet stands for those behind it.
struct Corners {
  std::array<Vectors, 3> points;
  std::array<Vectors, 3> normals;
  std::array<Vector, 3> heights;
};

template <class FacetAt>
HWY_INLINE Corners gather_corners(const JudgedFacets& judged, FacetAt facet_at) {
  const Lanes d;
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex_at = [&](std::size_t lane) { return facet_at(lane)[i].index(); };
    corners.points[i] = gather([&](std::size_t lane) { return &judged.points[vertex_at(lane)].x; });
    corners.normals[i] =
        gather([&](std::size_t lane) { return &judged.normals[vertex_at(lane)].x; });
    alignas(64) std::array<double, circumcenter_batch_size> heights;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      heights[lane] = judged.heights[vertex_at(lane)];
    }
    corners.heights[i] = hn::Load(d, heights.data());
  }
  return corners;
}

HWY_INLINE Corners corners_of(const JudgedFacets& judged, std::size_t k) {
  return with_places(k, judged.facets.size(), [&](auto place) {
    return gather_corners(
        judged, [&](std::size_t i) -> const Triangle& { return judged.facets[place(i)]; });
  });
}

// The circumcircle of each facet.
struct Circles {
  Vectors first;   // the lexicographically smallest corner
  Vectors normal;  // N: not of unit length
  Vectors offset;  // from `first` to the circumcenter
  Vector squared_normal;
  Vector squared_radius;
  Mask is_sound;  // not thin
};

HWY_INLINE Circles circles_of(const Corners& corners) {
  const Lanes d;
  auto [p, q, r] = corners.points;
  order(p, q);
  order(q, r);
  order(p, q);
  const Vectors u = minus(q, p), v = minus(r, p);
  const Vector uu = dot(u, u), vv = dot(v, v);
  Circles circles;
  circles.first = p;
  circles.normal = cross(u, v);
  circles.squared_normal = dot(circles.normal, circles.normal);
  const Vectors w{hn::Sub(hn::Mul(uu, v.x), hn::Mul(vv, u.x)),
                  hn::Sub(hn::Mul(uu, v.y), hn::Mul(vv, u.y)),
                  hn::Sub(hn::Mul(uu, v.z), hn::Mul(vv, u.z))};
  const Vector scale = hn::Div(hn::Set(d, 0.5), circles.squared_normal);
  const Vectors center = cross(w, circles.normal);
  circles.offset = {hn::Mul(scale, center.x), hn::Mul(scale, center.y), hn::Mul(scale, center.z)};
  circles.squared_radius = dot(circles.offset, circles.offset);
  circles.is_sound =
      hn::Gt(circles.squared_normal, hn::Mul(hn::Set(d, least_squared_sine), hn::Mul(uu, vv)));
  return circles;
}

// |y - p|^2 < limit for the point y of the dual line in the tangent plane, both times (N . n)^2.
HWY_INLINE Mask surely_within_in_plane(const Circles& circles, Vector along, Vector tilt,
                                       Vector limit) {
  const Lanes d;
  const Vector squared_tilt = hn::Mul(tilt, tilt);
  const Vector squared_length = hn::Add(hn::Mul(circles.squared_radius, squared_tilt),
                                        hn::Mul(hn::Mul(along, along), circles.squared_normal));
  const Mask not_steep =
      hn::Gt(squared_tilt, hn::Mul(hn::Set(d, least_squared_sine), circles.squared_normal));
  return hn::And(not_steep,
                 hn::Lt(hn::Mul(hn::Set(d, room), squared_length), hn::Mul(limit, squared_tilt)));
}

// The same for all points of the dual line in the cocone, times (|N . n| - C |N|)^2.
HWY_INLINE Mask surely_within_in_cocone(const Circles& circles, Vector along, Vector tilt,
                                        Vector limit, Vector cone_cosine) {
  const Lanes d;
  const Vector length = hn::Sqrt(circles.squared_normal);
  const Vector steepness = hn::Sub(hn::Abs(tilt), hn::Mul(cone_cosine, length));
  const Vector reach = hn::Mul(
      hn::Add(hn::Mul(cone_cosine, hn::Sqrt(circles.squared_radius)), hn::Abs(along)), length);
  const Vector squared_steepness = hn::Mul(steepness, steepness);
  const Vector squared_length =
      hn::Add(hn::Mul(circles.squared_radius, squared_steepness), hn::Mul(reach, reach));
  const Mask steep = hn::Gt(steepness, hn::Mul(hn::Set(d, 0x1p-10), length));
  return hn::And(
      steep, hn::Lt(hn::Mul(hn::Set(d, room), squared_length), hn::Mul(limit, squared_steepness)));
}

// Byte i: bit i of the doubts of each of the facets in lanes, whatever cocones they meet.
HWY_INLINE std::uint64_t doubts_in_lanes(const Corners& corners, const Limits& limits) {
  const Lanes d;
  const Vector cone_cosine = hn::Set(d, limits.cone_cosine);
  const Vector alpha_cosine = hn::Set(d, limits.alpha_cosine);
  const Circles circles = circles_of(corners);
  const auto& normals = corners.normals;
  std::uint64_t doubts = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vectors from_first = minus(corners.points[i], circles.first);
    const Vector along = dot(minus(circles.offset, from_first), normals[i]);
    const Vector tilt = dot(circles.normal, normals[i]);
    const Vector height = hn::Mul(hn::Set(d, limits.rho), corners.heights[i]);
    const Vector limit = hn::Mul(height, height);
    const Mask within = limits.mode == RadiusMode::tangent_plane
                            ? surely_within_in_plane(circles, along, tilt, limit)
                            : surely_within_in_cocone(circles, along, tilt, limit, cone_cosine);
    doubts |= std::uint64_t{lane_bits(hn::Not(hn::And(circles.is_sound, within)))} << (8 * i);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector cosine = dot(normals[i], normals[(i + 1) % 3]);
    const Mask agree = hn::Ge(hn::Abs(cosine), alpha_cosine);
    doubts |= std::uint64_t{lane_bits(hn::Not(agree))} << (8 * (3 + i));
  }
  return doubts;
}

HWY_INLINE void ask_for(const JudgedFacets& judged, std::size_t first, std::size_t end) {
  for (std::size_t k = first; k < end; ++k) {
    for (const VertexId v : judged.facets[k]) {
      __builtin_prefetch(&judged.points[v.index()]);
      __builtin_prefetch(&judged.normals[v.index()]);
      __builtin_prefetch(&judged.heights[v.index()]);
    }
  }
}

// Of each facet, whatever cocones it meets.
void judge_facets(const JudgedFacets& judged, const Limits& limits, FacetDoubts* doubts) {
  const std::size_t count = judged.facets.size();
  for (std::size_t k = 0; k < count; k += hn::Lanes(Lanes())) {
    ask_for(judged, k + facets_ahead, std::min(k + facets_ahead + hn::Lanes(Lanes()), count));
    const std::uint64_t bytes = transposed_bits(doubts_in_lanes(corners_of(judged, k), limits));
    for (std::size_t i = 0; i < std::min(hn::Lanes(Lanes()), count - k); ++i) {
      doubts[k + i] = static_cast<FacetDoubts>(bytes >> (8 * i));
    }
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(judge_facets);

std::vector<FacetDoubts> facet_doubts(const Triangulation& triangulation, const Poles& poles,
                                      const Cocones& cocones, const BoundaryOptions& options,
                                      const Execution& execution) {
  using namespace facet_doubts_detail;
  constexpr std::size_t facets_per_chunk = 2048;
  const Limits limits{options.alpha_cosine, cocones.cosine, options.rho, options.radius_mode};
  std::vector<FacetDoubts> doubts(cocones.facets.size());
  const auto judge = [&](std::size_t begin, std::size_t end) {
    const JudgedFacets judged{std::span(cocones.corners).subspan(begin, end - begin),
                              triangulation.points().raw().data(), poles.normals.raw().data(),
                              poles.heights.raw().data()};
    COCOON_VECTOR_CALL(judge_facets)(judged, limits, &doubts[begin]);
    for (std::size_t k = begin; k < end; ++k) {
      doubts[k] &= static_cast<FacetDoubts>(cocones.met_corners(k) | normals_disagree);
    }
  };
  parallel_chunks(execution, doubts.size(), facets_per_chunk, judge);
  return doubts;
}

}  // namespace cocoon

#endif  // HWY_ONCE
