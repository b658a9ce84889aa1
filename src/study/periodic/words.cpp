#include "study/periodic/words.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/counted.h"
#include "study/statistics/blocks.h"

namespace flatray {
namespace {

constexpr std::size_t kMostWords = 200'000;

// Necklaces in ascending order. Source: F. Ruskey and J. Sawada (1999), after Fredricksen, Kessler
// and Maiorana.
class Necklaces {
 public:
  Necklaces(const std::vector<Mirror>& mirrors, std::size_t length, std::size_t most)
      : mirrors_(mirrors), most_(most), letters_(length + 1) {}

  std::optional<std::vector<Word>> all() {
    extend(1, 1);
    if (found_.size() > most_) return std::nullopt;
    return std::move(found_);
  }

 private:
  bool may_follow(std::uint8_t one, std::uint8_t next) const {
    return one != next || mirrors_[one].may_repeat();
  }

  void extend(std::size_t at, std::size_t period) {
    if (found_.size() > most_) return;
    const std::size_t length = letters_.size() - 1;
    if (at > length) {
      if (length % period == 0 && is_wanted(period))
        found_.emplace_back(letters_.begin() + 1, letters_.end());
      return;
    }
    for (std::size_t letter = letters_[at - period]; letter < mirrors_.size(); ++letter) {
      letters_[at] = static_cast<std::uint8_t>(letter);
      if (at > 1 && !may_follow(letters_[at - 1], letters_[at])) continue;
      extend(at + 1, letters_[at] == letters_[at - period] ? period : at);
    }
  }

  bool is_wanted(std::size_t period) const {
    const std::size_t length = letters_.size() - 1;
    const auto any = [&](auto is) {
      return std::any_of(letters_.begin() + 1, letters_.end(),
                         [&](std::uint8_t one) { return is(mirrors_[one]); });
    };
    const bool closes = may_follow(letters_[length], letters_[1]);
    if (period == length || !closes) return closes;
    if (any([](const Mirror& one) { return one.may_repeat(); })) return true;
    return !any([](const Mirror& one) { return one.arc.has_value(); }) && length == 2 * period &&
           period % 2 == 1;
  }

  const std::vector<Mirror>& mirrors_;
  std::size_t most_;
  Word letters_;  // from 1 on; before them the least
  std::vector<Word> found_;
};

}  // namespace

std::optional<std::vector<Word>> words(const std::vector<Mirror>& mirrors, std::size_t length,
                                       std::size_t most) {
  return Necklaces(mirrors, length, most).all();
}

Result<std::vector<ClosedOrbit>> orbits_by_word(const ExperimentContext& context,
                                                const MirrorRoom& room, std::size_t length) {
  std::vector<Word> all;
  for (std::size_t n = 1; n <= length; ++n) {
    auto some = words(room.mirrors, n, kMostWords - all.size());
    if (!some)
      return refused_option("--symbols",
                            fmt::format("{} mirrors have more than {} words of up to {}",
                                        room.mirrors.size(), kMostWords, counted(length, "wall")),
                            fmt::format("say --symbols {}", n - 1));
    all.insert(all.end(), some->begin(), some->end());
  }
  std::vector<std::vector<ClosedOrbit>> found(all.size());
  FLATRAY_TRY(ran, run_tasks(context, all.size(),
                             [&](std::size_t i) { found[i] = closed_orbits(room, all[i]); }));
  std::vector<ClosedOrbit> orbits;
  for (auto& some : found)
    orbits.insert(orbits.end(), std::make_move_iterator(some.begin()),
                  std::make_move_iterator(some.end()));
  return orbits;
}

}  // namespace flatray
