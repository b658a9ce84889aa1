#include <cairo.h>

#include "filler.h"

namespace bench {
namespace {

class Cairo : public Filler {
 public:
  Cairo(const char* name, cairo_antialias_t antialias)
      : name_(name),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, kWidth, kHeight)),
        context_(cairo_create(surface_)) {
    cairo_set_antialias(context_, antialias);
  }
  ~Cairo() override {
    cairo_destroy(context_);
    cairo_surface_destroy(surface_);
  }
  Cairo(const Cairo&) = delete;
  Cairo& operator=(const Cairo&) = delete;

  std::string name() const override { return name_; }

  void fill(const std::vector<Polygon>& polygons) override {
    cairo_set_source_rgb(context_, 1, 1, 1);
    cairo_paint(context_);
    for (const Polygon& polygon : polygons) {
      for (const auto& corner : polygon.corners) cairo_line_to(context_, corner.x(), corner.y());
      const auto& [r, g, b] = polygon.colour;
      cairo_set_source_rgb(context_, r / 255.0, g / 255.0, b / 255.0);
      cairo_fill(context_);
    }
    cairo_surface_flush(surface_);
  }

  std::array<double, 3> pixel(int x, int y) const override {
    const unsigned char* at =
        cairo_image_surface_get_data(surface_) + y * cairo_image_surface_get_stride(surface_);
    return {1.0 * at[4 * x + 2], 1.0 * at[4 * x + 1], 1.0 * at[4 * x]};
  }

 private:
  const char* name_;
  cairo_surface_t* surface_;
  cairo_t* context_;
};

}  // namespace

void add_cairo(Fillers& all) {
  all.push_back(std::make_unique<Cairo>("Cairo, no AA", CAIRO_ANTIALIAS_NONE));
  all.push_back(std::make_unique<Cairo>("Cairo, AA", CAIRO_ANTIALIAS_DEFAULT));
}

}  // namespace bench
