#include "image/srgb.h"

#include <cmath>
#include <limits>

#include "base/check.h"
#include "image/srgb_encoder.h"

namespace flatray {
namespace {

// The smallest float whose nearest value is `value`.
float limit_below(int value) {
  const double exact = light_of(value - 0.5);
  const float nearest = static_cast<float>(exact);
  return static_cast<double>(nearest) < exact
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

}  // namespace

SrgbEncoder::SrgbEncoder() {
  int value = 0;
  std::uint32_t limit = std::bit_cast<std::uint32_t>(limit_below(1)) - kFirst;
  for (std::uint32_t bucket = 0; bucket < kBuckets; ++bucket) {
    std::uint32_t& entry = entries_[bucket];
    entry = static_cast<std::uint32_t>(value) << 16;
    if (limit >> 16 != bucket) continue;
    entry += 0x10000 - (limit & 0xffff);
    ++value;
    limit = value == 255 ? std::numeric_limits<std::uint32_t>::max()
                         : std::bit_cast<std::uint32_t>(limit_below(value + 1)) - kFirst;
    FLATRAY_CHECK(limit >> 16 > bucket, "two limits in one bucket");
  }
  FLATRAY_CHECK(value == 255);
}

const SrgbEncoder& SrgbEncoder::get() {
  static const SrgbEncoder encoder;
  return encoder;
}

std::uint8_t srgb_from_linear(float light) { return SrgbEncoder::get()(light); }

}  // namespace flatray
