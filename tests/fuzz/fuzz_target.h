// What the fuzzer drives: functions of arbitrary bytes that must return, whatever the bytes are.
//
// A target turns bytes into the input of one part of the library and checks what that part promises
// of its result. A broken promise throws std::logic_error; everything else that can go wrong shows
// under AddressSanitizer and UndefinedBehaviorSanitizer. libFuzzer searches for such bytes
// (./dev fuzz); every run of the tests replays those of tests/data/fuzz/NAME.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct FuzzTarget {
  const char* name;
  void (*run)(Bytes bytes);
};
inline void PrintTo(const FuzzTarget& target, std::ostream* out) { *out << target.name; }

// All targets; the folders of tests/data/fuzz have their names.
std::span<const FuzzTarget> fuzz_targets();

// The targets themselves.
void read_ply_target(Bytes bytes);
void read_obj_target(Bytes bytes);
void read_off_target(Bytes bytes);
void read_stl_target(Bytes bytes);
void read_text_points_target(Bytes bytes);
void triangulation_file_target(Bytes bytes);
void session_file_target(Bytes bytes);
void predicates_target(Bytes bytes);
void delaunay_target(Bytes bytes);
void dynamic_delaunay_target(Bytes bytes);
void reconstruct_target(Bytes bytes);
void update_target(Bytes bytes);
void mesh_target(Bytes bytes);

// Throws std::logic_error unless `promise` holds.
inline void require(bool promise, const std::string& what) {
  if (!promise) throw std::logic_error("broken promise: " + what);
}

// Takes values from the front of the bytes; zeros follow the last one.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  bool done() const { return at_ >= bytes_.size(); }
  std::uint8_t byte() { return done() ? std::uint8_t{0} : bytes_[at_++]; }
  std::uint64_t bits(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint64_t{byte()} << (8 * i);
    return value;
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

// Points until the bytes end, at most `most`. The first byte says which kind: small integers (many
// coplanar, cospherical and equal points), points of a sphere with integer coordinates, subnormal
// and huge ones, neighbors of integers, coordinates from a short list of difficult numbers, any
// double.
std::vector<Point> take_points(ByteReader& bytes, std::size_t most);

// A number of take_points' last kinds: finite, of any size.
double take_coordinate(ByteReader& bytes);

// Triangles between `points` until the bytes end, at most `most`; none names a vertex twice.
TriangleMesh take_mesh(ByteReader& bytes, std::vector<Point> points, std::size_t most);

}  // namespace cocoon::fuzz
