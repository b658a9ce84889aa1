#pragma once
#include <span>
#include <string>

#include "study/accuracy/accuracy.h"

namespace flatray {

/// Error against seconds of one choice, both as logarithms; the line joins the best points.
std::string accuracy_plot(const ChoiceReport& report);

/// One HTML page: tables, plots and the pictures behind the points, with nothing to fetch.
/// Gives   well-formed text for any names; dark where the reader's system is.
std::string accuracy_page(const std::string& scene, std::span<const ChoiceReport> reports);

}  // namespace flatray
