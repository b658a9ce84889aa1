#pragma once
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace flatray::testing {

/// Whether a text has these words in it; where that is not as expected the text is shown.
inline ::testing::AssertionResult has(const std::string& text, const std::string& words) {
  const bool found = text.find(words) != std::string::npos;
  return (found ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << '"' << words << (found ? "\" is in: " : "\" is not in: ") << text;
}

/// Whether every element of a small XML text is closed in order and every '&' begins an entity of
/// XML. Needs   no comments, CDATA sections or '>' in attributes.
inline bool is_well_formed(std::string_view xml) {
  std::vector<std::string> open;
  std::size_t elements = 0;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&') {
      const std::string_view entity = xml.substr(i, xml.find(';', i) - i);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt" && entity != "&quot") return false;
    }
    if (xml[i] == '>') return false;
    if (xml[i] != '<') continue;
    const std::size_t end = xml.find('>', i);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = xml.substr(i + 1, end - i - 1);
    i = end;
    if (tag.front() == '?') continue;
    if (tag.find('<') != std::string_view::npos) return false;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      if (open.empty() && elements > 0) return false;  // a second root
      open.emplace_back(tag.substr(0, tag.find(' ')));
    }
    ++elements;
  }
  return open.empty() && elements > 0;
}

}  // namespace flatray::testing
