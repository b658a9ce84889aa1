#include "app/files/manifest.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/journal.h"
#include "app/options/option_values.h"
#include "base/file.h"
#include "base/hash.h"
#include "image/picture_format.h"

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
  const std::uint64_t number = record.whole_of(field).value_or(0);
  return number > kMostPixels ? 0 : static_cast<unsigned>(number);
}

}  // namespace

JsonValue as_value(const FrameRecord& record) {
  Fields fields{{"frame", record.frame},   {"file", record.file},     {"width", record.width},
                {"height", record.height}, {"pixels", record.pixels}, {"bytes", record.bytes},
                {"scene", record.scene},   {"seed", record.seed},     {"backend", record.backend}};
  if (record.light) fields.emplace_back("light", as_value(*record.light));
  if (!record.error_image.empty()) fields.emplace_back("error_image", record.error_image);
  if (!record.error_file.empty()) fields.emplace_back("error_file", record.error_file);
  return fields;
}

JsonValue as_value(const LightRecord& light) {
  Fields fields{{"rays", light.rays}};
  if (light.rounds > 0)  // what is followed from its pixels has none, and no end of a leg
    fields.insert(fields.end(), {{"legs", light.legs},
                                 {"rounds", light.rounds},
                                 {"absorbed", light.absorbed},
                                 {"escaped", light.escaped},
                                 {"corners", light.corners},
                                 {"cut_off", light.cut_off},
                                 {"gambled", light.gambled}});
  if (light.error) fields.emplace_back("error", *light.error);
  return fields;
}

LightRecord record_of(const LightReport& report) {
  const LightCounts& counts = report.counts;
  const auto emitted = static_cast<double>(std::max<std::int64_t>(counts.emitted, 1));
  const auto share = [&](std::int64_t part) { return static_cast<double>(part) / emitted; };
  return {counts.rays,           counts.legs,
          report.rounds,         share(counts.absorbed),
          share(counts.escaped), share(counts.at_corners),
          share(counts.cut_off), share(counts.gambled),
          report.error};
}

namespace {

LightRecord light_in(const JsonValue& value) {
  const auto whole = [&](const char* field) { return value.whole_of(field).value_or(0); };
  const auto share = [&](const char* field) { return value.number_of(field).value_or(0); };
  return {whole("rays"),     whole("legs"),    whole("rounds"),
          share("absorbed"), share("escaped"), share("corners"),
          share("cut_off"),  share("gambled"), value.number_of("error")};
}

}  // namespace

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
  record.seed = value->whole_of("seed").value_or(record.seed);
  // Lines of versions that had one back end only do not name it.
  if (value->find("backend") != nullptr) record.backend = value->text_of("backend");
  if (const JsonValue* light = value->find("light")) record.light = light_in(*light);
  record.error_image = value->text_of("error_image");
  record.error_file = value->text_of("error_file");
  // A name with folders in it would lead elsewhere.
  if (record.frame == 0 || record.bytes.empty() || record.file.empty() ||
      (record.file + record.error_file).find('/') != std::string::npos)
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
  const PictureFormat* format = picture_format_of(content);
  if (format == nullptr || format->read_picture == nullptr) return format != nullptr;
  const Result<Image> image = format->read_picture(content, record.file);
  return image && image->width == record.width && image->height == record.height &&
         pixel_hash(*image) == record.pixels;
}

bool is_error_image(const FrameRecord& record, const fs::path& path) {
  const Result<std::string> bytes = read_regular_file(path);
  return bytes && Hash().add(std::as_bytes(std::span(*bytes))).hex() == record.error_image;
}

}  // namespace flatray
