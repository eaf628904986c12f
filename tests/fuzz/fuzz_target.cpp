#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace cocoon::fuzz {

namespace {

constexpr std::array<double, 24> difficult = {0.0,
                                              1.0,
                                              -1.0,
                                              0.1,
                                              0.2,
                                              0.30000000000000004,
                                              0x1.0000000000001p0,
                                              0x1.fffffffffffffp-1,
                                              5e-324,
                                              -5e-324,
                                              0x1p-1022,
                                              0x1p-540,
                                              1e-150,
                                              1e150,
                                              0x1p-100,
                                              0x1.8p-101,
                                              0x1p100,
                                              0x1.8p101,
                                              1e300,
                                              -1e300,
                                              0x1.fffffffffffffp1023,
                                              -0x1.fffffffffffffp1023,
                                              1e7,
                                              10000000.001};

double small_integer(ByteReader& bytes) { return static_cast<double>(bytes.byte() % 4); }

// A point of the sphere about the origin with squared radius 99, with integer coordinates.
Point on_integer_sphere(ByteReader& bytes) {
  static constexpr std::array<std::array<double, 3>, 4> triples = {
      {{1, 7, 7}, {3, 3, 9}, {5, 5, 7}, {9, 3, 3}}};
  const std::uint8_t choice = bytes.byte();
  const std::uint8_t turn = bytes.byte();
  const std::array<double, 3>& triple = triples[choice % 4];
  const auto coordinate = [&](int axis) {
    const double value = triple[static_cast<std::size_t>((axis + turn) % 3)];
    return (choice >> (axis + 2) & 1) != 0 ? -value : value;
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

double next_to_integer(ByteReader& bytes) {
  const std::uint8_t byte = bytes.byte();
  double value = byte % 8;
  for (int i = 0; i < byte / 64; ++i) value = std::nextafter(value, i % 2 == 0 ? 9.0 : -1.0);
  return value;
}

double any_finite(ByteReader& bytes) {
  const auto value = std::bit_cast<double>(bytes.bits(8));
  return std::isfinite(value) ? value : 0.0;
}

}  // namespace

double take_coordinate(ByteReader& bytes) {
  const std::uint8_t kind = bytes.byte();
  return kind < 192 ? difficult[kind % difficult.size()] : any_finite(bytes);
}

std::vector<Point> take_points(ByteReader& bytes, std::size_t most) {
  const std::uint8_t kind = bytes.byte();
  const auto of_coordinates = [&](auto coordinate) {
    return Point{coordinate(), coordinate(), coordinate()};
  };
  // Sizes far apart in one set need long exact arithmetic: few of them, so that many sets are
  // tried.
  constexpr std::size_t most_difficult = 6;
  if (kind % 8 == 5 || kind % 8 == 7) most = std::min(most, most_difficult);
  std::vector<Point> points;
  while (!bytes.done() && points.size() < most) {
    switch (kind % 8) {
      case 0:
        points.push_back(of_coordinates([&] { return small_integer(bytes); }));
        break;
      case 1:
        points.push_back(on_integer_sphere(bytes));
        break;
      case 2:
        points.push_back(of_coordinates([&] { return std::ldexp(small_integer(bytes), -1074); }));
        break;
      case 3:
        points.push_back(of_coordinates([&] { return std::ldexp(small_integer(bytes), 1021); }));
        break;
      case 4:
        points.push_back(of_coordinates([&] { return next_to_integer(bytes); }));
        break;
      case 5:
        points.push_back(of_coordinates([&] { return take_coordinate(bytes); }));
        break;
      case 6:
        points.push_back(of_coordinates([&] { return static_cast<double>(bytes.bits(2)); }));
        break;
      default:
        points.push_back(of_coordinates([&] { return any_finite(bytes); }));
    }
  }
  return points;
}

TriangleMesh take_mesh(ByteReader& bytes, std::vector<Point> points, std::size_t most) {
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(std::move(points));
  if (mesh.points.size() < 3) return mesh;
  while (!bytes.done() && mesh.triangles.size() < most) {
    Triangle t;
    for (VertexId& v : t) v = VertexId(bytes.byte() % mesh.points.size());
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  return mesh;
}

std::span<const FuzzTarget> fuzz_targets() {
  static constexpr FuzzTarget targets[] = {
      {"read_ply", read_ply_target},
      {"read_obj", read_obj_target},
      {"read_off", read_off_target},
      {"read_stl", read_stl_target},
      {"read_text_points", read_text_points_target},
      {"triangulation_file", triangulation_file_target},
      {"session_file", session_file_target},
      {"predicates", predicates_target},
      {"delaunay", delaunay_target},
      {"dynamic_delaunay", dynamic_delaunay_target},
      {"reconstruct", reconstruct_target},
      {"update", update_target},
      {"mesh", mesh_target},
  };
  return targets;
}

}  // namespace cocoon::fuzz
