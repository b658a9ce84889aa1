#include "app/query/query.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/philox.h"
#include "geom/clip.h"

namespace flatray {
namespace {

std::string answer(const std::string& question) { return answer_line(question).line; }

TEST(Query, ThePapersRayMeetsItsQuadrilateralFromNineteenSeventySecondsOn) {
  EXPECT_EQ(answer(R"({"id":"a","op":"clip","polygon":[[20,2],[16,10],[10,10],[5,5]],)"
                   R"("origin":[1,2],"direction":[22,10]})"),
            R"({"id":"a","class":"through","t_enter":0.2638888888888889,)"
            R"("t_exit":0.7037037037037037,"edge_enter":3,"edge_exit":0,"start":"outside"})");
}

TEST(Query, AWholeLineThroughADiscEndsNowhereByAnEdge) {
  EXPECT_EQ(answer(R"({"op":"clip","disc":{"center":[0,0],"radius":1},"origin":[-2,0],)"
                   R"("direction":[1,0],"domain":"line"})"),
            R"({"class":"through","t_enter":1,"t_exit":3,"edge_enter":null,"edge_exit":null,)"
            R"("start":"outside"})");
}

TEST(Query, APointTestOnTheWholeLineHasNoEnds) {
  EXPECT_EQ(answer(R"({"op":"clip","polygon":[[0,0],[2,0],[0,2]],"origin":[0,1],)"
                   R"("direction":[0,0],"domain":"line"})"),
            R"({"class":"touch","t_enter":null,"t_exit":null,"edge_enter":null,)"
            R"("edge_exit":null,"start":"boundary"})");
}

TEST(Query, ATimeBeyondTheDoublesIsTheLargestAndSaysSo) {
  const std::string line =
      answer(R"({"op":"clip","polygon":[[0,0],[1,0],[1,1],[0,1]],"origin":[-1e308,0.5],)"
             R"("direction":[1e-300,0]})");
  EXPECT_NE(line.find(R"("t_enter":1.7976931348623157e+308,)"), std::string::npos) << line;
  EXPECT_NE(line.find(R"("overflow":true)"), std::string::npos) << line;
}

// Walls met at the largest double, and at twice that: across, in an end, as an arc.
TEST(Query, ATimeThatIsTheLargestDoubleLiesNotBeyondIt) {
  for (const std::string wall :
       {R"({"segment":[[1.7976931348623157e308,-1],[1.7976931348623157e308,1]]})",
        R"({"segment":[[1.7976931348623157e308,0],[1.7976931348623157e308,1]]})",
        R"({"segment":[[1.7976931348623157e308,0],[1.797693134862315e308,0]]})",
        R"({"circle":{"center":[0,0],"radius":1.7976931348623157e308}})"})
    for (const bool beyond : {false, true}) {
      if (wall.find("315e308") != std::string::npos && !beyond) continue;
      const std::string line =
          answer(R"({"op":"nearest","walls":[)" + wall + R"(],"origin":[0,0],)" +
                 R"("direction":[)" + (beyond ? "0.5" : "1") + ",0]}");
      EXPECT_NE(line.find(R"("t":1.7976931348623157e+308,)"), std::string::npos) << line;
      EXPECT_EQ(line.find(R"("overflow":true)") != std::string::npos, beyond) << line;
    }
}

TEST(Query, TheFirstWallIsTheNearestAndTheLowestOfEqualOnes) {
  const std::string walls =
      R"("walls":[{"segment":[[0,0],[1,0]]},{"circle":{"center":[0.5,2],"radius":0.5}},)"
      R"({"segment":[[0,0],[1,0]]}])";
  EXPECT_EQ(answer(R"({"op":"nearest",)" + walls + R"(,"origin":[0.5,5],"direction":[0,-5]})"),
            R"({"wall":1,"t":0.5,"point":[0.5,2.5],"class":"through"})");
  EXPECT_EQ(answer(R"({"op":"nearest",)" + walls + R"(,"origin":[0.25,1],"direction":[0,-2]})"),
            R"({"wall":0,"t":0.5,"point":[0.25,0],"class":"touch"})");
  EXPECT_EQ(answer(R"({"op":"nearest",)" + walls + R"(,"origin":[5,5],"direction":[0,-2]})"),
            R"({"wall":null})");
}

TEST(Query, OfManyMistakesTwentyAreTold) {
  std::string fields, walls;
  for (int i = 0; i < 30; ++i) {
    fields += fmt::format(R"("k{}":0,)", i);
    walls += i == 0 ? "1" : ",1";
  }
  const auto told = [](const std::string& line, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = line.find(what, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const std::string unknown =
      answer("{" + fields + R"("op":"nearest","walls":[],"origin":[0,0],"direction":[1,0]})");
  EXPECT_EQ(told(unknown, "is not a field of this question"), 20U);
  EXPECT_NE(unknown.find("; and 10 mistakes more\"}"), std::string::npos) << unknown;
  const std::string wrong =
      answer(R"({"op":"nearest","walls":[)" + walls + R"(],"origin":[0,0],"direction":[1,0]})");
  EXPECT_EQ(told(wrong, "walls["), 20U);
  EXPECT_NE(wrong.find("; and 10 mistakes more\"}"), std::string::npos) << wrong;
}

TEST(Query, OfALongNameTheBeginningIsTold) {
  const std::string name(100'000, 'k');
  for (const std::string& line :
       {R"({"op":"nearest",")" + name + R"(":0})", R"({"op":")" + name + R"("})"}) {
    const std::string told = answer(line);
    EXPECT_NE(told.find(std::string(3000, 'k')), std::string::npos);
    EXPECT_LT(told.size(), 6000U);
  }
}

// An ellipse of half-diameters 3 and 2, and the parabola y = x^2.
TEST(Query, EllipsesAndBezierCurvesAreWalls) {
  const auto nearest = [](const std::string& wall, const std::string& ray) {
    return answer(R"({"op":"nearest","walls":[)" + wall + R"(],)" + ray + "}");
  };
  const std::string ellipse = R"({"ellipse":{"center":[1,0],"u":[3,0],"v":[0,2]}})";
  EXPECT_EQ(nearest(ellipse, R"("origin":[1,0],"direction":[0.5,0])"),
            R"({"wall":0,"t":6,"point":[4,0],"class":"through"})");
  EXPECT_EQ(
      nearest(R"({"bezier":[[-1,1],[0,-1],[1,1]]})", R"("origin":[0.5,1],"direction":[0,-1])"),
      R"({"wall":0,"t":0.75,"point":[0.5,0.25],"class":"through"})");
  // x y = 25
  const std::string conic = R"({"conic":{"points":[[2.5,10],[4,4],[10,2.5]],"weight":1.25}})";
  EXPECT_EQ(nearest(conic, R"("origin":[0,4],"direction":[1,0])"),
            R"({"wall":0,"t":6.25,"point":[6.25,4],"class":"through"})");
  for (const char* weight : {"1099511627776", "9.094947017729282e-13"})  // 2^40, 2^-40
    EXPECT_EQ(
        nearest(fmt::format(R"({{"conic":{{"points":[[0,0],[1,1],[2,0]],"weight":{}}}}})", weight),
                R"("origin":[5,9],"direction":[1,0])"),
        R"({"wall":null})");
  // From one focus of an ellipse to the other and back.
  const std::string orbit = answer(
      R"({"op":"orbit","walls":[{"ellipse":{"center":[0,0],"u":[5,0],"v":[0,4]}}],"origin":[-3,0],)"
      R"("direction":[3,4],"bounces":1})");
  EXPECT_NE(orbit.find(R"("end":"limit")"), std::string::npos) << orbit;
  const std::pair<const char*, const char*> cases[] = {
      {R"({"ellipse":{"center":[0,0],"u":[1,2],"v":[2,4]}})", "u and v that are parallel"},
      {R"({"ellipse":{"center":[0,0],"u":[1,2]}})", "needs a center and two half-diameters"},
      {R"({"bezier":[[0,0],[1,1]]})", "walls[0].bezier: is not a list of 3 or 4 control points"},
      {R"({"bezier":[[0,0],[1,1],[2,2]]})", "lies on a line: say a segment"},
      {R"({"bezier":[[0,0],[1e308,1e308],[-1e308,1e308],[1,0]]})", "reaches beyond 1e200"},
      {R"({"conic":{"points":[[0,0],[1,1]],"weight":2}})", "is not a list of 3 control points"},
      {R"({"conic":{"points":[[0,0],[1,1],[2,0]],"weight":0}})",
       "conic.weight: is not a number from 2^-40 to 2^40"},
      {R"({"conic":{"points":[[0,0],[1,1],[2,0]],"weight":9.0949470177292e-13}})",
       "conic.weight: is not a number from"},
      {R"({"conic":{"points":[[0,0],[1,1],[2,0],[3,0]],"weight":2}})", "3 control points"},
      {R"({"conic":{"points":[[0,0],[1,1],[2,0]],"weight":1099511627777}})",
       "conic.weight: is not a number from"},
      {R"({"conic":{"points":[[0,0],[1,1],[2,0]]}})", "needs 3 points and a weight"},
      {R"({"bezier":[[0,0],[1,1],[2,0]],"circle":{"center":[0,0],"radius":1}})", "one of them"}};
  for (const auto& [wall, message] : cases) {
    const std::string said = nearest(wall, R"("origin":[0,0],"direction":[1,0])");
    EXPECT_NE(said.find(message), std::string::npos) << said;
  }
}

TEST(Query, ThePapersBoxesMeetAt571Of635) {
  EXPECT_EQ(answer(R"({"op":"contact","a":{"polygon":[[250,200],[314,200],[314,328],[250,328]],)"
                   R"("velocity":[635,178]},"b":{"polygon":[[885,378],[949,378],[949,506],)"
                   R"([885,506]],"velocity":[0,0]}})"),
            R"({"class":"through","t_first":0.8992125984251969,"t_last":1.1007874015748031,)"
            R"("start":"apart"})");
}

// A hand of length 2 that turns down by 60 degrees meets a shelf 1 below with its tip, half way.
TEST(Query, WhatTurnsMeetsInAnIntervalThatIsProven) {
  const std::string ask = R"({"op":"contact","b":{"polygon":[[1,-1],[1,-9],[9,-9],[9,-1]],)"
                          R"("velocity":[0,0]},"a":{"polygon":[[0,0],[2,0]],"velocity":[0,0],)";
  const std::string met = answer(ask + R"("spin":-60},"domain":"unit"})");
  EXPECT_EQ(met.find(R"({"class":"through","t_first":[0.4999999999)"), 0U) << met;
  EXPECT_NE(met.find(R"(,1],"start":"apart"})"), std::string::npos) << met;
  EXPECT_EQ(answer(ask + R"("spin":60},"domain":"unit"})"),
            R"({"class":"miss","t_first":null,"t_last":null,"start":"apart"})");
  EXPECT_EQ(answer(ask + R"("spin":60}})"),
            R"({"error":"domain: where something turns it must be \"unit\""})");
}

// As seen from the pivot, rounded, the ring turns to the right at one of its corners.
TEST(Query, WhatTurnsAboutAPointFarAwayIsConvexStill) {
  const std::string ask =
      R"({"op":"contact","domain":"unit","b":{"disc":{"center":[0.35,0.4],"radius":0.1},)"
      R"("velocity":[0,0]},"a":{"polygon":[[0,0],[0.7500000000000625,5.684341886080802e-15],)"
      R"([0.7500000000000512,5.1159076974727215e-14],[0.3,1]],"velocity":[0,0],"spin":1,)";
  for (const char* about : {"[1024,1024]", "[0,0]", "[-99,7]"})
    EXPECT_EQ(
        answer(ask + R"("about":)" + about + "}}").find(R"({"class":"through","t_first":[0,0])"),
        0U)
        << about << answer(ask + R"("about":)" + about + "}}");
}

TEST(Query, ContactWithoutRelativeMotionHasNoEndsAndAMissNoTimes) {
  const std::string square = R"("polygon":[[0,0],[1,0],[1,1],[0,1]],"velocity":[1,2]})";
  const std::string ask = R"({"op":"contact","domain":"always","a":{)" + square;
  EXPECT_EQ(answer(ask + R"(,"b":{)" + square + "}"),
            R"({"class":"through","t_first":null,"t_last":null,"start":"overlapping"})");
  EXPECT_EQ(answer(ask + R"(,"b":{"polygon":[[5,5]],"velocity":[1,2]}})"),
            R"({"class":"miss","t_first":null,"t_last":null,"start":"apart"})");
  EXPECT_EQ(
      answer(R"({"op":"contact","a":{"polygon":[[0,0]]},"b":{)" + square + R"(,"domain":"ray"})"),
      R"({"error":"a: needs a velocity, and a polygon or a disc; domain: is none of always, future, )"
      R"(unit"})");
}

TEST(Query, ArcsAreWalls) {
  const std::string half =
      R"("walls":[{"arc":{"center":[0,0],"radius":5,"towards":[0,1]}}],"origin":[0,0],)";
  EXPECT_EQ(answer(R"({"op":"nearest",)" + half + R"("direction":[0,2]})"),
            R"({"wall":0,"t":2.5,"point":[0,5],"class":"through"})");
  EXPECT_EQ(answer(R"({"op":"nearest",)" + half + R"("direction":[0,-2]})"), R"({"wall":null})");
  const std::string quarter =
      R"("walls":[{"arc":{"center":[1,1],"radius":2,"from":270,"to":0}}],"origin":[1,1],)";
  EXPECT_EQ(answer(R"({"op":"nearest",)" + quarter + R"("direction":[1,0]})"),
            R"({"wall":0,"t":2,"point":[3,1],"class":"through"})");
  EXPECT_EQ(answer(R"({"op":"nearest",)" + quarter + R"("direction":[-1,0]})"), R"({"wall":null})");
}

// Back and forth between the ends of a stadium, in doubles and for certain.
TEST(Query, OrbitsAreFollowedBetweenArcs) {
  const std::string stadium =
      R"("walls":[{"segment":[[-1,-1],[1,-1]]},{"arc":{"center":[1,0],"radius":1,"towards":[1,0]}},)"
      R"({"segment":[[1,1],[-1,1]]},{"arc":{"center":[-1,0],"radius":1,"from":90,"to":270}}])";
  const std::string question =
      R"({"op":"orbit",)" + stadium + R"(,"origin":[0.25,0.125],"direction":[1,0.5],"bounces":12})";
  const auto walls = [](const std::string& line) { return line.substr(0, line.find("points")); };
  const std::string in_doubles = answer(question);
  const Answer certain = answer_line(question, {true, 4096});
  EXPECT_NE(certain.line.find(R"("certain":12)"), std::string::npos) << certain.line;
  EXPECT_EQ(walls(certain.line), walls(in_doubles));
  EXPECT_NE(
      answer(R"({"op":"orbit",)" + stadium + R"(,"origin":[0,0],"direction":[1,1],"bounces":3})")
          .find(R"("end":"corner","out":null,"corner":[1,1],"corner_walls":[1,2])"),
      std::string::npos);
}

TEST(Query, ArcsThatAreNoneAreRefused) {
  const auto refused = [](const std::string& arc) {
    return answer(R"({"op":"nearest","walls":[{"arc":)" + arc +
                  R"(}],"origin":[0,0],"direction":[1,0]})");
  };
  const std::pair<const char*, const char*> cases[] = {
      {R"({"center":[0,0],"radius":1})", "walls[0].arc.from: is not a number of degrees"},
      {R"({"center":[0,0],"radius":1,"towards":[0,0]})", "walls[0].arc.towards: is zero"},
      {R"({"center":[0,0],"radius":1,"from":0,"to":361})", "do not span part of a turn"},
      {R"({"center":[0,0],"radius":-1,"towards":[1,0]})", "radius: is not a number of 0 or more"},
      {R"({"center":[0,0],"radius":1,"towards":[1,0],"to":9})", "not both"},
      {R"({"center":[1,0],"radius":1e-30,"from":0,"to":9})", "do not tell their directions apart"},
      {R"({"center":[1e9,0],"radius":1,"from":89.999999,"to":90})", "directions apart"},
  };
  for (const auto& [arc, message] : cases)
    EXPECT_NE(refused(arc).find(message), std::string::npos) << refused(arc);
  EXPECT_EQ(refused(R"({"center":[0,0],"radius":1,"towards":5})"),
            R"({"error":"walls[0].arc.towards: is not a point: say [x, y]"})");
}

// Its doubles are off the circle: a ray from the centre to one of them has the other behind it.
TEST(Query, OfTheEndsOfAnArcTheOneAheadIsMet) {
  EXPECT_EQ(answer(R"({"op":"nearest","walls":[{"arc":{"center":[-2,0],"radius":0.2,"from":0,)"
                   R"("to":180}}],"origin":[-2,0],"direction":[1,0]})"),
            R"({"wall":0,"t":0.19999999999999996,"point":[-1.8,0],"class":"touch"})");
}

// From (1e16, 0.866) to (1e16, 1), on the line to the centre.
TEST(Query, ARayThatStartsOnWhatJoinsAnArcToItsEndIsThereAtOnce) {
  for (const char* direction : {"[0,0]", "[1,0]", "[0,1]", "[0,-1]"})
    EXPECT_EQ(
        answer(std::string(
                   R"({"op":"nearest","walls":[{"arc":{"center":[1e16,0],"radius":1,"from":60,)") +
               R"("to":200}}],"origin":[1e16,0.95],"direction":)" + direction + "}"),
        R"({"wall":0,"t":0,"point":[1e+16,0.95],"class":"touch"})")
        << direction;
}

TEST(Query, APointBeyondTheDoublesIsTheLast) {
  const std::string met =
      answer(R"({"op":"nearest","walls":[{"circle":{"center":[1.7e308,0],"radius":1.7e308}}],)"
             R"("origin":[1.7e308,1e307],"direction":[1,0]})");
  EXPECT_NE(met.find(R"("point":[1.7976931348623157e+308,1e+307])"), std::string::npos) << met;
}

TEST(Query, ATangentTouchesAtTheFootOfThePerpendicular) {
  EXPECT_EQ(answer(R"({"op":"nearest","walls":[{"circle":{"center":[0.5,2],"radius":0.5}}],)"
                   R"("origin":[1,5],"direction":[0,-2]})"),
            R"({"wall":0,"t":1.5,"point":[1,2],"class":"touch"})");
}

TEST(Query, ARayAlongAWallMeetsItsFirstEndAhead) {
  EXPECT_EQ(answer(R"({"op":"nearest","walls":[{"segment":[[4,0],[2,0]]}],)"
                   R"("origin":[0,0],"direction":[1,0]})"),
            R"({"wall":0,"t":2,"point":[2,0],"class":"along"})");
}

TEST(Query, AnOrbitNamesItsWallsItsEndAndHowManyBouncesAreProven) {
  const std::string room =
      R"("walls":[{"segment":[[0,0],[2,0]]},{"segment":[[2,0],[2,2]]},{"segment":[[2,2],[0,2]]}])";
  EXPECT_EQ(
      answer(R"({"op":"orbit",)" + room + R"(,"origin":[1,1],"direction":[1,1],"bounces":5})"),
      R"({"walls":[],"points":[],"end":"corner","out":null,"corner":[2,2],)"
      R"("corner_walls":[1,2],"certain":0})");
  EXPECT_EQ(
      answer(R"({"op":"orbit",)" + room + R"(,"origin":[1,0.5],"direction":[1,1],"bounces":5})"),
      R"({"walls":[1,2],"points":[[2,1.5],[1.5,2]],"end":"escape",)"
      R"("out":[-0.7071067811865475,-0.7071067811865475],"certain":2})");
  EXPECT_EQ(
      answer(R"({"op":"orbit",)" + room + R"(,"origin":[1,0.5],"direction":[0,0],"bounces":1})"),
      R"({"error":"direction: is zero: an orbit needs somewhere to go"})");
}

TEST(Query, AllMistakesOfAQuestionAreNamedWithTheirPlaces) {
  const Answer said =
      answer_line(R"({"id":7,"op":"clip","polygon":[[0,0],[2,0],[1,0.1],[2,2],[0,2]],)"
                  R"("origin":[1],"directoin":[1,0],"domain":"lin"})");
  EXPECT_FALSE(said.ok);
  for (const char* part :
       {R"("id":7)", "origin: is not a point", "direction: is missing", "domain: is none of",
        "polygon[2]: the polygon is not convex", "directoin", "(did you mean 'direction'?)"})
    EXPECT_NE(said.line.find(part), std::string::npos) << part << "\n" << said.line;
}

TEST(Query, WhatIsNoQuestionGetsAnErrorAndNothingElse) {
  for (const std::string text :
       {"", " ", "[1,2]", "{", "nonsense", R"({"op":"clap"})", R"({"op":1})", R"({"id":1})",
        R"({"op":"nearest","walls":{},"origin":[0,0],"direction":[1,1e400]})",
        R"({"op":"nearest","walls":[{"circle":{"center":[0,0],"radius":-1}}],"origin":[0,0],)"
        R"("direction":[1,0]})",
        R"({"op":"nearest","walls":[{"circle":{"center":[0,0],"radius":1,"raduis":2}}],)"
        R"("origin":[0,0],"direction":[1,0]})",
        R"({"op":"nearest","walls":[{"circle":{"center":[0,0],"radius":1},)"
        R"("segment":[[0,0],[1,1]]}],"origin":[0,0],"direction":[1,0]})"}) {
    const Answer said = answer_line(text);
    EXPECT_FALSE(said.ok) << text;
    EXPECT_NE(said.line.find(R"("error":)"), std::string::npos) << text;
    EXPECT_TRUE(parse_json(said.line)) << said.line;
  }
  EXPECT_FALSE(answer_line(std::string(1'000'000, '[')).ok);
}

// The protocol adds nothing and loses nothing: every double goes through text and back.
TEST(Query, AnswersAreThoseOfClipConvexToTheLastBit) {
  const auto draw = [&](std::uint32_t item, std::uint32_t i) {
    return unit_double(random_bits(5, Stream::test, 0, item, i)) * 4 - 2;
  };
  const std::vector<Vec2> corners = {{0, 0}, {1, 0.1}, {1.25, 1}, {0.1, 1.5}};
  for (std::uint32_t item = 0; item < 500; ++item) {
    const Ray ray{{draw(item, 0), draw(item, 1)}, {draw(item, 2), draw(item, 3)}};
    const auto said = parse_json(answer(fmt::format(
        R"({{"op":"clip","polygon":[[0,0],[1,0.1],[1.25,1],[0.1,1.5]],"origin":[{},{}],)"
        R"("direction":[{},{}]}})",
        ray.origin.x(), ray.origin.y(), ray.direction.x(), ray.direction.y())));
    ASSERT_TRUE(said);
    const HitInterval hit = clip_convex(ray, corners);
    EXPECT_EQ(said->find("class")->as_text(), name(hit.kind));
    const JsonValue t_exit = hit ? JsonValue(hit.t_exit) : JsonValue();
    EXPECT_EQ(json_text(*said->find("t_exit")), json_text(t_exit));
  }
}

}  // namespace
}  // namespace flatray
