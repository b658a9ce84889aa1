#include "app/answers/paper_table.h"

#include <gtest/gtest.h>

#include "support/pictures.h"

namespace flatray {
namespace {

bool holds(const std::string& text, const char* what) {
  return text.find(what) != std::string::npos;
}

TEST(PaperTable, NamesWhatIsWrongInTableFiveAndTheHitTime) {
  const Scene scene = scene_of(
      "flatray = 1\n"
      "[[entity]]\nname = \"a\"\nshape = { box = { min = [250, 200], max = [314, 328] } }\n"
      "[[entity]]\nname = \"b\"\nshape = { box = { min = [885, 378], max = [949, 506] } }\n");
  const auto table = paper_tables(scene, {});
  ASSERT_TRUE(table);
  const std::string text = std::get<std::string>(table->text.front());
  EXPECT_TRUE(holds(text, "-49530 | -47580")) << text;
  EXPECT_TRUE(holds(text, "49530 | 52572"));
  EXPECT_TRUE(holds(text, "0 | -3042"));
  EXPECT_TRUE(holds(text, "t = 0.8992125984251969 = 571/635"));
  EXPECT_TRUE(holds(text, "4 of 4 sides of box 1 miss box 2, and 4 of 4"));
  const std::string json = json_text(table->results);
  EXPECT_TRUE(holds(json, R"("numer":-47580,"denom":-3042)")) << json;
  EXPECT_TRUE(holds(json, R"("t_first":0.8992125984251969)"));
}

TEST(PaperTable, IsOfThePapersBoxesAlone) {
  const Scene scene = scene_of(
      "flatray = 1\n[[entity]]\nname = \"a\"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n");
  ASSERT_FALSE(paper_tables(scene, {}));
  EXPECT_EQ(paper_tables(scene, {}).error()[0].trouble, Trouble::usage);
}

}  // namespace
}  // namespace flatray
