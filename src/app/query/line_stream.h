#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/result.h"

namespace flatray {

/// A line of a stream, without its end.
struct StreamLine {
  std::string_view text;
  bool too_long = false;  ///< above LineStream::kLongest: what it held is gone
};

/// Lines of a file or of standard input, block after block, in memory that does not grow with
/// their number. A block is what has arrived: a program that asks one question and waits gets its
/// answer.
class LineStream {
 public:
  /// "-" is standard input.
  /// Error   Trouble::missing, naming the path and the system's reason.
  static Result<LineStream> open(const std::string& path);

  /// The next whole lines, at most some hundred kilobytes unless one line is longer; empty at the
  /// end. They last until the next call.
  /// Error   Trouble::missing where it cannot be read.
  Result<std::vector<StreamLine>> next();

  static constexpr std::size_t kLongest = std::size_t{1} << 24;

 private:
  LineStream(Descriptor file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  Result<void> fill();
  Result<void> skip_line();

  Descriptor file_;
  std::string name_;
  std::string room_;
  std::size_t used_ = 0;  ///< bytes of room_ handed out by the last call
  bool ended_ = false;
};

}  // namespace flatray
