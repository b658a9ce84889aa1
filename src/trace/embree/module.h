#pragma once

/* What the tracer `embree` and its module flatray_embree.so say to each other: plain structs. */

#define FLATRAY_EMBREE_ABI 3
#define FLATRAY_EMBREE_ENTRY "flatray_embree_module"

struct FlatrayEmbreeScene;

struct FlatrayEmbreeBox {
  float low_x, low_y, high_x, high_y;
};

/* Ends ax, ay, bx, by of each segment; a box around each curve. */
struct FlatrayEmbreeWalls {
  const double* ends;
  unsigned segments;
  const FlatrayEmbreeBox* curves;
  unsigned curve_count;
};

struct FlatrayEmbreeRay {
  float ox, oy, dx, dy;
  unsigned departed; /* number of the segment not to be met */
};

struct FlatrayEmbreeHit {
  float t;
  unsigned wall; /* number of the segment or the curve; 0xffffffff: none */
  bool curve;
};

/* What is asked of a curve whose box a ray passes: Embree has no formula for it. */
struct FlatrayEmbreeAsker {
  /* Whether the ray meets the curve at less than *t; if so puts its t there. */
  bool (*meets)(void* asker, unsigned ray, unsigned curve, float* t);
  void* asker;
};

struct FlatrayEmbreeModule {
  int abi;
  const char* version;
  /* Null where Embree fails, and whether for lack of memory. */
  FlatrayEmbreeScene* (*build)(const FlatrayEmbreeWalls* walls, bool* out_of_memory);
  void (*release)(FlatrayEmbreeScene* scene);
  /* From any number of threads. */
  void (*nearest)(const FlatrayEmbreeScene* scene, const FlatrayEmbreeRay* rays, unsigned count,
                  const FlatrayEmbreeAsker* asker, FlatrayEmbreeHit* hits);
};
