#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/query/query.h"
#include "base/json.h"

namespace flatray {
namespace {

std::string ask(const std::string& fields, const Precision& precision = {}) {
  return answer_line(R"({"op":"orbit",)" + fields + "}", precision).line;
}

// From a disc to its copy in the next cell to the right, and back to that it came from.
TEST(PeriodicCell, OrbitsGoOnFromTheOppositeWallAndSayInWhichCellTheyAre) {
  EXPECT_EQ(ask(R"("walls":[{"circle":{"center":[0,0],"radius":0.5}}],)"
                R"("cell":[[-1,-1],[1,-1],[1,1],[-1,1]],"origin":[0.75,0],"direction":[1,0],)"
                R"("bounces":3)"),
            R"({"walls":[0,0,0],"points":[[-0.5,0],[0.5,0],[-0.5,0]],"end":"limit","out":null,)"
            R"("cells":[[1,0],[0,0],[1,0]],"lattice":[[2,0],[0,2]],"certain":3})");
}

TEST(PeriodicCell, CellsMayHaveSixWalls) {
  EXPECT_EQ(ask(R"("walls":[{"circle":{"center":[0,0],"radius":0.5}}],)"
                R"("cell":[[2,0],[1,1.75],[-1,1.75],[-2,0],[-1,-1.75],[1,-1.75]],)"
                R"("origin":[0,1],"direction":[0,1],"bounces":1)"),
            R"({"walls":[0],"points":[[0,-0.5]],"end":"limit","out":null,"cells":[[1,0]],)"
            R"("lattice":[[0,3.5],[-3,1.75]],"certain":1})");
}

// Along the diagonal between two copies of a disc that is said in one corner.
TEST(PeriodicCell, ADiscAcrossTheWallsStandsInAllCornersAndHasOneNumber) {
  EXPECT_EQ(ask(R"("walls":[{"segment":[[0.9,1.9],[1.1,1.9]]},)"
                R"({"circle":{"center":[0,0],"radius":0.5}}],)"
                R"("cell":[[0,0],[2,0],[2,2],[0,2]],"origin":[1,1],"direction":[1,0.25],)"
                R"("bounces":0)"),
            R"({"walls":[],"points":[],"end":"limit","out":null,"cells":[],)"
            R"("lattice":[[2,0],[0,2]],"certain":0})");
  const std::string said =
      ask(R"("walls":[{"segment":[[0.9,1.9],[1.1,1.9]]},{"circle":{"center":[0,0],"radius":0.5}}],)"
          R"("cell":[[0,0],[2,0],[2,2],[0,2]],"origin":[1,1],"direction":[1,-1],"bounces":4)");
  EXPECT_NE(said.find(R"("walls":[1,1,1,1])"), std::string::npos) << said;
  EXPECT_NE(said.find(R"("cells":[[0,0],[0,0],[0,0],[0,0]])"), std::string::npos) << said;
}

double number(const JsonValue& value) { return value.as_number().value(); }
const Values& list(const JsonValue& value, const char* name) {
  return std::get<Values>(value.find(name)->data);
}

// The same orbit among discs all over the plane, each a wall of its own, without periodic walls.
TEST(PeriodicCell, AnOrbitIsThatOfThePlaneItsCellFills) {
  constexpr int kReach = 12;
  std::string discs;
  for (int a = -kReach; a <= kReach; ++a)
    for (int b = -kReach; b <= kReach; ++b)
      discs += fmt::format(R"({}{{"circle":{{"center":[{},{}],"radius":1}}}})",
                           discs.empty() ? "" : ",", 2.5 + 4 * a + b, 1.5 + 3 * b);
  const std::string ray = R"(,"origin":[2.5,0.2],"direction":[1,0.3],"bounces":8)";
  const auto plane = read_json(ask(R"("walls":[)" + discs + "]" + ray));
  const auto cell = read_json(ask(R"("walls":[{"circle":{"center":[2.5,1.5],"radius":1}}],)"
                                  R"("cell":[[0,0],[4,0],[5,3],[1,3]])" +
                                  ray));
  ASSERT_TRUE(plane && cell);
  ASSERT_EQ(list(*plane, "walls").size(), 8U);
  ASSERT_EQ(list(*cell, "walls").size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto wall = static_cast<int>(number(list(*plane, "walls")[i]));
    const int a = wall / (2 * kReach + 1) - kReach, b = wall % (2 * kReach + 1) - kReach;
    const Values& index = std::get<Values>(list(*cell, "cells")[i].data);
    EXPECT_EQ(number(index[0]), a) << i;
    EXPECT_EQ(number(index[1]), b) << i;
    const Values& there = std::get<Values>(list(*plane, "points")[i].data);
    const Values& here = std::get<Values>(list(*cell, "points")[i].data);
    // Discs part what rounding tells apart, by some ten times a bounce.
    EXPECT_NEAR(number(here[0]) + 4 * a + b, number(there[0]), 1e-6) << i;
    EXPECT_NEAR(number(here[1]) + 3 * b, number(there[1]), 1e-6) << i;
  }
  EXPECT_EQ(number(*cell->find("certain")), 8);
}

TEST(PeriodicCell, WhatIsNoCellAndWhatDoesNotStandInItIsRefusedByItsPlace) {
  const std::string square = R"("cell":[[0,0],[2,0],[2,2],[0,2]],)";
  const std::string ray = R"("origin":[1,1],"direction":[1,0],"bounces":1)";
  const auto disc = [](const std::string& centre, const char* radius) {
    return fmt::format(R"({{"circle":{{"center":{},"radius":{}}}}})", centre, radius);
  };
  const auto refused = [&](const std::string& cell, const std::string& walls,
                           const std::string& what) {
    const std::string said = ask(cell + R"("walls":[)" + walls + "]," + ray);
    EXPECT_NE(said.find(R"({"error":")" + what), std::string::npos) << said;
  };
  const std::string one = disc("[1,0.25]", "0.1");
  refused(R"("cell":[[0,2],[2,2],[2,0],[0,0]],)", one, "cell: is clockwise");
  refused(R"("cell":[[0,0],[1,0],[2,0],[2,2],[0,2],[0,1]],)", one, "cell: is flat");
  refused(R"("cell":[[0,0],[2,0],[2,2]],)", one, "cell: walls that are not a polygon of four");
  refused(R"("cell":[[0,0],[2,0],[2,2],[0,1]],)", one, "cell: walls of which opposite ones");
  refused(R"("cell":[[-1e308,0],[1e308,0],[1e308,2],[-1e308,2]],)", one,
          "cell: a cell that is wider than the largest double");
  refused(square, R"({"segment":[[1,0.5],[1,2.5]]})", "walls[0]: reaches out of the cell");
  refused(square, R"({"ellipse":{"center":[1.5,1],"u":[1,0],"v":[0,0.1]}})",
          "walls[0]: reaches out of the cell");
  refused(square, disc("[9,9]", "0.1"), "walls[0]: stands outside the cell");
  refused(square, disc("[0,0]", "3"), "walls[0]: reaches over more cells");
  refused(square, disc("[0,0]", "0.5") + "," + disc("[2,0]", "0.5"),
          "walls[1]: is walls[0] again, that of another cell: say it once");
  EXPECT_NE(ask(square + R"("walls":[],"origin":[3,1],"direction":[1,0],"bounces":1)")
                .find("origin: lies outside the cell"),
            std::string::npos);
}

}  // namespace
}  // namespace flatray
