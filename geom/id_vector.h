// A std::vector that only its own id type can index.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geom/ids.h"

namespace cocoon {

template <class IdType, class T>
class IdVector {
 public:
  using value_type = T;
  using iterator = typename std::vector<T>::iterator;
  using const_iterator = typename std::vector<T>::const_iterator;

  IdVector() = default;
  explicit IdVector(std::size_t count, const T& value = T()) : data_(count, value) {}
  explicit IdVector(std::vector<T> data) : data_(std::move(data)) {}

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
  void resize(std::size_t count, const T& value = T()) { data_.resize(count, value); }
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
  std::vector<T>& raw() { return data_; }
  const std::vector<T>& raw() const { return data_; }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  std::vector<T> data_;
};

}  // namespace cocoon
