#include "base/source_text.h"

#include <algorithm>

namespace flatray {

SourceText::SourceText(std::string name, std::string text, std::shared_ptr<const Place> named_at,
                       Kind kind)
    : name_(std::move(name)),
      text_(std::move(text)),
      named_at_(std::move(named_at)),
      kind_(kind),
      line_starts_{0} {
  line_starts_.reserve(1 + static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')));
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    line_starts_.push_back(at + 1);
}

SourceText::Position SourceText::position(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return {static_cast<int>(after - line_starts_.begin()),
          static_cast<int>(offset - *(after - 1)) + 1};
}

std::size_t SourceText::offset(int line, int column) const {
  const std::size_t row =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::max(line, 1)), 1, line_starts_.size());
  const std::size_t in_line = static_cast<std::size_t>(std::max(column, 1)) - 1;
  return line_starts_[row - 1] + std::min(in_line, this->line(static_cast<int>(row)).size());
}

std::string_view SourceText::line(int number) const {
  const std::size_t row = static_cast<std::size_t>(number);
  if (number < 1 || row > line_starts_.size()) return {};
  const std::size_t begin = line_starts_[row - 1];
  std::size_t end = row < line_starts_.size() ? line_starts_[row] - 1 : text_.size();
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

Place place_in(SourcePtr source, std::string_view part) {
  const auto offset = static_cast<std::size_t>(part.data() - source->text().data());
  return {std::move(source), offset, part.size()};
}

Place named_place(std::string name) {
  return {std::make_shared<const SourceText>(std::move(name), std::string{}), 0, 0};
}

}  // namespace flatray
