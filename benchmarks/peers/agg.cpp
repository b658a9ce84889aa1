#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_p.h>

#include "filler.h"

namespace bench {
namespace {

class Agg : public Filler {
 public:
  Agg() : pixels_(4ULL * kWidth * kHeight), buffer_(pixels_.data(), kWidth, kHeight, 4 * kWidth) {}

  std::string name() const override { return "AGG, AA"; }

  void fill(const std::vector<Polygon>& polygons) override {
    agg::pixfmt_rgba32 format(buffer_);
    agg::renderer_base<agg::pixfmt_rgba32> base(format);
    base.clear(agg::rgba8(255, 255, 255));
    rasterizer_.clip_box(0, 0, kWidth, kHeight);
    for (const Polygon& polygon : polygons) {
      rasterizer_.reset();
      const auto& corners = polygon.corners;
      rasterizer_.move_to_d(corners[0].x(), corners[0].y());
      for (std::size_t i = 1; i < corners.size(); ++i)
        rasterizer_.line_to_d(corners[i].x(), corners[i].y());
      const auto& [r, g, b] = polygon.colour;
      agg::render_scanlines_aa_solid(rasterizer_, scanline_, base, agg::rgba8(r, g, b));
    }
  }

  std::array<double, 3> pixel(int x, int y) const override {
    const unsigned char* at = &pixels_[4ULL * (static_cast<unsigned>(y) * kWidth) + 4U * x];
    return {1.0 * at[0], 1.0 * at[1], 1.0 * at[2]};
  }

 private:
  std::vector<unsigned char> pixels_;
  agg::rendering_buffer buffer_;
  agg::rasterizer_scanline_aa<> rasterizer_;
  agg::scanline_p8 scanline_;
};

}  // namespace

void add_agg(Fillers& all) { all.push_back(std::make_unique<Agg>()); }

}  // namespace bench
