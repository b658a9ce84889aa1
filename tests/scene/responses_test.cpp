// needs: shapes/box shapes/circle shapes/arc shapes/polygon
#include "scene/responses.h"

#include "scene_text.h"

namespace flatray {
namespace {

std::string responding(const std::string& collisions, const std::string& entity,
                       const std::string& more = "") {
  return "flatray = 1\n" + more + "[collisions]\n" + collisions +
         "\n[[entity]]\nname = \"a\"\nshape = { circle = { radius = 1 } }\n" + entity + "\n";
}

TEST(Responses, AnEntitySaysWhatItDoesOrElseTheScene) {
  const Scene own = loaded(responding("response = \"bounce\"", "response = \"stop\"")).scene;
  EXPECT_EQ(response_of(own, own.entities[0]), Response::stop);
  const Scene other = loaded(responding("response = \"bounce\"", "")).scene;
  EXPECT_EQ(response_of(other, other.entities[0]), Response::bounce);
  EXPECT_FALSE(responds(loaded(responding("", "")).scene));
  EXPECT_FALSE(responds(loaded(with_shape("circle = { radius = 1 }")).scene));
}

TEST(Responses, AMassIsANumberOrFixed) {
  EXPECT_EQ(loaded(responding("", "mass = 2.5")).scene.entities[0].mass, 2.5);
  EXPECT_EQ(loaded(responding("", "mass = \"fixed\"")).scene.entities[0].mass, kInfinity);
  EXPECT_FALSE(loaded(responding("", "")).scene.entities[0].mass);
}

TEST(Responses, WhatDoesNotKeepItsVelocityIsRefusedWhereItSaysSo) {
  const std::string bounce = "response = \"bounce\"";
  const Refused cases[] = {
      {responding(bounce, "angular_velocity = 10"), "t.toml:7:20: error: entity 'a' turns"},
      {responding(bounce, "angle = { keys = [[0, 0], [1, 90]] }"),
       "t.toml:7:9: error: entity 'a' turns"},
      {responding(bounce, "at = { keys = [[0, [0, 0]], [1, [2, 3]]] }"), "follows a curve"},
      {responding(bounce, "follow = { path = [[0, 0], [1, 0]], speed = 1 }"), "follows a path"},
      {responding(bounce, "group = \"g\"", "[[group]]\nname = \"g\"\nvelocity = [1, 0]\n"),
       "is in a group that moves"},
      {responding(bounce, "markov = { chain = \"c\" }\nstates = { A = { velocity = [1, 0] } }",
                  "markov.c = { A = { A = 1 } }\n"),
       "changes its shape or velocity by its states"},
      {"flatray = 1\ncollisions = { response = \"stop\" }\n[[entity]]\nshape = { arc = { radius = "
       "1, "
       "from = 0, to = 90 } }\n",
       "has curves other than circles and capsules"},
      {responding("response = \"bouncy\"", ""), "did you mean 'bounce'?"},
      {responding("respond = \"bounce\"", ""), "did you mean 'response'?"},
      {responding("most = 0", ""), "collisions.most"},
      {responding("shown = 0", ""), "collisions.shown is not above 0"},
      {responding("ghosts = { width = -1 }", ""), "ghosts.width is not above 0"},
      {responding("", "markov = { chain = \"c\", hit = \"B\" }", "markov.c = { A = { A = 1 } }\n"),
       "'B'"},
      {responding("", "markov = { chain = \"c\", hit = \"A\" }", "markov.c = { A = { A = 1 } }\n"),
       "so nothing hits it"},
      {responding("", "mass = 0"), "entity.mass is not above 0"},
      {responding("", "mass = \"heavy\""), "known: fixed"},
  };
  expect_refused(cases, [](const std::string& text) { return refusal(text); });
}

TEST(Responses, WhatMeetsNothingMayTurn) {
  EXPECT_EQ(
      refusal(responding("response = \"bounce\"", "angular_velocity = 10\nresponse = \"none\"")),
      "");
  EXPECT_EQ(refusal(responding("response = \"none\"", "angular_velocity = 10")), "");
}

TEST(Responses, GroupsThatStandStillAndLooksThatKeepTheOutlineAreNoHindrance) {
  EXPECT_EQ(refusal(responding("response = \"bounce\"", "group = \"g\"\nvelocity = [1, 0]",
                               "[[group]]\nname = \"g\"\nangle = 30\n")),
            "");
  EXPECT_EQ(
      refusal(responding("response = \"bounce\"",
                         "markov = { chain = \"c\" }\nstates = { A = { fill = \"#ff0000\" } }",
                         "markov.c = { A = { A = 1 } }\n")),
      "");
}

}  // namespace
}  // namespace flatray
