#include "study/plots/svg_text.h"

#include <fmt/core.h>

#include <cmath>

namespace flatray {

std::string svg_text(const std::string& text) {
  std::string safe;
  for (const char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  return safe;
}

std::string svg_number(double x) { return fmt::format("{:.2f}", std::round(x * 100) / 100 + 0.0); }

}  // namespace flatray
