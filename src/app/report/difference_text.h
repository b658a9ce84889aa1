#pragma once
#include <string>

#include "image/compare.h"

namespace flatray {

/// "worst pixel (111, 87) green: 190, expected 153; 12 of 40000 pixels differ". Needs a difference.
std::string difference_text(const Difference& difference);

}  // namespace flatray
