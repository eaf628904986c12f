// A list for the kernel's inner loops: elements are appended without a branch.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace cocoon {

// Memory is kept when the list is cleared.
template <class T>
class ScratchList {
 public:
  // Appends through a pointer of its own, which the compiler can keep in a register. Whether a cell
  // is in conflict, or a vertex is new, is a coin toss that no branch predictor can learn; a
  // mispredicted branch costs more than a store that is overwritten.
  class Writer {
   public:
    explicit Writer(T* at) : at_(at) {}
    void append(const T& value) { *at_++ = value; }
    void append_if(bool keep, const T& value) {
      *at_ = value;
      at_ += keep ? 1 : 0;
    }
    T* position() const { return at_; }

   private:
    T* at_;
  };

  void clear() { size_ = 0; }
  // A writer behind the last element, with room for `extra` more and one that is not kept.
  Writer writer(std::size_t extra) {
    if (size_ + extra >= data_.size()) data_.resize(2 * (size_ + extra) + 8);
    return Writer(data_.data() + size_);
  }
  // Takes in what was appended through `writer`.
  void commit(const Writer& writer) {
    size_ = static_cast<std::size_t>(writer.position() - data_.data());
    assert(size_ <= data_.size());
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
