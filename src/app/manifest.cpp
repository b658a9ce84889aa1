#include "app/manifest.h"

#include <fmt/core.h>

#include "app/journal.h"
#include "app/option_values.h"
#include "base/file.h"
#include "base/hash.h"
#include "image/hdr.h"
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
unsigned number_of(const JsonValue& record, const char* field) {
  const JsonValue* value = record.find(field);
  const std::uint64_t number = value == nullptr ? 0 : value->as_whole().value_or(0);
  return number > kMostPixels ? 0 : static_cast<unsigned>(number);
}

}  // namespace

JsonValue as_value(const FrameRecord& record) {
  return Fields{{"frame", record.frame},   {"file", record.file},     {"width", record.width},
                {"height", record.height}, {"pixels", record.pixels}, {"bytes", record.bytes},
                {"scene", record.scene},   {"seed", record.seed},     {"backend", record.backend}};
}

std::string manifest_line(const FrameRecord& record) { return json_text(as_value(record)); }

std::optional<FrameRecord> parse_manifest_line(std::string_view line) {
  if (line.size() > kLongestLine) return std::nullopt;
  const std::optional<JsonValue> value = parse_json(line);
  if (!value) return std::nullopt;
  FrameRecord record;
  record.frame = number_of(*value, "frame");
  record.file = value->text_of("file");
  record.width = static_cast<int>(number_of(*value, "width"));
  record.height = static_cast<int>(number_of(*value, "height"));
  record.pixels = value->text_of("pixels");
  record.bytes = value->text_of("bytes");
  record.scene = value->text_of("scene");
  if (const JsonValue* seed = value->find("seed")) record.seed = seed->as_whole().value_or(0);
  // Lines of versions that had one back end only do not name it.
  if (value->find("backend") != nullptr) record.backend = value->text_of("backend");
  // A name with folders in it would lead elsewhere.
  if (record.frame == 0 || record.bytes.empty() || record.file.empty() ||
      record.file.find('/') != std::string::npos)
    return std::nullopt;
  return record;
}

fs::path manifest_path(const fs::path& folder, const Shard& shard) {
  return folder / fmt::format("manifest{}.jsonl", shard_suffix(shard));
}
fs::path timings_path(const fs::path& folder, const Shard& shard) {
  return folder / fmt::format("timings{}.jsonl", shard_suffix(shard));
}

std::vector<fs::path> manifests_in(const fs::path& folder) {
  std::vector<fs::path> files = files_in(folder);
  std::erase_if(files, [](const fs::path& path) {
    const std::string name = path.filename();
    return !name.starts_with("manifest.") || !name.ends_with(".jsonl");
  });
  return files;
}

Records records_of(std::string_view text) {
  Records records;
  each_line(text, [&](std::string_view line) {
    if (std::optional<FrameRecord> record = parse_manifest_line(line))
      records[record->file] = std::move(*record);
  });
  return records;
}

bool is_whole(const FrameRecord& record, const fs::path& folder) {
  const Result<std::string> bytes = read_regular_file(folder / record.file);
  if (!bytes) return false;
  const auto content = std::as_bytes(std::span(*bytes));
  if (Hash().add(content).hex() != record.bytes) return false;
  if (is_hdr(content)) return true;
  const Result<Image> image = decode_png(content, record.file);
  return image && image->width == record.width && image->height == record.height &&
         pixel_hash(*image) == record.pixels;
}

}  // namespace flatray
