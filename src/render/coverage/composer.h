#pragma once
#include <optional>
#include <span>
#include <vector>

#include "image/pixel_runs.h"
#include "render/gradient.h"

namespace flatray {

/// How an item of a band looks.
struct ItemLook {
  Light light;         ///< premultiplied; of one colour
  bool opaque;         ///< hides what lies below it
  bool adds;           ///< a film of light, which hides nothing
  bool varies;         ///< from pixel to pixel
  bool simple = true;  ///< its winding number is nowhere but one number and 0
  FillRule rule = FillRule::nonzero;
  std::uint32_t layer;
  const DrawItem* item;
  std::optional<GradientPainter> gradient;

  explicit ItemLook(const DrawItem& item);
  bool covers(int winding) const {
    return rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
  }
  /// Whether it is laid over what is below, alone.
  bool blends() const { return layer == 0 && !adds; }
  /// In one pixel.
  Light at(int x, int y, int film_width) const;
};

/// Light along rays or over areas.
struct SummedLight {
  std::array<double, 4> sum{};

  void add(double share, const Light& light) {
    for (std::size_t c = 0; c < 4; ++c) sum[c] += share * static_cast<double>(light[c]);
  }
  Light over(double all) const {
    Light mean;
    for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum[c] / all);
    return mean;
  }
};

/// An item of which a pixel may show something.
struct Seen {
  const ItemLook* look;
  int winding;
  Light light;  ///< in this pixel

  bool covered() const { return look->covers(winding); }
};

/// What a pixel may show, from the lowest item up, and which of the items are where one looks.
class SeenItems {
 public:
  std::vector<Seen> items;
  Light ground{};  ///< below them all

  /// Forgets all items.
  void begin(const Light& background) {
    items.clear();
    ground = background;
    has_part_ = on_whole_ = false;
  }
  /// Adds an item that covers a part of the pixel, above all others. Gives its number.
  std::uint32_t add_part(const ItemLook& look, const Light& light, int winding);
  /// Adds one that covers all of the pixel. Those that follow one another above a part are kept as one
  /// light; those with nothing else below them become part of the ground. Pixels without parts have
  /// the very light of other back ends.
  void add_whole(const ItemLook& look, const Light& light);
  /// After `items` are changed.
  void place_all();
  void set(std::size_t i, bool inside) {
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    inside_[i / 64] = inside ? inside_[i / 64] | bit : inside_[i / 64] & ~bit;
  }
  /// Adds to a winding number; whether what composed() gave may have changed.
  bool change(std::size_t i, int by) {
    const bool was = items[i].covered();
    items[i].winding += by;
    const bool is = items[i].covered();
    if (is == was) return false;
    set(i, is);
    return i >= lowest_;
  }
  /// The light of all that are inside, over the ground. Those of one layer are first laid on
  /// nothing, and then faded as one.
  Light composed();

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  /// Bits of the word of an item: of it and those above that are inside.
  std::uint64_t inside_from(std::size_t i) const {
    return inside_[i / 64] & (~std::uint64_t{0} << (i % 64));
  }
  std::size_t next_inside(std::size_t from) const;
  std::size_t uppermost_opaque() const;

  bool has_part_ = false;
  bool on_whole_ = false;  ///< the uppermost is a light of those that cover all
  std::vector<std::uint64_t> inside_, opaque_, plain_;
  std::size_t lowest_ = 0;  ///< that showed when composed() looked
};

}  // namespace flatray
