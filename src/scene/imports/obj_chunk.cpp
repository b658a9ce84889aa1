#include "scene/imports/obj_chunk.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

#include "base/number_text.h"
#include "scene/reading/format.h"

namespace flatray {
namespace {

constexpr std::size_t kMaxWord = 24;
constexpr std::size_t kMaxCorners = 1'000'000;  // of one face or line: bounds what its pieces need
constexpr std::size_t kMaxCoordinates = 7;      // x y z and a weight or a colour

// What a byte does to a word: most are part of it.
enum class ByteKind : std::uint8_t { word, blank, stop, backslash };

constexpr std::array<ByteKind, 256> byte_kinds() {
  std::array<ByteKind, 256> kinds{};
  for (const char c : {' ', '\t', '\r', '\f', '\v'})
    kinds[static_cast<unsigned char>(c)] = ByteKind::blank;
  kinds['\n'] = kinds['#'] = ByteKind::stop;
  kinds['\\'] = ByteKind::backslash;
  return kinds;
}
constexpr std::array<ByteKind, 256> kByteKinds = byte_kinds();
ByteKind kind_of(char c) { return kByteKinds[static_cast<unsigned char>(c)]; }

class ChunkReader {
 public:
  ChunkReader(SourcePtr source, std::size_t begin, std::size_t end, bool with_offsets)
      : source_(std::move(source)),
        text_(source_->text().substr(0, end)),
        base_(extension_of(source_->name()) == "obj2d" ? 0 : 1),
        at_(begin),
        with_offsets_(with_offsets) {}

  ObjChunk read() {
    while (at_ < text_.size() && chunk_.problems.size() < kMaxObjProblems) {
      read_record(next_word());
      skip_line();
    }
    return std::move(chunk_);
  }

  // Offset of the record of a kind with that number.
  std::size_t find(std::string_view record, std::size_t number) {
    for (; at_ < text_.size(); skip_line())
      if (const std::string_view word = next_word(); word == record && number-- == 0)
        return offset_of(word);
    return text_.size();
  }

  // Blanks and continued lines ("\" before the line end) part words; "" at the end of the record.
  std::string_view next_word() {
    for (; at_ < text_.size(); ++at_) {
      const ByteKind kind = kind_of(text_[at_]);
      if (kind == ByteKind::blank) continue;
      const std::size_t line_end = kind == ByteKind::backslash ? continued() : 0;
      if (line_end == 0) break;
      at_ = line_end - 1;
    }
    const std::size_t begin = at_;
    for (; at_ < text_.size(); ++at_) {
      const ByteKind kind = kind_of(text_[at_]);
      if (kind == ByteKind::word) continue;
      if (kind != ByteKind::backslash || continued() != 0) break;
    }
    return text_.substr(begin, at_ - begin);
  }

 private:
  // Byte after a "\" and line end that begin here, or 0.
  std::size_t continued() const {
    if (text_[at_] != '\\') return 0;
    std::size_t end = at_ + 1;
    if (end < text_.size() && text_[end] == '\r') ++end;
    return end < text_.size() && text_[end] == '\n' ? end + 1 : 0;
  }
  // To the first byte of the next line; comments are not continued.
  void skip_line() {
    bool comment = false;
    while (at_ < text_.size() && text_[at_] != '\n') {
      comment = comment || text_[at_] == '#';
      const std::size_t line_end = comment ? 0 : continued();
      at_ = line_end == 0 ? at_ + 1 : line_end;
    }
    ++at_;
  }

  std::size_t offset_of(std::string_view word) const {
    return static_cast<std::size_t>(word.data() - text_.data());
  }
  void problem(std::string_view word, std::string message, std::string hint) {
    chunk_.problems.push_back({place_in(source_, word), std::move(message), std::move(hint)});
  }

  void read_record(std::string_view record) {
    if (record == "v")
      read_vertex(record);
    else if (record == "f")
      read_chain(record, chunk_.faces, 3);
    else if (record == "l")
      read_chain(record, chunk_.lines, 2);
    else if (!record.empty())
      ignore(record);
  }

  void ignore(std::string_view record) {
    const std::string_view name = record.substr(0, kMaxWord);
    if (name == last_ignored_) return;
    last_ignored_ = name;
    auto& ignored = chunk_.ignored;
    if (ignored.size() < kMaxObjIgnored && std::ranges::find(ignored, name) == ignored.end())
      ignored.emplace_back(name);
  }

  // A vertex that is wrong keeps its number: faces after it are not second mistakes.
  void read_vertex(std::string_view record) {
    Vec2& vertex = chunk_.vertices.emplace_back(0, 0);
    std::size_t count = 0;
    for (std::string_view word; !(word = next_word()).empty(); ++count) {
      const std::optional<double> value = parse_number(word);
      if (!value || count == kMaxCoordinates)
        return problem(word,
                       value ? "a vertex has too many numbers"
                             : fmt::format("'{}' is not a finite number", word.substr(0, 40)),
                       "a vertex reads v x y [z [w]]");
      if (count < 2) vertex[static_cast<Eigen::Index>(count)] = *value;
    }
    if (count < 2) problem(record, "a vertex has no x and y", "a vertex reads v x y [z [w]]");
  }

