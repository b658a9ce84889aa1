#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/table.h"
#include "geom/ray.h"
#include "scene/scene.h"

namespace flatray {

/// Result of one block of work.
using Numbers = std::vector<double>;

/// What an experiment tells of its blocks, and asks. Its functions are called by several threads;
/// as they stand here nobody is told, and nothing is kept.
class RunMonitor {
 public:
  virtual ~RunMonitor() = default;
  virtual void begin(std::size_t /*blocks*/) {}
  /// What an earlier run found for a block.
  virtual std::optional<Numbers> kept(std::size_t /*block*/) { return std::nullopt; }
  virtual void done(std::size_t /*block*/, const Numbers& /*result*/) {}
  /// Whether no further block is to be begun.
  virtual bool stopped() { return false; }
};

/// What the pixels of a picture stand for, one orbit each.
enum class PixelMap : std::uint8_t {
  usual,     ///< as the experiment likes
  position,  ///< starts at their places, all in the direction of the scene's first ray
  angle      ///< starts on the line across that ray, as wide as the window, by column from left to
             ///< right as seen along the ray, and at angles to it from 90 degrees, top, to -90
};

/// How starts that are drawn are spread: each by itself; evenly together; or as what is left of an
/// open room after long is (study/rooms/conditional_starts.h).
enum class Starts : std::uint8_t { random, quasi, conditional };

/// How orbits are followed: deciding exactly, in lanes of doubles (transport/fast_orbits.h), or
/// proven.
enum class OrbitPrecision : std::uint8_t { exact, fast, certified };

/// What an experiment is run with.
struct ExperimentContext {
  const Scene& scene;
  std::uint64_t seed = 1;
  std::uint64_t count = 1'000'000;
  unsigned threads = 1;
  std::optional<std::uint64_t> bounces{};  ///< of one orbit; each experiment has its own default
  double apart = 1e-9;                     ///< of orbits that start near each other
  PixelMap map = PixelMap::usual;
  RunMonitor* monitor = nullptr;
  Starts starts = Starts::random;
  std::optional<std::uint64_t> symbols{};  ///< bounces of the longest periodic orbit
  OrbitPrecision precision = OrbitPrecision::exact;

  bool stopped() const { return monitor != nullptr && monitor->stopped(); }
};

/// A number found, beside what must come out where that is known.
struct Measure {
  std::string name;
  double value = 0;
  /// Estimated from the data; none where the number is counted or computed, or no limit is known.
  std::optional<double> standard_error{};
  std::optional<double> expected{};
  /// Degrees of freedom of the standard error: independent parts of the data, less one.
  double freedom = std::numeric_limits<double>::infinity();
  /// Of a number without an error: how far from what is expected rounding may take it, 0 of a
  /// count; none where nothing can be said of that.
  std::optional<double> allowed{};
  std::string remark{};  ///< what the error is estimated from, or why there is none
  /// Bounds that it is proven to lie between, in place of an error.
  std::optional<Range> proven{};
  /// Of its interval, beyond Student's t, where what it is estimated from is skewed.
  double widening = 1;
};

/// A number that has no error, and what it is or why that is so.
inline Measure remarked(std::string name, double value, std::string remark) {
  return {.name = std::move(name), .value = value, .remark = std::move(remark)};
}

/// A number that must come out as `expected`, where that is known, but for what rounding may take
/// it off.
inline Measure expected_within(std::string name, double value, std::optional<double> expected,
                               double allowed, std::string remark = {}) {
  return {.name = std::move(name),
          .value = value,
          .expected = expected,
          .allowed = allowed,
          .remark = std::move(remark)};
}

/// A number that is computed, and what rounding may take it off in its remark.
Measure within_rounding(std::string name, double value, std::optional<double> expected,
                        double allowed);

/// Takes the error from a measure, and says why.
inline void withhold_error(Measure& measure, std::string why) {
  measure.standard_error.reset();
  measure.remark = std::move(why);
}

/// Named files (CSV, JSON, SVG, PNG) and a text for people; `holds` is whether results agree with
/// the closed form.
struct ExperimentResult {
  struct File {
    std::string name;  ///< what comes before the extension may hold anything
    std::string content;
    std::string caption{};  ///< of numbers for programs (.npy): what they are, with their units
  };
  std::vector<File> files{};
  std::string summary{};
  bool holds = true;
  std::vector<Measure> measures{};
  Table table{};  ///< of the measures, a row each
};

/// Files of a table and of an object, an item a line with infinity and NaN null.
ExperimentResult::File csv_file(const std::string& name, const Table& table);
ExperimentResult::File json_file(const std::string& name, const Fields& fields);
/// What the JSON of an experiment begins with: its name, its scene, what it was run with.
Fields head_of(const std::string& experiment, const ExperimentContext& context);
/// A failure by what an option says, or does not say.
inline auto refused_option(const char* option, std::string message, std::string hint) {
  return fail(named_place(option), std::move(message), std::move(hint), Trouble::usage);
}
/// How tables of a summary look.
inline const TextStyle kBrief{.brief = true};
/// The number, or what stands in a table where there is none.
inline JsonValue cell_or(const char* none, const std::optional<double>& number) {
  return number ? JsonValue(*number) : none;
}

/// What of a context an experiment looks at, beside its scene and threads: the rest is refused
/// where it is asked for.
struct ExperimentUses {
  bool count = false, bounces = false, apart = false, map = false, seed = false, starts = false;
  bool resume = false;  ///< it works in blocks
  bool symbols = false;
  bool precision = false;    ///< it is a mean over orbits
  bool field = false;        ///< a magnetic field may bend its rays
  bool conditional = false;  ///< its starts may be of the conditionally invariant measure
  bool glass = false;        ///< glass may split them
};

struct Experiment {
  const char* name;
  const char* question;
  Result<ExperimentResult> (*run)(const ExperimentContext&);
  ExperimentUses uses;
};

/// Registered experiments by name.
std::vector<const Experiment*> experiments();

}  // namespace flatray
