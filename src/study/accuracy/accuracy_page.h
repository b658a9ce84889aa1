#pragma once
#include <span>
#include <string>

#include "study/accuracy/accuracy.h"

namespace flatray {

/// Whether there is an error that logarithms can show.
bool has_plot(const ChoiceReport& report);

/// Error against seconds of one choice, both as logarithms, with their intervals; the line joins
/// the best points.
std::string accuracy_plot(const ChoiceReport& report);

/// One HTML page, with nothing to fetch: the scene, all choices in one plot, then plot, table and
/// the pictures behind the points of each; last what was left out.
/// Gives   well-formed text for any names; dark where the reader's system is.
std::string accuracy_page(const std::string& scene, std::span<const ChoiceReport> reports,
                          const std::optional<Image>& shown = {});

}  // namespace flatray
