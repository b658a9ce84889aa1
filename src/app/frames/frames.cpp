#include "app/frames/frames.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/options/arguments.h"
#include "app/options/option_values.h"

namespace flatray {
namespace {

constexpr const char* kFramesHint = "say frames and ranges, as 1..240:2,300";

struct FrameRange {
  std::uint64_t first, last, step = 1;
};

Result<std::uint64_t> frame_number(std::string_view text, const Place& where) {
  const std::optional<std::uint64_t> value = parse_whole(text);
  if (!value)
    return usage_error(where, fmt::format("'{}' is not a frame number", text), kFramesHint);
  if (*value < 1 || *value > kLastFrame)
    return usage_error(where, fmt::format("there is no frame {}", text),
                       fmt::format("frames run from 1 to {}", kLastFrame));
  return *value;
}

Result<FrameRange> parse_range(std::string_view text, const Place& where) {
  const std::size_t colon = text.find(':');
  const std::string_view span = text.substr(0, colon);
  const std::size_t dots = span.find("..");
  FLATRAY_TRY(first, frame_number(span.substr(0, dots), where));
  FrameRange range{*first, *first};
  if (dots != std::string_view::npos) {
    FLATRAY_TRY(last, frame_number(span.substr(dots + 2), where));
    range.last = *last;
  }
  if (range.last < range.first)
    return usage_error(where, fmt::format("'{}' runs backwards", text),
                       fmt::format("say {}..{}", range.last, range.first));
  if (colon == std::string_view::npos) return range;
  const std::optional<std::uint64_t> step = parse_whole(text.substr(colon + 1));
  if (!step || *step < 1 || dots == std::string_view::npos)
    return usage_error(where, fmt::format("'{}' has no step of 1 or more", text), kFramesHint);
  range.step = std::min<std::uint64_t>(*step, kLastFrame);  // a longer one ends the range as well
  return range;
}

}  // namespace

Result<std::vector<unsigned>> parse_frames(std::string_view text, const Place& where) {
  std::vector<FrameRange> ranges;
  std::uint64_t last = 0;
  for (const std::string_view part : split(text, ',')) {
    FLATRAY_TRY(range, parse_range(part, where));
    ranges.push_back(*range);
    last = std::max(last, range->last);
  }
  std::vector<bool> wanted(last + 1);
  for (const FrameRange& range : ranges)
    for (std::uint64_t k = range.first; k <= range.last; k += range.step) wanted[k] = true;
  std::vector<unsigned> frames;
  for (unsigned k = 1; k <= last; ++k)
    if (wanted[k]) frames.push_back(k);
  return frames;
}

Result<Shard> parse_shard(std::string_view text, const Place& where) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto index = parse_whole(text.substr(0, slash));
  const auto count = parse_whole(text.substr(std::min(slash + 1, text.size())));
  if (!index || !count)
    return usage_error(where, fmt::format("'{}' is not I/N", text), "as 0/3, 1/3 and 2/3");
  if (*count > kLastFrame)
    return usage_error(where, fmt::format("'{}' has too many shards", text),
                       fmt::format("N is {} at most", kLastFrame));
  if (*count < 1 || *index >= *count)
    return usage_error(where, fmt::format("there is no shard {}", text), "I runs from 0 to N - 1");
  return Shard{static_cast<unsigned>(*index), static_cast<unsigned>(*count)};
}

std::vector<unsigned> frames_of(const Shard& shard, const std::vector<unsigned>& frames) {
  std::vector<unsigned> part;
  for (std::size_t i = shard.index; i < frames.size(); i += shard.count) part.push_back(frames[i]);
  return part;
}

}  // namespace flatray
