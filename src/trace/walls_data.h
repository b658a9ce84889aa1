#pragma once
#include "flatray/walls.h"
#include "trace/surfaces.h"

namespace flatray::api {

struct Walls::Data {
  Surfaces surfaces;
};

}  // namespace flatray::api
