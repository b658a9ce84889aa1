#pragma once
#include "study/statistics/blocks.h"

namespace flatray {

/// Sums over independent samples (x, y) from which the ratio of their means is estimated.
///
/// Error   of the spread of samples some ulps of their squares: one of less than 1e-7 of them is lost,
///         unless `about` is near their ratio.
struct RatioSums {
  double samples = 0, x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0, xxx = 0, xxy = 0, xyy = 0,
         yyy = 0;  // of x - about y in place of x
  double about = 0;

  void add(double sample_x, double sample_y);

  /// Sum of x over sum of y.
  double ratio() const { return x / y; }
  /// Of the ratio: that of the mean of x - ratio * y over the mean of y.
  ///
  /// Needs   two samples or more; of few the interval is wide, by Student's t.
  double standard_error() const;
  /// By how much more than Student's t takes intervals must be wide to cover as often where samples
  /// are skewed: 1 where they are no more so than by chance.
  ///
  /// Source  the Edgeworth expansion of a two-sided t (Hall 1992, The Bootstrap and Edgeworth
  ///         Expansion, section 2.6): z^4 + 2 z^2 - 3 parts in 18 of skewness^2 / samples, at z =
  ///         1.96. Moving the interval, too (Johnson 1978), covers no better: of 32 orbits tails
  ///         that are long on both sides are taken for skewness.
  double widening() const;
  /// The ratio as a measure, without an error where there is a sample alone.
  Measure measure(std::string name, std::optional<double> expected = std::nullopt) const;
  /// A share of samples that are counted, without an error where fewer than ten are of one kind:
  /// its spread says too little then, and of none nothing. Where groups of quasi-random starts hardly
  /// differ the error is that of two samples.
  Measure share(std::string name, std::string remark = {}) const;

  void append_to(SumList& list);
};

/// Standard errors that a measure may lie from what must come out, where they are many's.
inline constexpr double kAllowedErrors = 4;

/// Standard errors on either side that hold the truth in 95 % of all runs: Student's t, 1.96 where
/// `freedom` is infinite.
///
/// Error   1 % for 3 degrees of freedom, 0.1 % for 5 and more.
/// Source  Abramowitz and Stegun 26.7.5.
double student_95(double freedom);
/// Those that as few of all runs are off by as normal numbers are by kAllowedErrors, one in 16,000.
///
/// Error   1 % from 15 degrees of freedom on, of fewer it is too large.
/// Source  Wallace 1959.
double allowed_errors(double freedom);
/// The same of chi-squared: it is below this in 95 % of all runs, and below the other in 5 %.
///
/// Error   1 % from 2 degrees of freedom on, the lower one from 8 on.
/// Source  Wilson and Hilferty 1931.
double chi_squared_95(double freedom);
double chi_squared_5(double freedom);

/// Half of the interval of a root mean square of `count` normal numbers, as a part of it, that
/// holds the true one in 95 % of all runs: it is seldom more too small, and hardly ever as much too
/// large.
double half_of_rms(double count);

/// Half of the interval that covers the truth in 95 % of all runs; none without a standard error.
std::optional<double> half_interval(const Measure& measure);
/// The interval itself, or the bounds that are proven; none where there is neither.
std::optional<Range> interval(const Measure& measure);
/// An end of it in a table; null where there is none.
JsonValue end_cell(const Measure& measure, double Range::*end);

/// Whether a measure lies near enough to what is expected, where anything is: by its standard
/// error and the parts that is estimated from, or as far as rounding is allowed to take it.
bool agrees(const Measure& measure);
/// That in a word: "yes" or "no", nothing where it cannot be said.
std::optional<std::string> verdict(const Measure& measure);

/// Result of an experiment whose answer is a list of measures: NAME.csv, NAME.json, and the table
/// as text after `headline`; last what an audit of orbits adds to them.
ExperimentResult measured(const ExperimentContext& context, const std::string& name,
                          const std::string& headline, std::vector<Measure> measures,
                          const std::vector<Measure>& audit = {});

}  // namespace flatray
