#include "study/plots/plot_axes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/portable_math.h"
#include "study/plots/drawing.h"

namespace flatray {

double log10_of(double x) {
  constexpr double kLn10 = 0x1.26bb1bbb55516p+1;
  return portable::log(x) / kLn10;
}

std::string tick_words(double number, int digits) {
  std::string words = fmt::format("{:.{}g}", number + 0.0, digits);
  const std::size_t e = words.find('e');
  if (e == std::string::npos) return words;
  return words.substr(0, e) + fmt::format("e{}", std::stoi(words.substr(e + 1)));
}

namespace {

// Of the first digit that is not 0.
int exponent_of(double x) {
  const std::string words = fmt::format("{:.16e}", x);
  return std::stoi(words.substr(words.find('e') + 1));
}

// Words of multiples of a step as they stand on one axis: where the largest needs an exponent, all have its.
auto axis_words(double step, double largest) {
  constexpr int kUsualDigits = 6, kLeastPlain = -4, kLeastExponent = -307;
  const int last = exponent_of(step) - 1, first = exponent_of(largest);  // steps have two digits
  const bool plain = first >= kLeastPlain && first <= std::max(kUsualDigits - 1, first - last - 1);
  const int exponent = plain ? 0 : std::max(first, kLeastExponent);
  const int decimals = std::max(0, exponent - last);
  return [exponent, decimals](double at) {
    std::string words = fmt::format("{:.{}f}", at / portable::pow(10, exponent), decimals);
    if (decimals > 0) words.erase(words.find_last_not_of('0') + 1);
    if (words.back() == '.') words.pop_back();
    return exponent == 0 || at == 0 ? words : fmt::format("{}e{}", words, exponent);
  };
}

}  // namespace

std::vector<Tick> ticks(double low, double high, double most, double step) {
  if (step == 0) {
    const double span = high - low;
    const double power = portable::pow(10, std::floor(log10_of(span / most)));
    step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
      if (span / (factor * power) <= most) step = factor * power;
  }
  std::vector<Tick> all;
  const double first = std::ceil(low / step);
  if (!(step > 0) || !(std::fabs(first) < 0x1p52)) return all;  // doubles there have no such steps
  const auto words = axis_words(step, std::max({std::fabs(low), std::fabs(high), step}));
  for (auto k = static_cast<std::int64_t>(first); static_cast<double>(k) * step <= high; ++k) {
    const double at = static_cast<double>(k) * step;
    all.push_back({at, words(at)});
  }
  return all;
}

std::vector<Tick> log_ticks(double low, double high, double most) {
  if (!std::isfinite(low) || !std::isfinite(high)) return {};
  const double step = std::max(1.0, std::ceil((high - low) / most));
  std::vector<Tick> all;
  for (auto number = static_cast<int>(std::floor(low / step)); number * step <= high; ++number)
    for (const int factor : {1, 2, 5}) {
      const double k = number * step;
      const double at = k + log10_of(factor);
      if (at < low || at > high || (factor > 1 && high - low > most / 3)) continue;
      // Not factor * 10^k: its digits are those of a decimal.
      const bool plain = k > -5 && k < 6;
      const std::string zeros(static_cast<std::size_t>(std::min(std::fabs(k), 6.0)), '0');
      all.push_back({at, !plain  ? fmt::format("{}e{:.0f}", factor, k)
                         : k < 0 ? "0." + zeros.substr(1) + std::to_string(factor)
                                 : std::to_string(factor) + zeros});
    }
  if (all.size() > 1) return all;
  all = ticks(portable::pow(10, low), portable::pow(10, high), most);
  for (Tick& tick : all) tick.at = log10_of(tick.at);
  return all;
}

std::vector<std::string> lines_of(const std::string& words, double width) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < words.size();) {
    std::size_t end = words.size();
    while (words_width(words.substr(begin, end - begin)) > width) {
      const std::size_t blank = words.rfind(' ', end - 1);
      if (blank == std::string::npos || blank <= begin) break;
      end = blank;
    }
    lines.push_back(words.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace flatray
