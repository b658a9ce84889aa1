#pragma once
#include <optional>
#include <span>
#include <string>

#include "study/accuracy/accuracy.h"
#include "study/experiment.h"

namespace flatray {

/// What was measured on a scene, as files: accuracy.csv, accuracy.json, a log-log picture
/// accuracy_CHOICE.svg of each choice that has an error, and accuracy.html, one page that needs no
/// other file.
/// Gives   the summary as text for a terminal.
/// `shown`: a picture of the scene.
ExperimentResult accuracy_report(const std::string& scene, std::span<const ChoiceReport> reports,
                                 const std::optional<Image>& shown = {});

/// Name of the file with the picture of a choice.
inline std::string plot_name(const std::string& choice) { return "accuracy_" + choice + ".svg"; }

/// What accuracy.json holds: the scene, its choices, the orders fitted, and a row for each point.
Fields accuracy_fields(const std::string& scene, std::span<const ChoiceReport> reports);

/// The kinds of error that any point has, the choice's own among them.
std::vector<std::size_t> kinds_of_error(const ChoiceReport& report);

/// Half of the range of the times of a point, which one round alone does not tell.
std::optional<double> half_range(const ChoiceReport& report, const AccuracyPoint& point);

/// What is to be said of a choice beside its table, a line each: what is missing here, what the
/// budget cut, what is best, what the reference took.
std::vector<std::string> remarks(const ChoiceReport& report);

}  // namespace flatray
