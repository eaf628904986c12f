// Which thread may change the cells at which vertices, while several threads insert points.
//
//   A thread does with a cell only what it holds vertices for:
//     one finite vertex of the cell         read its vertices
//     one finite vertex of its facet i      read neighbors[i]
//     all finite vertices of its facet i    write neighbors[i]
//     all its finite vertices               remove it
//
// Two threads never hold the same vertex, and a cell has at most four. So the cells of a conflict
// zone are one thread's own, and so is all that an insertion touches outside: the cell behind a
// border facet shares the facet's vertices with the zone, hence nobody else can remove it, and
// another thread that links to it would do so through another of its facets, which shares a vertex
// with the first. The vertex at infinity need not be held, which would let only one thread at a
// time work on the hull: any two facets of an infinite cell share a finite vertex.
//
// A claim is for a block of vertices, neighbors on the curve: that makes claims few. While there
// are far more blocks than threads they are rarely in each other's way. A vertex that is being
// inserted need not be held: nobody else can see it, but through cells whose other vertices are
// held.
//
// Nobody waits for a vertex: who does not get one gives back all that it holds and tries another
// point first, so there are no deadlocks. What a thread wrote while it held a vertex is seen by
// the next holder (release and acquire on the claim).
// Source: Blandford, Blelloch & Kadow, Engineering a compact parallel Delaunay algorithm in 3D
// (SoCG 2006), for locks on vertices.
#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon {

// The claims of one triangulation.
class VertexClaims {
 public:
  static constexpr std::size_t max_holders = 250;

  // 2^block_bits consecutive vertices share a claim.
  VertexClaims(std::size_t num_vertices, unsigned block_bits)
      : block_bits_(block_bits),
        beyond_(static_cast<std::uint32_t>(num_vertices + (std::size_t{1} << block_bits))),
        claims_((beyond_ >> block_bits) + 1) {}

 private:
  friend class ClaimHolder;
  static constexpr std::uint8_t nobody = 0;
  static constexpr std::uint8_t first_holder = 1;

  unsigned block_bits_;
  std::uint32_t beyond_;                           // a number whose block has no vertex
  std::vector<std::atomic<std::uint8_t>> claims_;  // by block: who holds it
};

// One of the threads, and the vertices that it holds.
class ClaimHolder {
 public:
  // `number` < max_holders tells the holders of `claims`, which must outlive them, apart.
  ClaimHolder(VertexClaims& claims, std::size_t number)
      : claims_(claims.claims_.data()),
        block_bits_(claims.block_bits_),
        beyond_(claims.beyond_),
        name_(static_cast<std::uint8_t>(VertexClaims::first_holder + number)) {
    assert(number < VertexClaims::max_holders);
  }

  // False for the vertex at infinity.
  bool holds(VertexId v) const {
    return claims_[block_of(v)].load(std::memory_order_relaxed) == name_;
  }

  // Holds v if nobody else does; the vertex at infinity counts as held. Returns whether v is held.
  bool take(VertexId v) {
    if (holds(v)) [[likely]]
      return true;
    return take_anew(v);
  }
  bool take_corners(const Cell& cell) {
    for (const VertexId v : cell.vertices) {
      if (!take(v)) return false;
    }
    return true;
  }

  // Gives all back.
  void release();
  // Gives all back but the vertices of `cell`.
  void release_but(const Cell& cell);
  std::size_t num_held() const { return held_.size(); }  // claims

 private:
  bool take_anew(VertexId v);
  void give_back(std::size_t block) {
    claims_[block].store(VertexClaims::nobody, std::memory_order_release);
  }
  // The vertex at infinity has a block behind the last vertex, which nobody holds.
  std::size_t block_of(VertexId v) const { return std::min(v.value, beyond_) >> block_bits_; }

  std::atomic<std::uint8_t>* claims_;
  unsigned block_bits_;
  std::uint32_t beyond_;
  std::uint8_t name_;
  std::vector<std::size_t> held_;  // blocks
};

}  // namespace cocoon
