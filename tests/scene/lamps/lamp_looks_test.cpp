// needs: lamps/point formats/toml
// The states of lamps as scenes have them.
#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string flickering(const std::string& keys, const std::string& own = "") {
  return with_lamp("source = { point = {} }\n" + own + "\nmarkov = { chain = 'c', start = 'B' }\n" +
                   keys) +
         "[markov.c]\nA = { B = 1 }\nB = { A = 1 }\n";
}

TEST(Lamps, HaveStatesThatKeepWhatTheyDoNotGive) {
  const Lamp lamp =
      loaded(flickering("states = { A = [{ nm = 500 }, { power = 3, velocity = [1, 0] "
                        "}] }",
                        "kelvin = 3000\npower = 2"))
          .scene.lamps.at(0);
  ASSERT_TRUE(lamp.markov);
  EXPECT_EQ(lamp.markov->start, 1U);
  ASSERT_EQ(lamp.markov->looks.at(0).size(), 2U);
  EXPECT_TRUE(lamp.markov->looks.at(1).empty());
  const Look &first = lamp.markov->looks[0][0], &second = lamp.markov->looks[0][1];
  EXPECT_EQ(first.light->wavelength->value, 500);
  EXPECT_FALSE(first.light->temperature);
  EXPECT_EQ(first.light->power.value, 2);
  EXPECT_FALSE(first.velocity);
  EXPECT_EQ(second.light->temperature->value, 3000);
  EXPECT_EQ(second.light->power.value, 3);
  EXPECT_EQ(second.velocity, Vec2(1, 0));
}

TEST(Lamps, SayWhatIsWrongWithTheirStates) {
  expect_problem(with_lamp("source = { point = {} }\nstates = { A = {} }"),
                 "lamp has states but no Markov chain");
  expect_problem(with_lamp("source = { point = {} }\nmarkov = { chain = 'x' }"),
                 "unknown Markov chain 'x'");
  expect_problem(flickering("states = { C = {} }"), "unknown state of chain 'c': 'C'");
  expect_problem(flickering("states = { A = { nm = 100 } }"),
                 "lamp state A.nm is 100, not 380 to 780");
  expect_problem(flickering("states = { A = { nm = 500, kelvin = 3000 } }"),
                 "a lamp has nm and kelvin");
  expect_problem(flickering("states = { A = { nm = 500, colour = '#ffffff' } }"),
                 "a lamp has colour and nm");
  expect_problem(flickering("states = { A = { fill = 'none' } }"), "unknown key 'fill'");
  expect_problem(flickering("states = 3"), "a table of states");
  const std::string hit =
      with_lamp("source = { point = {} }\nmarkov = { chain = 'c', hit = 'A' }") +
      "[markov.c]\nA = { A = 1 }\n";
  expect_problem(hit, "a lamp has a state for what is hit, but meets nothing");
  const auto warnings = [](const std::string& text) { return loaded(text).warnings.size(); };
  EXPECT_EQ(warnings(flickering("states = { A = { power = 1 } }", "power = 0")), 0U);
  EXPECT_EQ(warnings(flickering("states = { A = { colour = '#ffffff' } }", "power = 0")), 1U);
}

}  // namespace
}  // namespace flatray
