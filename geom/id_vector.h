// A std::vector that only its own id type can index.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "geom/ids.h"

namespace cocoon {

// Elements that are made without a value are left as the memory is: for large arrays that several
// threads fill, each its own pages.
template <class T>
struct OverwriteAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = OverwriteAllocator<U>;
  };
  template <class U>
  void construct(U*) noexcept {}
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using OverwriteVector = std::vector<T, OverwriteAllocator<T>>;

// How IdVector stores its elements; specialized for types of which there are large arrays.
template <class T>
struct ElementStorage {
  using type = std::vector<T>;
};

template <class IdType, class T>
class IdVector {
 public:
  using value_type = T;
  using Storage = typename ElementStorage<T>::type;
  using iterator = typename Storage::iterator;
  using const_iterator = typename Storage::const_iterator;

  IdVector() = default;
  explicit IdVector(std::size_t count, const T& value = T()) : data_(count, value) {}
  explicit IdVector(Storage data) : data_(std::move(data)) {}

  T& operator[](IdType id) {
    assert(id.index() < data_.size());
    return data_[id.index()];
  }
  const T& operator[](IdType id) const {
    assert(id.index() < data_.size());
    return data_[id.index()];
  }

  std::size_t size() const { return data_.size(); }
  bool empty() const { return data_.empty(); }
  void reserve(std::size_t count) { data_.reserve(count); }
  // Not std::vector's own filling: g++ reads its value again for each element, byte by byte.
  void resize(std::size_t count, const T& value = T()) {
    const std::size_t before = data_.size();
    if (before == 0) {
      data_.assign(count, value);
    } else {
      data_.resize(count);
      if (count > before) std::fill(data_.begin() + difference(before), data_.end(), value);
    }
  }
  // New elements have no value until they are assigned one. Only where ElementStorage says so.
  void resize_for_overwrite(std::size_t count) {
    static_assert(std::is_same_v<Storage, OverwriteVector<T>>);
    data_.resize(count);
  }
  void clear() { data_.clear(); }
  // Appends and returns the new element's id.
  IdType push_back(const T& value) {
    data_.push_back(value);
    return IdType(data_.size() - 1);
  }

  IdRange<IdType> ids() const { return id_range<IdType>(data_.size()); }
  iterator begin() { return data_.begin(); }
  iterator end() { return data_.end(); }
  const_iterator begin() const { return data_.begin(); }
  const_iterator end() const { return data_.end(); }

  std::span<T> span() { return data_; }
  std::span<const T> span() const { return data_; }
  Storage& raw() { return data_; }
  const Storage& raw() const { return data_; }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  static constexpr std::ptrdiff_t difference(std::size_t count) {
    return static_cast<std::ptrdiff_t>(count);
  }

  Storage data_;
};

}  // namespace cocoon
