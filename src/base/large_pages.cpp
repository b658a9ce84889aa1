#include "base/large_pages.h"

#include <sys/mman.h>

#include <new>

namespace flatray {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20, kLarge = 2 * kPage;

}  // namespace

void* allocate_large(std::size_t bytes) {
  if (bytes < kLarge) return ::operator new(bytes);
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  void* memory = ::operator new (whole, std::align_val_t{kPage});
  madvise(memory, whole, MADV_HUGEPAGE);  // small pages do, too
  return memory;
}

void free_large(void* memory, std::size_t bytes) noexcept {
  if (bytes < kLarge)
    ::operator delete(memory);
  else
    ::operator delete (memory, std::align_val_t{kPage});
}

}  // namespace flatray
