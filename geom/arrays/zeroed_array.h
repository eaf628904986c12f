// An array of zeros that costs memory only where it is touched: for stages that look at few of many
// elements.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace cocoon {

// Indexed by its own id type, like IdVector. Elements begin as all bits zero. The operating system
// hands out large arrays page by page, when an element of the page is first written.
template <class IdType, class T>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t count) : data_(allocate(count)), size_(count) {}

  T& operator[](IdType id) {
    assert(id.index() < size_);
    return data_.get()[id.index()];
  }
  const T& operator[](IdType id) const {
    assert(id.index() < size_);
    return data_.get()[id.index()];
  }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  static T* allocate(std::size_t count) {
    if (count == 0) return nullptr;
    void* data = std::calloc(count, sizeof(T));
    if (data == nullptr) throw std::bad_alloc();
    return static_cast<T*>(data);
  }

  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
};

}  // namespace cocoon
