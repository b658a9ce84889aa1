#pragma once
#include <stddef.h>
#include <stdint.h>

/// What `flatray` and the module flatray_gl.so tell each other: plain structs, nothing else. The
/// module knows triangles; what they are triangles of is decided on the other side.

/// Grows with every change of what stands below: a module of another number is not used.
#define FLATRAY_GL_ABI 4
/// Most pixels of a tile in either direction.
#define FLATRAY_GL_TILE 2048

extern "C" {

/// Position in pixels of the tile, y down; linear light, premultiplied, or one number: in a batch
/// of gradients which it is, where a layer is laid how much of it shows.
struct FlatrayGlVertex {
  float x, y;
  float paint[4];
};

/// Colours by a number t of each pixel's centre p in the film: (p - origin) . axis, or |p - origin|
/// * axis[0] of a radial one. Read by a shader as it stands here.
struct FlatrayGlGradient {
  uint32_t radial;
  uint32_t first_stop, stop_count;  ///< at least one
  uint32_t unused;
  double origin[2], axis[2];
};

/// Light is that of the last stop at or before t, moved towards the next one's.
struct FlatrayGlStop {
  double at;  ///< of one gradient, rising or equal
  double unused;
  float rgba[4];  ///< premultiplied
};

/// What is done with the triangles of a batch.
enum FlatrayGlKind {
  FLATRAY_GL_PAINT,  ///< blends its triangles
  FLATRAY_GL_COUNT,  ///< adds the winding of its triangles to the samples in them, modulo 256
  FLATRAY_GL_FLIP,   ///< flips the mark of the samples in its triangles
  FLATRAY_GL_SUM,    ///< adds the winding of its triangles to sums that begin at 0 and may be large
  FLATRAY_GL_FIND,   ///< marks the samples in its triangles whose sum is not 0
  FLATRAY_GL_COVER,  ///< blends its triangles where samples are marked, and takes the marks away
  FLATRAY_GL_LAYER,  ///< makes its triangles clear on the layer, where what follows is drawn
  FLATRAY_GL_LAY     ///< lays the layer over the picture, where what follows is drawn again
};

/// Vertices [first, first + count): triangles, drawn in their order.
struct FlatrayGlBatch {
  int32_t kind;
  int32_t gradients;  ///< whether the vertices that are blended name gradients
  uint32_t first, count;
};

/// A rectangle of pixels to draw.
struct FlatrayGlTile {
  int32_t x, y;  ///< in the film
  int32_t width, height;
  int32_t samples;           ///< of MSAA: 4, or 1 at the pixel's centre
  const float (*shifts)[2];  ///< it is drawn once for each, the geometry moved by it; then averaged
  size_t shift_count;
  float background[4];  ///< premultiplied
  const FlatrayGlVertex* vertices;
  size_t vertex_count;
  const FlatrayGlBatch* batches;
  size_t batch_count;
  const FlatrayGlGradient* gradients;
  size_t gradient_count;
  const FlatrayGlStop* stops;
  size_t stop_count;
  float* rgba;  ///< out: width * height * 4, rows top-down, premultiplied
};

struct FlatrayGlInfo {
  char version[256];     ///< "OSMesa, Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"
  int32_t most_samples;  ///< 1 where there is no MSAA
};

/// A message for people, filled where a call fails.
struct FlatrayGlError {
  char text[256];
  int32_t out_of_memory;  ///< 1 where it failed because the module, not Mesa, lacks memory
};

struct FlatrayGlDevice;   ///< a loaded Mesa
struct FlatrayGlContext;  ///< used by one thread at a time

/// Calls that fail return null or 0.
struct FlatrayGlModule {
  uint32_t abi;
  /// `maker`: "osmesa" or "egl". `threads`: of Mesa's own for each picture; 0: the caller's only.
  FlatrayGlDevice* (*open)(const char* maker, unsigned threads, FlatrayGlError* error);
  void (*close)(FlatrayGlDevice* device);
  FlatrayGlContext* (*create)(FlatrayGlDevice* device, FlatrayGlInfo* info, FlatrayGlError* error);
  void (*destroy)(FlatrayGlContext* context);
  int (*draw)(FlatrayGlContext* context, const FlatrayGlTile* tile, FlatrayGlError* error);
};

/// The one entry: `extern "C" const FlatrayGlModule* flatray_gl_module(void)`.
#define FLATRAY_GL_ENTRY "flatray_gl_module"
}
