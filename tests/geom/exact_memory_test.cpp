#include <gmp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <new>

#include "geom/exact.h"

namespace flatray {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
// Sanitizers end the program where so much is asked for.
TEST(ExactMemory, ANumberThatFindsNoneThrows) {
  throw_where_numbers_lack_memory();
  void* (*take)(std::size_t) = nullptr;
  void* (*take_again)(void*, std::size_t, std::size_t) = nullptr;
  void (*give)(void*, std::size_t) = nullptr;
  mp_get_memory_functions(&take, &take_again, &give);
  volatile std::size_t most = PTRDIFF_MAX;
  EXPECT_THROW(take(most), std::bad_alloc);
  void* some = take(16);
  EXPECT_THROW(take_again(some, 16, most), std::bad_alloc);
  give(some, 16);
  // Through GMP itself: 8 GB where there is one.
  mpz_t number;
  mpz_init_set_ui(number, 1);
  rlimit before{};
  ::getrlimit(RLIMIT_DATA, &before);
  const rlimit narrow{std::uint64_t{1} << 30, before.rlim_max};
  ::setrlimit(RLIMIT_DATA, &narrow);
  EXPECT_THROW(mpz_mul_2exp(number, number, std::uint64_t{1} << 36), std::bad_alloc);
  ::setrlimit(RLIMIT_DATA, &before);
  EXPECT_EQ(mpz_get_ui(number), 1U);
  mpz_clear(number);
}
#endif

}  // namespace
}  // namespace flatray
