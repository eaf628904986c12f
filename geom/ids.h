// Distinct 32-bit id types: an id of one kind cannot index an array of another kind.
#pragma once

#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace cocoon {

// A position in an array, typed by what the array holds. `none` marks "no such element".
template <class Tag>
struct Id {
  std::uint32_t value = none_value;

  static constexpr std::uint32_t none_value = 0xFFFFFFFFU;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t v) : value(v) {}
  constexpr explicit Id(std::size_t v) : value(static_cast<std::uint32_t>(v)) {
    assert(v <= none_value);
  }
  constexpr explicit Id(int v) : value(static_cast<std::uint32_t>(v)) { assert(v >= 0); }

  constexpr bool is_none() const { return value == none_value; }
  constexpr std::size_t index() const { return value; }
  constexpr Id& operator++() {
    ++value;
    return *this;
  }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using PointId = Id<struct PointTag>;        // an input point, in the user's order
using VertexId = Id<struct VertexTag>;      // a vertex of a triangulation or of a mesh
using CellId = Id<struct CellTag>;          // a tetrahedron (finite or infinite)
using FacetId = Id<struct FacetTag>;        // 4 * cell + i: facet i of a cell, seen from that cell
using TriangleId = Id<struct TriangleTag>;  // a triangle of a mesh
using RegionId = Id<struct RegionTag>;      // a part of a segmented mesh

// The corners of a triangle of a mesh, or of a facet of a triangulation.
using Triangle = std::array<VertexId, 3>;

// Half-open range of ids, for `for (VertexId v : id_range<VertexId>(n))`. Complexity: O(1).
template <class IdType>
class IdRange {
 public:
  class iterator {
   public:
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    constexpr explicit iterator(IdType id) : id_(id) {}
    constexpr IdType operator*() const { return id_; }
    constexpr iterator& operator++() {
      ++id_;
      return *this;
    }
    friend constexpr bool operator==(iterator, iterator) = default;

   private:
    IdType id_;
  };
  constexpr IdRange(IdType first, IdType last) : first_(first), last_(last) {}
  constexpr iterator begin() const { return iterator(first_); }
  constexpr iterator end() const { return iterator(last_); }

 private:
  IdType first_;
  IdType last_;
};

template <class IdType>
constexpr IdRange<IdType> id_range(std::size_t count) {
  return IdRange<IdType>(IdType(std::uint32_t{0}), IdType(count));
}

}  // namespace cocoon

template <class Tag>
struct std::hash<cocoon::Id<Tag>> {
  std::size_t operator()(cocoon::Id<Tag> id) const noexcept { return id.value; }
};
