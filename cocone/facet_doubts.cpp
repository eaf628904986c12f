#include "cocone/facet_doubts.h"

#include <algorithm>
#include <array>

#include "geom/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/facet_doubts.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/vector_lanes-inl.h"
// clang-format on

#ifndef COCOON_FACET_BATCH
#define COCOON_FACET_BATCH
namespace cocoon::facet_doubts_detail {

inline constexpr std::size_t batch_size = circumcenter_batch_size;

// Facets in SIMD lanes, by corner.
struct FacetBatch {
  alignas(64) std::array<BatchOfPoints, 3> corners;
  alignas(64) std::array<BatchOfPoints, 3> normals;
  alignas(64) std::array<std::array<double, batch_size>, 3> squared_limits;  // (rho h_p)^2
  // Out: byte i = doubts of facet i, whatever cocones it meets.
  std::array<FacetDoubts, batch_size> doubts;
};

struct Limits {
  double alpha_cosine;
  double cone_cosine;
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

// The circumcircle of each facet.
struct Circles {
  Vectors first;   // the lexicographically smallest corner
  Vectors normal;  // N: not of unit length
  Vectors offset;  // from `first` to the circumcenter
  Vector squared_normal;
  Vector squared_radius;
  Mask is_sound;  // not thin
};

HWY_INLINE Circles circles_of(const FacetBatch& batch, std::size_t lane) {
  const Lanes d;
  Vectors p = load(batch.corners[0], lane), q = load(batch.corners[1], lane);
  Vectors r = load(batch.corners[2], lane);
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

void judge_batch(FacetBatch& batch, const Limits& limits) {
  const Lanes d;
  const Vector cone_cosine = hn::Set(d, limits.cone_cosine);
  const Vector alpha_cosine = hn::Set(d, limits.alpha_cosine);
  std::uint64_t doubts = 0;  // byte i: bit i of the doubts of each facet
  for (std::size_t first = 0; first < batch_size; first += hn::Lanes(d)) {
    const Circles circles = circles_of(batch, first);
    std::array<Vectors, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) {
      normals[i] = load(batch.normals[i], first);
      const Vectors from_first = minus(load(batch.corners[i], first), circles.first);
      const Vector along = dot(minus(circles.offset, from_first), normals[i]);
      const Vector tilt = dot(circles.normal, normals[i]);
      const Vector limit = hn::Load(d, &batch.squared_limits[i][first]);
      const Mask within = limits.mode == RadiusMode::tangent_plane
                              ? surely_within_in_plane(circles, along, tilt, limit)
                              : surely_within_in_cocone(circles, along, tilt, limit, cone_cosine);
      doubts |= std::uint64_t{lane_bits(hn::Not(hn::And(circles.is_sound, within)))}
                << (8 * i + first);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector cosine = dot(normals[i], normals[(i + 1) % 3]);
      const Mask agree = hn::Ge(hn::Abs(cosine), alpha_cosine);
      doubts |= std::uint64_t{lane_bits(hn::Not(agree))} << (8 * (3 + i) + first);
    }
  }
  doubts = transposed_bits(doubts);
  for (std::size_t i = 0; i < batch_size; ++i) {
    batch.doubts[i] = static_cast<FacetDoubts>(doubts >> (8 * i));
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(judge_batch);

namespace {

using namespace facet_doubts_detail;

constexpr std::size_t facets_per_chunk = 2048;

void put(const Vec3& value, std::size_t lane, BatchOfPoints& batch) {
  batch[0][lane] = value.x;
  batch[1][lane] = value.y;
  batch[2][lane] = value.z;
}

}  // namespace

std::vector<FacetDoubts> facet_doubts(const Triangulation& triangulation, const Poles& poles,
                                      const Cocones& cocones, const BoundaryOptions& options,
                                      const Execution& execution) {
  const Limits limits{options.alpha_cosine, cocones.cosine, options.radius_mode};
  const std::size_t count = cocones.facets.size();
  std::vector<FacetDoubts> doubts(count);
  const auto judge = [&](std::size_t begin, std::size_t end) {
    FacetBatch batch;
    for (std::size_t first = begin; first < end; first += batch_size) {
      for (std::size_t lane = 0; lane < batch_size; ++lane) {
        const Triangle& corners = cocones.corners[std::min(first + lane, end - 1)];
        for (std::size_t i = 0; i < 3; ++i) {
          const VertexId v = corners[i];
          const double limit = options.rho * poles.heights[v];
          put(triangulation.point(v), lane, batch.corners[i]);
          put(poles.normals[v], lane, batch.normals[i]);
          batch.squared_limits[i][lane] = limit * limit;
        }
      }
      COCOON_VECTOR_CALL(judge_batch)(batch, limits);
      for (std::size_t k = first; k < std::min(first + batch_size, end); ++k) {
        doubts[k] = static_cast<FacetDoubts>(batch.doubts[k - first] &
                                             (cocones.met_corners(k) | normals_disagree));
      }
    }
  };
  parallel_chunks(execution, count, facets_per_chunk, judge);
  return doubts;
}

}  // namespace cocoon

#endif  // HWY_ONCE
