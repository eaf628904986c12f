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
// Nobody waits for a vertex: who does not get one gives back all that it holds and tries another
// point first, so there are no deadlocks. What a thread wrote while it held a vertex is seen by
// the next holder (release and acquire on the vertex's claim).
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

// The claims of one triangulation: a byte a vertex.
class VertexClaims {
 public:
  static constexpr std::size_t max_holders = 250;

  // None of the vertices is inserted.
  explicit VertexClaims(std::size_t num_vertices) : claims_(num_vertices) {}

  bool is_inserted(VertexId v) const {
    return claims_[v.index()].load(std::memory_order_relaxed) != not_inserted;
  }
  // Makes v a vertex that can be held, and that nobody holds; what this thread wrote before is seen
  // by the next holder.
  void admit(VertexId v) { claims_[v.index()].store(nobody, std::memory_order_release); }

 private:
  friend class ClaimHolder;
  static constexpr std::uint8_t not_inserted = 0;
  static constexpr std::uint8_t nobody = 1;
  static constexpr std::uint8_t first_holder = 2;

  std::vector<std::atomic<std::uint8_t>> claims_;
};

// One of the threads, and the vertices that it holds.
class ClaimHolder {
 public:
  // `number` < max_holders tells the holders of `claims`, which must outlive them, apart.
  ClaimHolder(VertexClaims& claims, std::size_t number)
      : claims_(&claims), name_(static_cast<std::uint8_t>(VertexClaims::first_holder + number)) {
    assert(number < VertexClaims::max_holders);
  }

  // Holds v if nobody else does; the vertex at infinity counts as held. Returns whether v is held.
  // False as well for a vertex that is not inserted.
  bool take(VertexId v) {
    if (v == infinite_vertex) return true;
    std::atomic<std::uint8_t>& claim = claims_->claims_[v.index()];
    std::uint8_t seen = claim.load(std::memory_order_relaxed);
    if (seen == name_) return true;
    if (seen != VertexClaims::nobody) return false;
    if (!claim.compare_exchange_strong(seen, name_, std::memory_order_acquire,
                                       std::memory_order_relaxed)) {
      return false;
    }
    held_.push_back(v);
    return true;
  }
  bool take_corners(const Cell& cell) {
    for (const VertexId v : cell.vertices) {
      if (!take(v)) return false;
    }
    return true;
  }

  // Gives all back.
  void release() {
    for (const VertexId v : held_) claims_->admit(v);
    held_.clear();
  }
  // Gives all back but the vertices of `cell`.
  void release_but(const Cell& cell) {
    const auto kept = std::partition(held_.begin(), held_.end(), [&](VertexId v) {
      return std::find(cell.vertices.begin(), cell.vertices.end(), v) != cell.vertices.end();
    });
    std::for_each(kept, held_.end(), [&](VertexId v) { claims_->admit(v); });
    held_.erase(kept, held_.end());
  }
  std::size_t num_held() const { return held_.size(); }

 private:
  VertexClaims* claims_;
  std::uint8_t name_;
  std::vector<VertexId> held_;
};

}  // namespace cocoon
