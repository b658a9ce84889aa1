#pragma once

namespace flatray {

/// Rows of the bands a picture is drawn and packed in. By its width alone, so that the bytes do not
/// depend on threads; narrower than 512 pixels, more rows than are drawn at once.
/// Gives   a multiple of `tile_rows`, some 128 K pixels where that allows.
int tile_rows(int width);
int band_rows(int width);

}  // namespace flatray
