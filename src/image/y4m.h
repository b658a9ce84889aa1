#pragma once
#include <string_view>

#include "image/picture_format.h"

namespace flatray {

inline constexpr std::string_view kY4mSignature = "YUV4MPEG2 ";  ///< what its bytes begin with

/// The planes of a frame of YUV4MPEG2 4:4:4, Y, Cb, Cr: of the 8-bit values R, G, B the luma and colour
/// differences of ITU-R BT.709 in limited range,
///
///   Y  = 16 + 219 l / 255                     l = 0.2126 R + 0.7152 G + 0.0722 B
///   Cb = 128 + 224 (B - l) / (255 * 1.8556)   Cr = 128 + 224 (R - l) / (255 * 1.5748)
///
/// each rounded to the nearest whole number. What is clear is laid over black.
///
/// Error   none: whole numbers alone, so the same bytes on every machine.
/// As PictureFormat::of_picture, of what takes these planes.
std::vector<std::byte> y4m_picture(const Image& image, PngEncoder& png, const RowsChanged& changed);
/// PictureFormat::part: the header of the stream before the first frame, the line FRAME before each.
std::vector<std::byte> y4m_part(std::span<const std::byte> planes, std::size_t index,
                                const FrameSequence& sequence);

}  // namespace flatray
