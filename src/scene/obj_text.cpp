#include "scene/obj_text.h"

#include <fmt/core.h>

#include <charconv>
#include <string_view>

#include "base/number_text.h"

namespace flatray {
namespace {

constexpr std::size_t kMaxProblems = 20, kMaxIgnored = 8, kMaxWord = 24;
constexpr std::size_t kMaxCoordinates = 7;  // x y z and a weight or a colour

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

class ObjReader {
 public:
  explicit ObjReader(SourcePtr source)
      : source_(std::move(source)),
        text_(source_->text()),
        base_(source_->name().ends_with(".obj2d") ? 0 : 1) {}

  Result<ObjText> read() {
    while (at_ < text_.size() && problems_.size() < kMaxProblems) {
      read_record(next_word());
      skip_line();
    }
    resolve(obj_.faces);
    resolve(obj_.lines);
    if (!problems_.empty()) return tl::unexpected(std::move(problems_));
    return std::move(obj_);
  }

 private:
  // An index as written, before the number of vertices is known: the place tells it again if it is
  // wrong.
  struct Corner {
    std::int64_t index;
    std::size_t offset;
  };

  // Blanks and continued lines ("\" before the line end) part words; "" at the end of the record.
  std::string_view next_word() {
    for (; at_ < text_.size(); ++at_) {
      if (is_blank(text_[at_])) continue;
      const std::size_t line_end = continued();
      if (line_end == 0) break;
      at_ = line_end - 1;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_end_of_word()) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  bool is_end_of_word() const {
    const char c = text_[at_];
    return is_blank(c) || c == '\n' || c == '#' || (c == '\\' && continued() != 0);
  }
  // Byte after a "\" and line end that begin here, or 0.
  std::size_t continued() const {
    if (text_[at_] != '\\') return 0;
    std::size_t end = at_ + 1;
    if (end < text_.size() && text_[end] == '\r') ++end;
    return end < text_.size() && text_[end] == '\n' ? end + 1 : 0;
  }
  // To the first byte of the next line; comments are not continued.
  void skip_line() {
    const bool comment = at_ < text_.size() && text_[at_] == '#';
    while (at_ < text_.size() && text_[at_] != '\n') {
      const std::size_t line_end = comment ? 0 : continued();
      at_ = line_end == 0 ? at_ + 1 : line_end;
    }
    ++at_;
  }

  void problem(std::string_view word, std::string message, std::string hint) {
    const auto offset = static_cast<std::size_t>(word.data() - text_.data());
    problems_.push_back({{source_, offset, word.size()}, std::move(message), std::move(hint)});
  }

  void read_record(std::string_view record) {
    if (record == "v")
      read_vertex(record);
    else if (record == "f")
      read_chain(record, obj_.faces, 3);
    else if (record == "l")
      read_chain(record, obj_.lines, 2);
    else if (!record.empty())
      ignore(record);
  }

  void ignore(std::string_view record) {
    const std::string name(record.substr(0, kMaxWord));
    if (name == last_ignored_) return;
    last_ignored_ = name;
    if (obj_.ignored.size() < kMaxIgnored &&
        std::find(obj_.ignored.begin(), obj_.ignored.end(), name) == obj_.ignored.end())
      obj_.ignored.push_back(name);
  }

  void read_vertex(std::string_view record) {
    double xy[2] = {0, 0};
    std::size_t count = 0;
    for (std::string_view word; !(word = next_word()).empty(); ++count) {
      const std::optional<double> value = parse_number(word);
      if (!value || count == kMaxCoordinates)
        return problem(word,
                       value ? "a vertex has too many numbers"
                             : fmt::format("'{}' is no finite number", word.substr(0, 40)),
                       "a vertex reads v x y [z [w]]");
      if (count < 2) xy[count] = *value;
    }
    if (count < 2)
      return problem(record, "a vertex has no x and y", "a vertex reads v x y [z [w]]");
    obj_.vertices.emplace_back(xy[0], xy[1]);
  }

  void read_chain(std::string_view record, ObjText::Chains& chains, std::size_t least) {
    auto& corners = &chains == &obj_.faces ? face_corners_ : line_corners_;
    const std::size_t before = corners.size();
    for (std::string_view word; !(word = next_word()).empty();)
      if (!read_corner(word, corners)) return corners.resize(before);
    if (corners.size() - before < least) {
      problem(record, fmt::format("'{}' needs at least {} vertices", record, least),
              "write the numbers of its vertices");
      return corners.resize(before);
    }
    chains.begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }

  // "i", "i/t", "i/t/n", "i//n": only i matters here, the others must be whole numbers.
  bool read_corner(std::string_view word, std::vector<Corner>& corners) {
    std::int64_t index = 0;
    std::string_view rest = word;
    bool good = take_index(rest, index);
    for (int part = 0; good && !rest.empty() && part < 2; ++part) {
      std::int64_t unused = 0;
      good = rest.front() == '/';
      rest.remove_prefix(1);
      if (good && !rest.empty() && rest.front() != '/') good = take_index(rest, unused);
    }
    const bool forward = index >= base_, backward = base_ == 1 && index < 0;
    if (!good || !rest.empty() || !(forward || backward)) {
      problem(word, fmt::format("'{}' is no vertex number", word.substr(0, 40)),
              base_ == 0 ? "write i, counted from 0"
                         : "write i, i/t, i/t/n or i//n, counted from 1, or from -1 backwards");
      return false;
    }
    // Backwards counts from the vertices so far; what lands before the first is refused later.
    index = forward ? index - base_ : index + static_cast<std::int64_t>(obj_.vertices.size());
    corners.push_back({index, static_cast<std::size_t>(word.data() - text_.data())});
    return true;
  }

  static bool take_index(std::string_view& text, std::int64_t& index) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  }

  void resolve(ObjText::Chains& chains) {
    const auto& corners = &chains == &obj_.faces ? face_corners_ : line_corners_;
    chains.corners.reserve(corners.size());
    const auto count = static_cast<std::int64_t>(obj_.vertices.size());
    for (const Corner& corner : corners) {
      const bool good = corner.index >= 0 && corner.index < count;
      if (!good && problems_.size() < kMaxProblems) {
        at_ = corner.offset;
        problem(next_word(), "there is no such vertex", fmt::format("the file has {}", count));
      }
      chains.corners.push_back(good ? static_cast<std::uint32_t>(corner.index) : 0);
    }
  }

  SourcePtr source_;
  std::string_view text_;
  std::int64_t base_;  // the number of the first vertex
  std::size_t at_ = 0;
  ObjText obj_;
  std::vector<Corner> face_corners_, line_corners_;
  std::string last_ignored_;
  Diagnostics problems_;
};

}  // namespace

Result<ObjText> parse_obj(const SourcePtr& source) { return ObjReader(source).read(); }

}  // namespace flatray
