#pragma once
#include <span>
#include <string>

#include "study/accuracy.h"
#include "study/experiment.h"

namespace flatray {

/// What was measured on a scene, as files: accuracy.csv, accuracy.json, a log-log picture
/// accuracy_CHOICE.svg of each choice, and accuracy.html, one page that needs no other file.
/// Gives   the summary as text for a terminal.
ExperimentResult accuracy_report(const std::string& scene, std::span<const ChoiceReport> reports);

}  // namespace flatray
