// S12: when two moving convex polygons first meet. Nanoseconds a pair, polygons of 3 to 8 vertices and axis-parallel boxes, translation only;
// answers are compared with exact rationals before the clock starts.
#include <fmt/core.h>

#include <cmath>

#include "base/philox.h"
#include "collide/contact_batch.h"
#include "geom/polygon.h"
#include "measure.h"
#include "oracle/contact.h"

#ifdef BENCH_BOX2D
#include "peers/box2d.h"
#endif

namespace {

using namespace flatray;

struct Body {
  std::vector<Vec2> vertices;
  Vec2 velocity;
};
struct BodyPair {
  Body a, b;
};

// Coordinates are floats, so that all contenders are asked the same.
double draw(std::uint64_t item, std::uint32_t k, double low, double high) {
  const double x = low + (high - low) * unit_double(random_bits(1, Stream::test, 12, item, k));
  return static_cast<double>(static_cast<float>(x));
}

Vec2 in_floats(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

Body box(std::uint64_t item, std::uint32_t k) {
  const Vec2 low(draw(item, k, -5, 4), draw(item, k + 1, -5, 4));
  const Vec2 high =
      in_floats(low.x() + draw(item, k + 2, 0.5, 2), low.y() + draw(item, k + 5, 0.5, 2));
  return {{low, {high.x(), low.y()}, high, {low.x(), high.y()}},
          {draw(item, k + 3, -6, 6), draw(item, k + 4, -6, 6)}};
}

Body polygon(std::uint64_t item, std::uint32_t k) {
  const Vec2 centre(draw(item, k, -4, 4), draw(item, k + 1, -4, 4));
  const auto count = static_cast<std::size_t>(draw(item, k + 2, 3, 8.99));
  for (std::uint32_t attempt = 0;; ++attempt) {
    Body made{{}, {draw(item, k + 3, -6, 6), draw(item, k + 4, -6, 6)}};
    const double turn = draw(item, k + 5 + attempt, 0, 6.28);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle =
          turn + 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
      made.vertices.push_back(
          in_floats(centre.x() + std::cos(angle), centre.y() + std::sin(angle)));
    }
    if (!non_convex_vertex(made.vertices)) return made;
  }
}

// First times in [0, 1]; above 1 for none.
double first_time(const BodyPair& pair) {
  const HitInterval met =
      contact({pair.a.vertices, pair.a.velocity}, {pair.b.vertices, pair.b.velocity}, kSegment)
          .times;
  return met ? met.t_enter : 2;
}

double exact_time(const BodyPair& pair) {
  const auto truth = oracle::contact_truth({pair.a.vertices, pair.a.velocity},
                                           {pair.b.vertices, pair.b.velocity}, kSegment);
  return truth.kind == HitClass::miss ? 2 : truth.first->nearest();
}

// The same by shapes made ready beforehand.
class Batch {
 public:
  explicit Batch(const std::vector<BodyPair>& pairs) : contacts_(pairs.size()) {
    for (const BodyPair& pair : pairs) {
      const std::uint32_t a = shapes_.add(pair.a.vertices), b = shapes_.add(pair.b.vertices);
      pairs_.push_back({a, b, pair.a.velocity, pair.b.velocity});
    }
  }
  std::span<const Contact> run() const {
    contacts(shapes_, pairs_, kSegment, contacts_);
    return contacts_;
  }
  // How many are not what contact() gives.
  int different_from(const std::vector<BodyPair>& pairs) const {
    run();
    int count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Body &a = pairs[i].a, &b = pairs[i].b;
      const Contact one = contact({a.vertices, a.velocity}, {b.vertices, b.velocity}, kSegment);
      count += contacts_[i] == one ? 0 : 1;
    }
    return count;
  }

 private:
  BodySet shapes_;
  std::vector<MovingPair> pairs_;
  mutable std::vector<Contact> contacts_;
};

struct Verdicts {
  int wrong = 0, hits = 0;
  double worst = 0;

  void add(double t, double truth) {
    if ((t > 1) != (truth > 1)) {
      ++wrong;
      return;
    }
    if (truth > 1) return;
    ++hits;
    worst = std::max(worst, std::fabs(t - truth));
  }
};

// One by one as before, many a call, and by others; whether all of ours is right.
bool report(const char* what, const std::vector<BodyPair>& pairs) {
  std::vector<double> truth;
  for (const BodyPair& pair : pairs) truth.push_back(exact_time(pair));
  const auto judged = [&](const auto& time) {
    Verdicts verdicts;
    for (std::size_t i = 0; i < pairs.size(); ++i) verdicts.add(time(i), truth[i]);
    return verdicts;
  };
  const Verdicts own = judged([&](std::size_t i) { return first_time(pairs[i]); });
  const Batch batch(pairs);
  const int different = batch.different_from(pairs);
  double sum = 0;
  std::vector<bench::Contender> contenders = {
      {"flatray, many pairs a call", [&] { sum += batch.run()[0].times.t_enter; }},
      {"flatray, one pair a call", [&] {
         for (const BodyPair& pair : pairs) sum += first_time(pair);
       }}};
  std::vector<Verdicts> verdicts = {own, own};
#ifdef BENCH_BOX2D
  const bench::Box2dPairs box2d = [&] {
    bench::Box2dPairs made;
    for (const BodyPair& pair : pairs)
      made.add(pair.a.vertices, pair.a.velocity, pair.b.vertices, pair.b.velocity);
    return made;
  }();
  verdicts.push_back(judged([&](std::size_t i) { return box2d.first_time(i); }));
  contenders.push_back({"Box2D, b2TimeOfImpact", [&] {
                          for (std::size_t i = 0; i < pairs.size(); ++i) sum += box2d.first_time(i);
                        }});
#endif
  const std::vector<double> times = bench::compare(contenders, 9);
  fmt::print("S12, {}: {} pairs, {} meet within t = 1; {} not the same one by one and together\n",
             what, pairs.size(), own.hits, different);
  fmt::print(
      "| who                        | ns a pair | wrong | worst error of t |\n|---|---|---|---|\n");
  for (std::size_t i = 0; i < contenders.size(); ++i)
    fmt::print("| {:<26} | {:>9.1f} | {:>5} | {:>16.1e} |\n", contenders[i].name,
               times[i] / static_cast<double>(pairs.size()) * 1e9, verdicts[i].wrong,
               verdicts[i].worst);
  if (times.size() > 2)
    fmt::print("ratio {:.2f} (must 13, aim 27){}\n", times[2] / times[0],
               std::isnan(sum) ? " " : "");
  return own.wrong + different == 0;
}

}  // namespace

int main() {
  std::vector<BodyPair> polygons, boxes;
  for (std::uint64_t item = 0; item < 2048; ++item) {
    polygons.push_back({polygon(item, 0), polygon(item, 20)});
    boxes.push_back({box(item, 0), box(item, 20)});
  }
  const bool right = report("polygons", polygons);
  return report("boxes", boxes) && right ? 0 : 1;
}
