#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "all_meetings.h"
#include "anim/scenes.h"
#include "full_counts.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using Complex = std::complex<double>;

// A bar at the end of one to three arms that turn, one on the other, and a disc that flies.
struct Arms {
  struct Level {
    Complex at, velocity;
    double angle, spin;
  };
  std::vector<Level> levels;
  Complex bar_at;
  double bar_angle, bar_spin, half_length, half_width;
  Complex disc_at, disc_velocity;
  double radius, fps;
  unsigned frames;
};

Arms drawn(std::uint64_t item) {
  oracle::Draw draw(9, 77, item);
  const auto between = [&](double low, double high) { return low + (high - low) * draw.unit(); };
  const auto point = [&](double most) {
    const double x = between(-most, most), y = between(-most, most);
    return Complex(x, y);
  };
  Arms arms;
  const int count = 1 + static_cast<int>(draw.below(3));
  for (int i = 0; i < count; ++i) {
    const Complex at = point(i == 0 ? 1 : 5), velocity = i == 0 ? point(1) : Complex(0, 0);
    const double angle = between(-4, 4), spin = between(-9, 9);
    arms.levels.push_back({at, velocity, angle, spin});
  }
  arms.bar_at = point(5);
  arms.bar_angle = between(-4, 4);
  arms.bar_spin = draw.unit() < 0.5 ? 0 : between(-9, 9);
  arms.half_length = between(0.05, 1);
  arms.half_width = between(0.01, 0.2);
  arms.disc_at = point(9);
  arms.disc_velocity = draw.unit() < 0.5 ? Complex(0, 0) : point(2);
  arms.radius = between(0.05, 0.5);
  arms.fps = std::ldexp(0.5, static_cast<int>(draw.below(4)));
  arms.frames = 1 + static_cast<unsigned>(2 * arms.fps);
  return arms;
}

Vec2 vec(const Complex& z) { return {z.real(), z.imag()}; }

Scene scene_of_arms(const Arms& arms) {
  Scene scene = testing::small_scene();
  scene.fps = arms.fps;
  scene.frames = arms.frames;
  scene.shapes.push_back(
      testing::box({-arms.half_length, -arms.half_width}, {arms.half_length, arms.half_width}));
  scene.shapes.emplace_back().circles = {{{0, 0}, arms.radius}};
  for (const Arms::Level& level : arms.levels) {
    Group group;
    if (!scene.groups.empty()) group.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
    group.at = vec(level.at);
    group.velocity = vec(level.velocity);
    group.angle = level.angle;
    group.angular_velocity = level.spin;
    scene.groups.push_back(group);
  }
  Entity bar;
  bar.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
  bar.at = vec(arms.bar_at);
  bar.angle = arms.bar_angle;
  bar.angular_velocity = arms.bar_spin;
  scene.entities.push_back(bar);
  Entity disc;
  disc.shape = 1;
  disc.at = vec(arms.disc_at);
  disc.velocity = vec(arms.disc_velocity);
  scene.entities.push_back(disc);
  return scene;
}

// How far the disc is from the bar, less than 0 where they overlap: its centre seen from the bar.
double apart(const Arms& arms, double t) {
  Complex centre = arms.disc_at + t * arms.disc_velocity;
  for (const Arms::Level& level : arms.levels)
    centre =
        (centre - level.at - t * level.velocity) * std::polar(1.0, -level.angle - t * level.spin);
  centre = (centre - arms.bar_at) * std::polar(1.0, -arms.bar_angle - t * arms.bar_spin);
  const double x = std::fabs(centre.real()) - arms.half_length,
               y = std::fabs(centre.imag()) - arms.half_width;
  const double beside = x > 0 && y > 0 ? std::hypot(x, y) : std::max(x, y);
  return beside - arms.radius;
}

// No faster does the distance change.
double fastest(const Arms& arms) {
  double reach = std::abs(arms.bar_at) + 2, speed = std::abs(arms.disc_velocity);
  speed += std::fabs(arms.bar_spin) * 2;
  for (auto level = arms.levels.rbegin(); level != arms.levels.rend(); ++level) {
    speed += std::fabs(level->spin) * reach + std::abs(level->velocity);
    reach += std::abs(level->at);
  }
  return speed;
}

struct Truth {
  enum class Kind { apart, meets, unknown } kind;
  double first = 0;
};

// In steps of distance over speed, then bisection.
Truth truth_of(const Arms& arms) {
  constexpr double kClose = 1e-7;
  const double end = (arms.frames - 1) / arms.fps, speed = fastest(arms);
  if (apart(arms, 0) < 0) return {Truth::Kind::meets, 0};
  bool close = false;
  for (double t = 0; t < end;) {
    const double now = apart(arms, t);
    const double next = std::min(end, t + std::max(now, kClose) / speed);
    if (now < kClose) close = true;
    if (apart(arms, next) < 0) {
      double low = t, high = next;
      for (int i = 0; i < 60; ++i)
        (apart(arms, 0.5 * (low + high)) < 0 ? high : low) = 0.5 * (low + high);
      return {Truth::Kind::meets, high};
    }
    t = next;
  }
  return {close ? Truth::Kind::unknown : Truth::Kind::apart, 0};
}

// Goal R13: what arms carry is missed at no frame rate.
TEST(Arms, NoneIsMissedAtAnyFrameRate) {
  std::uint64_t missed = 0, invented = 0, outside = 0, undecided = 0, met = 0;
  const std::uint64_t count = times(1'000'000, 2000);
  for (std::uint64_t item = 0; item < count; ++item) {
    const Arms arms = drawn(item);
    const Scene scene = scene_of_arms(arms);
    const Truth truth = truth_of(arms);
    const std::vector<Meeting> found = meetings(scene);
    if (truth.kind == Truth::Kind::unknown) continue;
    const bool meets = truth.kind == Truth::Kind::meets;
    met += meets ? 1 : 0;
    if (found.empty()) {
      missed += meets ? 1 : 0;
      continue;
    }
    const MeetingPart& part = found[0].part;
    if (!part.certain) ++undecided;
    if (!meets && part.certain) ++invented;
    if (meets && !(part.times.low <= truth.first + 1e-12 &&
                   truth.first <= part.times.low + part.width + 1e-12))
      ++outside;
  }
  EXPECT_EQ(missed, 0U);
  EXPECT_EQ(invented, 0U);
  EXPECT_EQ(outside, 0U);
  EXPECT_EQ(undecided, 0U);
  EXPECT_GT(met, count / 8);
  RecordProperty("met", static_cast<int>(met));
  RecordProperty("missed", static_cast<int>(missed));
}

}  // namespace
}  // namespace flatray
