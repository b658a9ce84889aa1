#pragma once
#include <string>
#include <vector>

namespace flatray {

/// A number on an axis, or on its logarithm.
struct Tick {
  double at;
  std::string words;
};

/// Multiples of 1, 2 or 5 times a power of ten, some `most` of them; or those of a step.
std::vector<Tick> ticks(double low, double high, double most, double step = 0);
/// Powers of ten between two logarithms; with their 2 and 5 times where there are few,
/// and multiples as above where there are none.
std::vector<Tick> log_ticks(double low, double high, double most);

/// A number to so many digits as people write it: 0.001, 20, 1e-7.
std::string tick_words(double number, int digits = 6);

double log10_of(double x);

/// Words in lines of at most so many units, broken at blanks.
std::vector<std::string> lines_of(const std::string& words, double width);

}  // namespace flatray
