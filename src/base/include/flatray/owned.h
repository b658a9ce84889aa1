#pragma once

namespace flatray::api {

/// The only owner of an object whose type is known to the library alone. Once it is moved from, it
/// owns nothing; assigned to itself it keeps what it owns. (std::unique_ptr would cost every program
/// that includes it twenty thousand lines.)
///
/// Needs   T to be complete where an owner is destroyed or assigned to.
template <class T>
class Owned {
 public:
  Owned() = default;
  explicit Owned(T* object) : object_(object) {}
  Owned(Owned&& other) noexcept : object_(other.object_) { other.object_ = nullptr; }
  Owned& operator=(Owned&& other) noexcept {
    if (this == &other) return *this;
    delete object_;
    object_ = other.object_;
    other.object_ = nullptr;
    return *this;
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { delete object_; }

  explicit operator bool() const { return object_ != nullptr; }
  T& operator*() const { return *object_; }
  T* operator->() const { return object_; }

 private:
  T* object_ = nullptr;
};

}  // namespace flatray::api
