#include "render/coverage/composer.h"

#include <gtest/gtest.h>

#include "oracle/families.h"

namespace flatray {
namespace {

constexpr std::size_t kItems = 200;  // some words of bits

// Most are clear, and some opaque, light or on layers of three.
std::vector<DrawItem> mixed_items(oracle::Draw& draw, bool opaque) {
  const auto part = [&] { return static_cast<float>(draw.unit()); };
  std::vector<DrawItem> items;
  for (std::uint32_t i = 0; i < kItems; ++i) {
    DrawItem& item =
        items.emplace_back(DrawItem{FillRing{{0, 0}, 1}, {part(), part(), part(), 0.3F * part()}});
    item.opacity = part();
    if (i % 37 < 3)
      item.layer = 1 + i / 37;
    else if (draw.unit() < 0.02)
      item.light = std::make_shared<LightPicture>();
    else if (opaque && draw.unit() < 0.01)
      item.colour.a = 1;
  }
  return items;
}

// What is inside, one after the other, and those of a layer by themselves.
Light one_by_one(const SeenItems& seen) {
  Light light = seen.ground;
  for (std::size_t i = 0; i < kItems;) {
    SeenItems few;
    few.ground = light;
    const std::uint32_t layer = seen.items[i].look->layer;
    do few.items.push_back(seen.items[i]);
    while (++i < kItems && layer != 0 && seen.items[i].look->layer == layer);
    few.place_all();
    light = few.composed();
  }
  return light;
}

TEST(Composer, OfManyItemsIsThatOfOneByOne) {
  for (std::uint64_t item = 0; item < 50; ++item) {
    oracle::Draw draw(31, 0, item);
    const std::vector<DrawItem> items = mixed_items(draw, item % 2 == 0);
    const std::vector<ItemLook> looks(items.begin(), items.end());
    SeenItems seen;
    seen.ground = {0.1F, 0.2F, 0.3F, 1};
    for (const ItemLook& look : looks)
      seen.items.push_back({&look, draw.unit() < 0.7 ? 1 : 0, look.light});
    seen.place_all();
    EXPECT_EQ(seen.composed(), one_by_one(seen)) << item;
    for (std::size_t i = 0; i < kItems; ++i) seen.change(i, seen.items[i].winding == 0 ? 1 : -1);
    EXPECT_EQ(seen.composed(), one_by_one(seen)) << item;
  }
}

}  // namespace
}  // namespace flatray
