#pragma once
#include <span>
#include <string_view>

#include "image/image.h"

namespace flatray {

/// Portable float map: every float as it is, rows from the bottom, the lowest byte first.
std::vector<std::byte> encode_pfm(const LinearImage& image);

inline constexpr std::string_view kPfmSignature = "PF\n";  ///< what its bytes begin with
/// Reads what `encode_pfm` writes. Error   Trouble::invalid for anything else, before anything is
/// allocated.
Result<LinearImage> decode_pfm(std::span<const std::byte> bytes, const std::string& name);

}  // namespace flatray
