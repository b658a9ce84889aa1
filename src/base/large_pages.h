#pragma once
#include <cstddef>
#include <vector>

namespace flatray {

/// `bytes` of memory: from 4 MB on in pages of 2 MB where the machine has such, of which it hands out as
/// much in less time.
/// Throws  std::bad_alloc.
void* allocate_large(std::size_t bytes);
/// Gives back what allocate_large(bytes) gave.
void free_large(void* memory, std::size_t bytes) noexcept;

template <class T>
struct LargePages {
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  using value_type = T;
  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_large(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { free_large(memory, count * sizeof(T)); }
  bool operator==(const LargePages&) const = default;
};
/// A vector that is often made with millions of things.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace flatray
