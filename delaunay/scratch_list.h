// A list for the kernel's inner loops: elements are appended without a branch.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace cocoon {

// Whether a cell is in conflict, or a vertex is new, is a coin toss that no branch predictor can
// learn; a mispredicted branch costs more than a store that is overwritten. Memory is kept when the
// list is cleared.
template <class T>
class ScratchList {
 public:
  void clear() { size_ = 0; }
  // Makes sure that `extra` more elements can be appended.
  void make_room(std::size_t extra) {
    if (size_ + extra > data_.size()) data_.resize(2 * (size_ + extra));
  }
  // Precondition for both: make_room was called for at least one more element.
  void append(const T& value) {
    assert(size_ < data_.size());
    data_[size_++] = value;
  }
  void append_if(bool keep, const T& value) {
    assert(size_ < data_.size());
    data_[size_] = value;
    size_ += keep ? 1 : 0;
  }

  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  const T* begin() const { return data_.data(); }
  const T* end() const { return data_.data() + size_; }

 private:
  std::vector<T> data_;  // its size is the capacity of the list
  std::size_t size_ = 0;
};

}  // namespace cocoon
