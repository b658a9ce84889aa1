#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace flatray {

struct Place;

/// One input as read: its name for messages and its bytes. Lines and columns count from 1, columns
/// in bytes.
class SourceText {
 public:
  struct Position {
    int line = 0, column = 0;
  };

  enum class Kind { file, option };
  /// `named_at` is where another text names this one, if one does: includes or imports it.
  SourceText(std::string name, std::string text, std::shared_ptr<const Place> named_at = nullptr,
             Kind kind = Kind::file);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  const Place* named_at() const { return named_at_.get(); }
  Kind kind() const { return kind_; }
  /// Line and column of a byte. `offset` past the end is the end.
  Position position(std::size_t offset) const;
  /// Byte at a line and column, clamped to that line: the inverse of `position`.
  std::size_t offset(int line, int column) const;
  /// A line without its line end.
  std::string_view line(int number) const;

 private:
  std::string name_, text_;
  std::shared_ptr<const Place> named_at_;
  Kind kind_;
  std::vector<std::size_t> line_starts_;
};

using SourcePtr = std::shared_ptr<const SourceText>;

/// Where a value stands: `length` bytes at `offset` of `source`. Without a source it is nowhere; a
/// source without text (a file that cannot be read, a command line) still gives its name.
struct Place {
  SourcePtr source;
  std::size_t offset = 0, length = 0;

  explicit operator bool() const { return source != nullptr; }
};

/// The place of a part of the source's text.
Place place_in(SourcePtr source, std::string_view part);

/// A place that is only a name: "--size", "my/scene.toml".
Place named_place(std::string name);

}  // namespace flatray
