#include "cocone/facets/corner_normals.h"

#include <algorithm>
#include <limits>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/facets/corner_normals.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/gather-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

// The points of triangles are asked for so many triangles before: later the processor would wait.
constexpr std::size_t triangles_ahead = 48;

// As unit() of geom/point.h.
HWY_INLINE Vectors units(const Vectors& a) {
  const Lanes d;
  const Vector length = hn::Sqrt(dot(a, a));
  const Mask has_length = hn::And(hn::Gt(length, hn::Zero(d)),
                                  hn::Le(length, hn::Set(d, std::numeric_limits<double>::max())));
  return {hn::IfThenElseZero(has_length, hn::Div(a.x, length)),
          hn::IfThenElseZero(has_length, hn::Div(a.y, length)),
          hn::IfThenElseZero(has_length, hn::Div(a.z, length))};
}

// Of triangle_at(i) in lane i.
template <class TriangleAt>
HWY_INLINE Vectors normals_of(const Point* points, TriangleAt triangle_at) {
  const auto corners = [&](std::size_t j) {
    return gather([&](std::size_t i) { return &points[triangle_at(i)[j].index()].x; });
  };
  Vectors a = corners(0), b = corners(1), c = corners(2);
  const Mask swapped[] = {order(a, b), order(b, c), order(a, b)};
  const Mask is_turned = hn::Xor(hn::Xor(swapped[0], swapped[1]), swapped[2]);
  const Lanes d;
  const Vector sign = hn::IfThenElse(is_turned, hn::Set(d, -1.0), hn::Set(d, 1.0));
  const Vectors normals = units(cross(minus(b, a), minus(c, a)));
  return {hn::Mul(sign, normals.x), hn::Mul(sign, normals.y), hn::Mul(sign, normals.z)};
}

void write_normals(const Point* points, std::span<const Triangle> triangles, std::size_t begin,
                   std::size_t end, Vec3* normals) {
  const Lanes d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t t = begin; t < end; t += lanes) {
    const std::size_t ahead = std::min(t + triangles_ahead, triangles.size());
    for (const Triangle& later :
         triangles.subspan(ahead, std::min(lanes, triangles.size() - ahead))) {
      for (const VertexId v : later) __builtin_prefetch(&points[v.index()]);
    }
    const Vectors found = with_places(t, end, [&](auto place) {
      return normals_of(points,
                        [&](std::size_t i) -> const Triangle& { return triangles[place(i)]; });
    });
    if (t + lanes <= end) {
      hn::StoreInterleaved3(found.x, found.y, found.z, d, &normals[t].x);
      continue;
    }
    alignas(64) BatchOfPoints rest;
    store(found, rest, 0);
    for (std::size_t i = 0; t + i < end; ++i) normals[t + i] = {rest[0][i], rest[1][i], rest[2][i]};
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(write_normals);

void corner_normals(const IdVector<VertexId, Point>& points, std::span<const Triangle> triangles,
                    std::size_t begin, std::size_t end, std::span<Vec3> normals) {
  COCOON_VECTOR_CALL(write_normals)
  (points.raw().data(), triangles, begin, end, normals.data());
}

}  // namespace cocoon

#endif  // HWY_ONCE
