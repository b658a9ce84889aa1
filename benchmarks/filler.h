#pragma once
#include <memory>
#include <string>
#include <vector>

#include "polygons.h"

namespace bench {

constexpr int kWidth = 1920, kHeight = 1080;

/// One way to fill polygons, in order and opaque, over white, into 8-bit pixels of its own.
class Filler {
 public:
  virtual ~Filler() = default;
  virtual std::string name() const = 0;
  /// From the polygons, or from the list of them the library draws from (collected when their
  /// number changes), to finished pixels: what is timed.
  virtual void fill(const std::vector<Polygon>& polygons) = 0;
  /// sRGB values, in [0, 255].
  virtual std::array<double, 3> pixel(int x, int y) const = 0;
};

using Fillers = std::vector<std::unique_ptr<Filler>>;

/// Appended by the libraries built in: peers/.
void add_cairo(Fillers& all);
void add_agg(Fillers& all);
void add_osmesa(Fillers& all);

}  // namespace bench
