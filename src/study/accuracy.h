#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "scene/scene.h"

namespace flatray {

/// Where an error comes from.
enum class ErrorKind : std::uint8_t {
  sampling,        ///< random or regular samples stand for a whole
  truncation,      ///< what goes on for ever is cut
  discretisation,  ///< what is continuous is cut into steps
  rounding         ///< doubles, or floats, stand for real numbers
};
const char* name(ErrorKind kind);

/// What one setting came to, before time is measured.
struct Outcome {
  double error = 0;  ///< against the reference, in the unit of the choice
  double half = 0;   ///< half of the interval that holds it in 95 % of all runs; 0: no doubt
  std::optional<Image> picture{};  ///< what it looks like
};

/// One setting of a choice.
struct Setting {
  std::string words;               ///< as a person would name it
  double n = 0;                    ///< what grows from setting to setting; 0 for one beside the row
  std::function<void()> work;      ///< what is timed; may run again
  std::function<Outcome()> judge;  ///< of the last `work`
};

/// A setting measured.
///
/// Units   seconds of processor time of all threads: the median of the rounds, and half of their
///         range.
struct AccuracyPoint {
  std::string setting;
  double n = 0, seconds = 0, spread = 0;
  Outcome outcome;
  bool best = false;  ///< no other of its choice is both as fast and as near
};

/// Least squares of log error against log n, over the points with both above 0: the error goes like
/// n^slope.
struct FittedOrder {
  double slope = 0, standard_error = 0;
};

/// What a choice costs and gives on one scene.
struct ChoiceReport {
  std::string name, question;
  ErrorKind kind = ErrorKind::sampling;
  std::string unit;       ///< of the errors
  std::string reference;  ///< what they are measured against, and how that is known
  std::string grows;      ///< what n counts
  std::vector<AccuracyPoint> points;
  bool one_question = true;  ///< else no point is best
  std::optional<FittedOrder> order;
  std::string left_out;  ///< why there are no points
  std::string cut;       ///< what the budget left out
};

/// What the choices are measured with.
struct AccuracyContext {
  const Scene& scene;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double seconds = 10;  ///< of processor time that a choice may take
};

/// What a choice is measured by, made ready for one scene.
struct ChoiceSettings {
  std::string reference, unit, grows;
  std::vector<Setting> settings;  ///< from the cheapest on
  bool one_question = true;       ///< whether all settings answer the same, so that one is best
  bool ordered = true;            ///< whether a power of n is to be fitted
};

/// Something that trades time for error. A choice is a file in `choices/` and a line in CMake.
struct Choice {
  const char* name;
  const char* question;
  ErrorKind kind;
  /// Why a scene has no such choice, "" where it has.
  std::string (*left_out)(const Scene& scene);
  /// Needs   `left_out` is "".
  /// Error   what keeps it from being measured, a missing library among it.
  Result<ChoiceSettings> (*settings)(const AccuracyContext& context);
};

/// Registered choices by name.
std::vector<const Choice*> choices();

/// Error against run time of one choice: every setting once, as long as three rounds are likely to
/// stay within the budget, time growing like n; then in turns, so that what disturbs the machine
/// disturbs all of them.
ChoiceReport measure_choice(const Choice& choice, const AccuracyContext& context);

/// The slope of a straight line through (log n, log error). Nothing for fewer than three points.
std::optional<FittedOrder> fit_order(const std::vector<AccuracyPoint>& points);

}  // namespace flatray
