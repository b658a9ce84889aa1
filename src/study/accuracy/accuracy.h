#pragma once
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "render/draw_list.h"
#include "scene/scene.h"

namespace flatray {

/// Where an error comes from.
enum class ErrorKind : std::uint8_t {
  sampling,        ///< random or regular samples stand for a whole
  truncation,      ///< what goes on for ever is cut
  discretisation,  ///< what is continuous is cut into steps
  rounding         ///< doubles, or floats, stand for real numbers
};
inline constexpr std::size_t kErrorKinds = 4;
const char* name(ErrorKind kind);

/// Parts of an error by kind; of a kind that is not defined for it there is none.
using ErrorParts = std::array<std::optional<double>, kErrorKinds>;

/// What one setting came to, before time is measured.
struct Outcome {
  double error = 0;  ///< against the reference, in the unit of the choice
  double half = 0;   ///< half of the interval that holds it in 95 % of all runs; 0: no doubt
  std::optional<Image> picture{};  ///< what it looks like
  /// By kind what of the error comes from it, where that is defined; where none is, all is of the
  /// choice's kind.
  ErrorParts parts{};
  /// `error` is what the reference itself may be off: against it no less is seen.
  bool at_most = false;
  /// How far `picture` is from the reference's, times kDifferenceGain.
  std::optional<Image> difference{};
};
inline constexpr int kDifferenceGain = 16;

/// A share of `wrong` of `all`, and half of the interval that holds it in 95 % of all runs: not 0,
/// either, where none or all are wrong. 0 of 0 may be anything.
///
/// Source  Wilson, Probable inference, 1927.
struct Share {
  double value, half;
};
Share share_of(double wrong, double all);

/// Options of `flatray render`, name and value.
using RenderOptions = std::vector<std::pair<std::string, std::string>>;

/// One setting of a choice.
struct Setting {
  std::string words;           ///< as a person would name it
  double n = 0;                ///< what grows from setting to setting; 0 for one beside the row
  std::function<void()> work;  ///< what is timed; may run again
  /// Of the last `work`, or why that came to nothing.
  std::function<Result<Outcome>()> judge;
  /// What chooses it in `flatray render`; absent where nothing does.
  std::optional<RenderOptions> options{};
  /// Of settings of several kinds in one choice: the row it belongs to, each with an order.
  std::string series{};
};

/// A setting that this machine, this build or the scene cannot have, and why.
struct MissingSetting {
  std::string words, why;
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
  std::optional<RenderOptions> options{};
  std::string series{};
};

/// How an error may go with n.
enum class Law : std::uint8_t {
  power,       ///< like n^slope
  exponential  ///< like e^(slope n)
};

/// Least squares of log error against log n, or n, over the points with both above 0. What they
/// leave is no error of the slope: most points are computed, not drawn, and lie near a line, not on
/// it.
struct FittedOrder {
  double slope = 0;
  std::string series{};
  Law law = Law::power;
  double rest = 0;  ///< squares of what it leaves of log error, together
};

/// What is said of a choice on one scene, whatever its settings come to.
struct ChoiceFacts {
  std::string reference{};   ///< what errors are measured against, and how that is known
  std::string unit{};        ///< of the errors
  std::string grows{};       ///< what n counts
  bool one_question = true;  ///< whether all settings answer the same, so that one is best
  std::vector<MissingSetting> missing{};
  std::string cut{};  ///< what the budget left out, of the reference to begin with
};

/// What a choice costs and gives on one scene.
struct ChoiceReport : ChoiceFacts {
  std::string name, question;
  ErrorKind kind = ErrorKind::sampling;
  std::vector<AccuracyPoint> points;
  std::vector<FittedOrder> orders;  ///< of each series of which there is one
  std::string left_out;             ///< why there are no points
  std::size_t rounds = 0;           ///< that the median is of
  double reference_seconds = 0;     ///< of processor time that the reference took
  double seconds = 0;               ///< that all took, the reference among it
};

/// What the choices are measured with.
struct AccuracyContext {
  const Scene& scene;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double seconds = 10;       ///< of processor time that a choice may take, its reference among it
  bool at_least_one = true;  ///< whether the first setting is measured whatever it takes
};

/// Seconds of a budget that a reference may take.
inline double reference_budget(const AccuracyContext& context) { return 0.6 * context.seconds; }

/// The frame in the middle of the scene, which settings are measured on, with no more than so many
/// rays of light, and its picture; none where it cannot be drawn.
unsigned middle_frame(const Scene& scene);
Result<DrawList> middle_list(const AccuracyContext& context, std::uint64_t most_rays);
std::optional<Image> picture_of(const AccuracyContext& context);

/// Makes a film no larger than so many pixels on its longer side.
void shrink(Film& film, int side);

/// What a choice is measured by, made ready for one scene.
struct ChoiceSettings : ChoiceFacts {
  std::vector<Setting> settings{};  ///< from the cheapest on
  /// Of which the first is told, or one that fits clearly better.
  std::vector<Law> laws = {Law::power};
  /// Errors from which on they cannot grow any more, so that no law holds.
  double saturated = std::numeric_limits<double>::infinity();
  double doubt = 0;  ///< what the reference itself may be off, in the unit
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

/// Why choices that trace rays are left out of a scene with a magnetic field.
inline constexpr const char* kRaysAreBent =
    "its rays are straight, and a magnetic field bends them; say -D chamber.0.field=0 to leave the "
    "field out";

/// Registered choices by name.
std::vector<const Choice*> choices();

/// Error against run time of one choice: its reference, then every setting once, as long as three
/// rounds are likely to stay within the budget, time growing like n; then in turns, so that what
/// disturbs the machine disturbs all of them, as long as a round more stays within it. Where the
/// reference takes all of the budget no setting is measured, but for the first with `at_least_one`.
ChoiceReport measure_choice(const Choice& choice, const AccuracyContext& context);

/// Several choices within the budget of the context together, the last one first: each has an equal
/// part of what those before it have left. One setting, the first, is measured whatever it takes.
std::vector<ChoiceReport> measure_choices(std::span<const Choice* const> choices,
                                          const AccuracyContext& context);

/// The best point below so many seconds, if its error is known to within itself or kSmallError; the
/// cheapest whose error is, with its half interval, below one. nullptr for none.
const AccuracyPoint* best_within(const ChoiceReport& report, double seconds);
const AccuracyPoint* cheapest_below(const ChoiceReport& report, double error);

/// Seconds and error that a report gives advice about.
inline constexpr double kShortSeconds = 1, kSmallError = 1e-3;
/// Such advice about a point: "best under 1 s", "cheapest under 0.001", both with "and", or "".
std::string advice(const ChoiceReport& report, const AccuracyPoint& point);

/// Parts of a point's error, all of it under the choice's kind where no more is defined.
ErrorParts error_parts(const ChoiceReport& report, const AccuracyPoint& point);

/// The slope of a straight line through (log n, log error), or (n, log error), of the points of one
/// series below an error; those known as `at_most` tell nothing. Nothing for fewer than three
/// points, nor where all errors are the same.
std::optional<FittedOrder> fit_order(const std::vector<AccuracyPoint>& points,
                                     const std::string& series = {}, Law law = Law::power,
                                     double saturated = std::numeric_limits<double>::infinity());
/// The series of some points, in the order they come in.
std::vector<std::string> series_of(const std::vector<AccuracyPoint>& points);
/// Such an order in words: "quasi: error ~ (flights)^-0.98", "error ~ e^(0.750 bounces)".
std::string words(const FittedOrder& order, const std::string& grows);

}  // namespace flatray
