#include "fuzz/loading.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const flatray::OneSecond limit;
  (void)flatray::load_fuzzed("f.json", flatray::text_of(data, size));
  return 0;
}
