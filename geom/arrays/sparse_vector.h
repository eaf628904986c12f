// A list whose elements are all equal but for few: costs memory and time only where others are.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/id_vector.h"

namespace cocoon {

// Indexed by its own id type, like IdVector. Elements are kept in blocks; blocks in which all
// elements were never set share one.
template <class IdType, class T>
class SparseVector {
 public:
  SparseVector() = default;
  // Complexity: O(count / block size).
  explicit SparseVector(std::size_t count, const T& usual = T())
      : size_(count), place_of_(num_blocks(count), 0), elements_(block, usual) {}

  std::size_t size() const { return size_; }
  IdRange<IdType> ids() const { return id_range<IdType>(size_); }
  // What elements are that were never set.
  const T& usual() const { return elements_.front(); }

  const T& operator[](IdType id) const {
    assert(id.index() < size_);
    return elements_[place_of_[id.index() / block] + id.index() % block];
  }
  // O(1), O(block size) for the first one of a block. By value: it may be an element of this list,
  // which moves.
  void set(IdType id, T value) {
    assert(id.index() < size_);
    std::uint32_t& place = place_of_[id.index() / block];
    if (place == 0) {
      place = static_cast<std::uint32_t>(elements_.size());
      elements_.resize(elements_.size() + block);
      std::copy_n(elements_.begin(), block, elements_.begin() + place);
    }
    elements_[place + id.index() % block] = std::move(value);
  }
  void push_back(T value) {
    if (elements_.empty()) elements_.resize(block);
    place_of_.resize(num_blocks(++size_), 0);
    set(IdType(size_ - 1), std::move(value));
  }

  // Calls visit(id) for all elements for which test(value) holds, ascending. Complexity: that of
  // the blocks with elements that were set; O(size) if it holds for the usual one.
  template <class Test, class Visit>
  void visit_where(const Test& test, const Visit& visit) const {
    if (size_ == 0) return;
    const bool all = test(usual());
    for (std::size_t b = 0; b < place_of_.size(); ++b) {
      if (place_of_[b] == 0 && !all) continue;
      const std::size_t end = std::min(block, size_ - b * block);
      for (std::size_t k = 0; k < end; ++k) {
        if (test(elements_[place_of_[b] + k])) visit(IdType(b * block + k));
      }
    }
  }
  // Makes each element, the usual ones too, renew(element).
  template <class Renew>
  void renew(const Renew& renew) {
    for (T& element : elements_) element = renew(element);
  }

  friend bool operator==(const SparseVector& a, const SparseVector& b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i) equal = a[IdType(i)] == b[IdType(i)];
    return equal;
  }

 private:
  static constexpr std::size_t block = 64;
  static std::size_t num_blocks(std::size_t count) { return (count + block - 1) / block; }

  std::size_t size_ = 0;
  std::vector<std::uint32_t> place_of_;  // of each block in elements_; the first is shared
  std::vector<T> elements_;
};

}  // namespace cocoon
