#pragma once
#include <string>

namespace flatray {

/// Text as it stands between tags and in attributes; control characters become question marks.
std::string svg_text(const std::string& text);

/// Two digits after the point, never "-0.00".
std::string svg_number(double x);

}  // namespace flatray
