#pragma once

/* What the tracer `embree` and its module flatray_embree.so say to each other: plain structs. */

#define FLATRAY_EMBREE_ABI 2
#define FLATRAY_EMBREE_ENTRY "flatray_embree_module"

struct FlatrayEmbreeScene;

struct FlatrayEmbreeRay {
  float ox, oy, dx, dy;
  unsigned left; /* number of the segment not to be met */
};

struct FlatrayEmbreeHit {
  float t;
  unsigned segment; /* 0xffffffff: none */
};

struct FlatrayEmbreeModule {
  int abi;
  const char* version;
  /* From ax, ay, bx, by of each segment; null where Embree fails, and whether for lack of memory. */
  FlatrayEmbreeScene* (*build)(const double* ends, unsigned count, bool* out_of_memory);
  void (*release)(FlatrayEmbreeScene* scene);
  /* From any number of threads. */
  void (*nearest)(const FlatrayEmbreeScene* scene, const FlatrayEmbreeRay* rays, unsigned count,
                  FlatrayEmbreeHit* hits);
};

using FlatrayEmbreeEntry = const FlatrayEmbreeModule* (*)();