  void read_chain(std::string_view record, ObjChunk::Chains& chains, std::size_t least) {
    const std::size_t before = chains.corners.size();
    for (std::string_view word; !(word = next_word()).empty();) {
      if (chains.corners.size() - before == kMaxCorners) {
        problem(record, fmt::format("'{}' has more than {} vertices", record, kMaxCorners),
                "cut it into several");
        return take_back(chains, before);
      }
      if (!read_corner(word, chains)) return take_back(chains, before);
    }
    if (chains.corners.size() - before < least) {
      problem(record, fmt::format("'{}' needs at least {} vertices", record, least),
              "write the numbers of its vertices");
      return take_back(chains, before);
    }
    chains.ends.push_back(static_cast<std::uint32_t>(chains.corners.size()));
  }

  static void take_back(ObjChunk::Chains& chains, std::size_t count) {
    chains.corners.resize(count);
    chains.offsets.resize(std::min(count, chains.offsets.size()));
    while (!chains.backward.empty() && chains.backward.back() >= count) chains.backward.pop_back();
  }

  // "i", "i/t", "i/t/n", "i//n": only i matters here, the others must be whole numbers.
  bool read_corner(std::string_view word, ObjChunk::Chains& chains) {
    std::int64_t index = 0;
    std::string_view rest = word;
    bool good = take_index(rest, index);
    for (int part = 0; good && !rest.empty() && part < 2; ++part) {
      std::int64_t unused = 0;
      good = rest.front() == '/' && rest.size() > 1;
      rest.remove_prefix(1);
      if (good && rest.front() != '/') good = take_index(rest, unused);
    }
    const bool forward = index >= base_, backward = base_ == 1 && index < 0;
    if (!good || !rest.empty() || !(forward || backward)) {
      problem(word, fmt::format("'{}' is not a vertex number", word.substr(0, 40)),
              base_ == 0 ? "write i, counted from 0"
                         : "write i, i/t, i/t/n or i//n, counted from 1, or from -1 backwards");
      return false;
    }
    add_corner(chains, index, offset_of(word));
    return true;
  }

  void add_corner(ObjChunk::Chains& chains, std::int64_t index, std::size_t offset) {
    using Int32 = std::numeric_limits<std::int32_t>;
    if (index < 0) {
      chains.backward.push_back(static_cast<std::uint32_t>(chains.corners.size()));
      index += static_cast<std::int64_t>(chunk_.vertices.size());
    } else {
      index -= base_;
    }
    chains.corners.push_back(
        static_cast<std::int32_t>(std::clamp<std::int64_t>(index, Int32::min(), Int32::max())));
    if (with_offsets_) chains.offsets.push_back(offset);
  }

  static bool take_index(std::string_view& text, std::int64_t& index) {
    constexpr std::size_t kSafeDigits = 18;  // no int64 overflows
    std::size_t count = 0;
    index = 0;
    for (; count < text.size() && '0' <= text[count] && text[count] <= '9'; ++count)
      if (count < kSafeDigits) index = 10 * index + (text[count] - '0');
    if (count > 0 && count <= kSafeDigits) {
      text.remove_prefix(count);
      return true;
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  }

  SourcePtr source_;
  std::string_view text_;
  std::int64_t base_;  // the number of the first vertex
  std::size_t at_;
  bool with_offsets_;
  ObjChunk chunk_;
  std::string_view last_ignored_;
};

// Whether the line end at `at` is behind a "\": the record goes on.
bool is_continued(std::string_view text, std::size_t at) {
  if (at > 0 && text[at - 1] == '\r') --at;
  return at > 0 && text[at - 1] == '\\';
}

}  // namespace

ObjChunk read_obj_chunk(const SourcePtr& source, std::size_t begin, std::size_t end,
                        bool with_offsets) {
  return ChunkReader(source, begin, end, with_offsets).read();
}

std::size_t end_of_records(std::string_view text, std::size_t offset) {
  for (std::size_t at = offset; at < text.size(); ++at) {
    at = text.find('\n', at);
    if (at == std::string_view::npos) break;
    if (!is_continued(text, at)) return at + 1;
  }
  return text.size();
}

Place obj_record_place(const SourcePtr& source, std::string_view record, std::size_t number) {
  ChunkReader reader(source, 0, source->text().size(), false);
  return {source, reader.find(record, number), record.size()};
}

Place obj_corner_place(const SourcePtr& source, std::size_t offset) {
  ChunkReader reader(source, offset, source->text().size(), false);
  return {source, offset, reader.next_word().size()};
}

}  // namespace flatray
