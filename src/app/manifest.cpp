#include "app/manifest.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/option_values.h"
#include "base/file.h"
#include "base/hash.h"
#include "image/png.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Longer lines are not records of ours; this also bounds how deep a hostile one can nest.
constexpr std::size_t kLongestLine = 4096;

std::string shard_suffix(const Shard& shard) {
  return shard.count == 1 ? "" : fmt::format(".{}-of-{}", shard.index, shard.count);
}

// A field of the wrong kind is as good as none.
std::string text_of(const JsonValue& record, const char* field) {
  const JsonValue* value = record.find(field);
  return value == nullptr ? "" : value->as_text().value_or("");
}
unsigned number_of(const JsonValue& record, const char* field) {
  const JsonValue* value = record.find(field);
  const std::uint64_t number = value == nullptr ? 0 : value->as_whole().value_or(0);
  return number > kMostPixels ? 0 : static_cast<unsigned>(number);
}

// None where there is no file.
template <class Take>
Result<void> each_line(const fs::path& path, const Take& take) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  Result<std::string> text = read_file(path);
  if (!text) {
    for (Diagnostic& problem : text.error()) problem.trouble = Trouble::output;
    return fail(std::move(text));
  }
  std::string_view rest = *text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    take(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

}  // namespace

JsonValue as_value(const FrameRecord& record) {
  return Fields{{"frame", record.frame},   {"file", record.file},      {"width", record.width},
                {"height", record.height}, {"pixels", record.pixels},  {"bytes", record.bytes},
                {"scene", record.scene},   {"backend", record.backend}};
}

std::string manifest_line(const FrameRecord& record) { return json_text(as_value(record)); }

std::optional<FrameRecord> parse_manifest_line(std::string_view line) {
  if (line.size() > kLongestLine) return std::nullopt;
  const std::optional<JsonValue> value = parse_json(line);
  if (!value) return std::nullopt;
  FrameRecord record;
  record.frame = number_of(*value, "frame");
  record.file = text_of(*value, "file");
  record.width = static_cast<int>(number_of(*value, "width"));
  record.height = static_cast<int>(number_of(*value, "height"));
  record.pixels = text_of(*value, "pixels");
  record.bytes = text_of(*value, "bytes");
  record.scene = text_of(*value, "scene");
  // Lines of versions that had one back end only do not name it.
  if (value->find("backend") != nullptr) record.backend = text_of(*value, "backend");
  if (record.frame == 0 || record.file.empty() || record.bytes.empty()) return std::nullopt;
  return record;
}

fs::path manifest_path(const fs::path& folder, const Shard& shard) {
  return folder / fmt::format("manifest{}.jsonl", shard_suffix(shard));
}
fs::path timings_path(const fs::path& folder, const Shard& shard) {
  return folder / fmt::format("timings{}.jsonl", shard_suffix(shard));
}

Result<Records> read_manifest(const fs::path& path) {
  Records records;
  auto read = each_line(path, [&](std::string_view line) {
    if (std::optional<FrameRecord> record = parse_manifest_line(line))
      records[record->file] = *record;
  });
  if (!read) return fail(std::move(read));
  return records;
}

Result<Records> read_other_manifests(const fs::path& path) {
  std::vector<fs::path> others;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_of(path), ignored)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("manifest.") && name.ends_with(".jsonl") && name != path.filename())
      others.push_back(entry.path());
  }
  std::sort(others.begin(), others.end());
  Records records;
  for (const fs::path& other : others) {
    Result<Records> more = read_manifest(other);
    if (!more) return more;
    records.merge(*more);
  }
  return records;
}

Result<Timings> read_timings(const fs::path& path) {
  Timings timings;
  auto read = each_line(path, [&](std::string_view line) {
    if (line.size() > kLongestLine) return;
    const std::optional<JsonValue> value = parse_json(line);
    if (!value || value->find("seconds") == nullptr) return;
    if (const unsigned frame = number_of(*value, "frame"); frame != 0) timings[frame] = line;
  });
  if (!read) return fail(std::move(read));
  return timings;
}

Result<void> write_manifest(const fs::path& path, const Records& records) {
  std::vector<const FrameRecord*> sorted;
  for (const auto& [file, record] : records) sorted.push_back(&record);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return a->frame < b->frame; });
  std::string text;
  for (const FrameRecord* record : sorted) text += manifest_line(*record) + "\n";
  return write_file(path, text);
}

bool is_whole(const FrameRecord& record, const fs::path& folder, PictureFormat format) {
  const Result<std::string> bytes = read_file(folder / record.file);
  if (!bytes) return false;
  if (Hash().add(std::as_bytes(std::span(*bytes))).hex() != record.bytes) return false;
  if (format != PictureFormat::png) return true;
  const Result<Image> image = decode_png(std::as_bytes(std::span(*bytes)), record.file);
  return image && image->width == record.width && image->height == record.height &&
         pixel_hash(*image) == record.pixels;
}

}  // namespace flatray
