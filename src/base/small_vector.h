#pragma once
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <new>
#include <utility>

namespace flatray {

/// Up to kMost values in the order they came, without memory of their own, as std::vector has them.
/// Needs   no more than that; their number is not checked.
template <class Value, std::size_t kMost>
class SmallVector {
 public:
  SmallVector() = default;
  SmallVector(std::initializer_list<Value> values) : size_(values.size()) {
    std::uninitialized_copy_n(values.begin(), size_, begin());
  }
  SmallVector(const SmallVector& other) : size_(other.size_) {
    std::uninitialized_copy_n(other.begin(), size_, begin());
  }
  SmallVector(SmallVector&& other) noexcept : size_(other.size_) {
    std::uninitialized_move_n(other.begin(), size_, begin());
  }
  SmallVector& operator=(SmallVector other) {
    std::destroy(begin(), end());
    size_ = other.size_;
    std::uninitialized_move_n(other.begin(), size_, begin());
    return *this;
  }
  ~SmallVector() { std::destroy(begin(), end()); }

  void push_back(Value value) {
    ::new (static_cast<void*>(end())) Value(std::move(value)), ++size_;
  }
  void pop_back() { std::destroy_at(begin() + --size_); }
  void pop_front() {
    std::move(begin() + 1, end(), begin());
    pop_back();
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Value* begin() { return storage_.values; }
  Value* end() { return begin() + size_; }
  const Value* begin() const { return storage_.values; }
  const Value* end() const { return begin() + size_; }
  Value& operator[](std::size_t i) { return begin()[i]; }
  const Value& operator[](std::size_t i) const { return begin()[i]; }
  Value& front() { return *begin(); }
  const Value& front() const { return *begin(); }
  Value& back() { return begin()[size_ - 1]; }
  const Value& back() const { return begin()[size_ - 1]; }

 private:
  union Storage {
    Value values[kMost];
    Storage() {}
    ~Storage() {}
  } storage_;
  std::size_t size_ = 0;
};

}  // namespace flatray
