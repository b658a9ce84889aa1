#include "study/periodic/symmetry.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "study/periodic/numbered_words.h"
#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

constexpr double kAlike = 1e-9;

// What tells a wall from others.
struct Mark {
  bool straight, whole;
  double radius;
  Vec2 middle, ends[2];
};

Mark mark_of(const WallPlaces& places, const Mirror& mirror) {
  const double radius = mirror.arc ? mirror.arc->curve.u.x() : 0;
  if (mirror.arc && mirror.arc->extent == Arc::Extent::whole) {
    const Vec2 centre = mirror.arc->curve.centre;
    return {false, true, radius, centre, {centre, centre}};
  }
  const double length = places.length(mirror.surface);
  const auto at = [&](double part) { return places.point(mirror.surface, part * length); };
  return {!mirror.arc, false, radius, at(0.5), {at(0), at(1)}};
}

// About a middle: v -> (c v.x - s v.y, s v.x + c v.y), of v turned over where it is a reflection.
struct Turn {
  Vec2 about, by;
  bool over;

  Vec2 operator()(const Vec2& point) const {
    const Vec2 v = point - about;
    const double y = over ? -v.y() : v.y();
    return about + Vec2(by.x() * v.x() - by.y() * y, by.y() * v.x() + by.x() * y);
  }
};

bool is_taken(const Mark& one, const Mark& other, const Turn& turn, double reach) {
  const auto meet = [&](const Vec2& a, const Vec2& b) {
    return (turn(a) - b).cwiseAbs().maxCoeff() <= reach;
  };
  const auto ends = [&](int first) {
    return meet(one.ends[0], other.ends[first]) && meet(one.ends[1], other.ends[1 - first]);
  };
  return one.straight == other.straight && one.whole == other.whole &&
         std::fabs(one.radius - other.radius) <= reach && meet(one.middle, other.middle) &&
         (ends(0) || ends(1));
}

std::optional<Word> permutation(const std::vector<Mark>& marks, const Turn& turn, double reach) {
  Word to;
  for (const Mark& one : marks) {
    std::size_t k = 0;
    while (k < marks.size() && !is_taken(one, marks[k], turn, reach)) ++k;
    if (k == marks.size()) return std::nullopt;
    to.push_back(static_cast<std::uint8_t>(k));
  }
  return to;
}

Word turned_by(const Word& word, std::size_t places) {
  Word made = word;
  std::rotate(made.begin(), made.begin() + static_cast<std::ptrdiff_t>(places), made.end());
  return made;
}

// A part of a word, then what a symmetry makes of it, until it is where it began.
Word closed_by(const Word& part, const Symmetry& by) {
  Word whole = part, next = taken(part, by);
  while (next != part) {
    whole.insert(whole.end(), next.begin(), next.end());
    next = taken(next, by);
  }
  return whole;
}

}  // namespace

std::vector<Symmetry> symmetries(const MirrorRoom& room) {
  Word same(room.mirrors.size());
  std::iota(same.begin(), same.end(), std::uint8_t{0});
  std::vector<Symmetry> all{{same, false}};
  std::vector<Mark> marks;
  Vec2 about(0, 0);
  for (const Mirror& mirror : room.mirrors) {
    if (mirror.arc && !mirror.arc->curve.is_circle()) return all;
    marks.push_back(mark_of(room.room.places(), mirror));
    about += marks.back().middle / static_cast<double>(room.mirrors.size());
  }
  const auto far = [&](const Mark& mark) { return (mark.middle - about).squaredNorm(); };
  const auto first = std::ranges::max_element(marks, {}, far);
  if (first == marks.end() || far(*first) == 0) return all;
  const double size = far(*first), reach = kAlike * std::sqrt(size);
  const Vec2 from = first->middle - about;
  for (const Mark& mark : marks)
    for (const bool over : {false, true}) {
      const Vec2 to = mark.middle - about, start(from.x(), over ? -from.y() : from.y());
      const Turn turn{about, Vec2(start.dot(to), cross(start, to)) / size, over};
      auto found = permutation(marks, turn, reach);
      const bool still = &mark == &*first && !over;
      if (found && !still) all.push_back({std::move(*found), over});
    }
  return all;
}

bool are_told_apart(const std::vector<Symmetry>& all) {
  std::set<Word> seen;
  for (const Symmetry& one : all) seen.insert(one.to);
  return seen.size() == all.size();
}

Word taken(const Word& word, const Symmetry& by) {
  Word made;
  for (const std::uint8_t one : word) made.push_back(by.to[one]);
  return made;
}

Word least_turn(const Word& word) {
  Word least = word;
  for (std::size_t k = 1; k < word.size(); ++k) least = std::min(least, turned_by(word, k));
  return least;
}

std::size_t words_alike(const Word& word, const std::vector<Symmetry>& all) {
  std::set<Word> seen;
  for (const Symmetry& one : all) seen.insert(least_turn(taken(word, one)));
  return seen.size();
}

std::optional<std::vector<ReducedWord>> reduced_words(const std::vector<Symmetry>& all,
                                                      std::size_t mirrors, std::size_t symbols) {
  std::set<Word> seen;
  std::vector<ReducedWord> found;
  const NumberedWords parts(mirrors, symbols);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Word part = parts[i];
    for (const Symmetry& by : all) {
      if (by.to[part.front()] == part.back()) continue;
      const Word whole = closed_by(part, by);
      Word least = least_turn(whole);
      bool repeats = false;  // a shorter one
      for (auto other = all.begin(); other != all.end() && !repeats; ++other) {
        const Word image = taken(whole, *other);
        least = std::min(least, least_turn(image));
        if (other != all.begin() && image == whole) return std::nullopt;
        for (std::size_t k = 1; k < symbols; ++k) repeats = repeats || turned_by(whole, k) == image;
      }
      if (!repeats && seen.insert(std::move(least)).second)
        found.push_back({whole, symbols, whole.size() / symbols, by.turned});
    }
  }
  return found;
}

}  // namespace flatray
