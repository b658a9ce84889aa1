#include "app/files/output_pattern.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "app/options/arguments.h"
#include "app/options/option_values.h"
#include "base/entry_named.h"
#include "base/left_out.h"
#include "base/utf8.h"

namespace flatray {

namespace {

std::vector<std::string> endings(bool with_films) {
  std::vector<std::string> found;
  for (const PictureFormat* format : picture_formats())
    if (!format->is_video() && (with_films || format->of_film == nullptr))
      found.push_back(fmt::format(".{}", format->name));
  return found;
}

}  // namespace

std::vector<std::string> endings_of_frames() { return endings(true); }
std::vector<std::string> endings_of_pictures() { return endings(false); }

Result<const PictureFormat*> picture_format(const std::string& name, const Place& where) {
  if (const PictureFormat* format = find_picture_format(name)) return format;
  if (const auto problem = if_left_out(where, "picture", name))
    return tl::unexpected(Diagnostics{*problem});
  return usage_error(where,
                     fmt::format("unknown picture format '{}'{}", name,
                                 did_you_mean(name, picture_format_names())),
                     "say " + comma_list(picture_format_names()));
}

namespace {

// File systems allow 255 bytes; the temporary name beside the file needs some, the frame number and
// {scene} more.
constexpr std::size_t kLongestFileName = 120, kLongestPattern = 3000;

constexpr std::string_view kScene = "{scene}";
constexpr std::size_t kShownBytes = 40;  // of a name too long

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

// The last run of '#' in the file name.
FramePlace find_hashes(std::string_view text, std::size_t file_name) {
  const std::size_t last = text.find_last_of('#');
  if (last == std::string_view::npos || last < file_name) return {};
  std::size_t first = last;
  while (first > file_name && text[first - 1] == '#') --first;
  const std::size_t length = last + 1 - first;
  return {first, length, static_cast<int>(length)};
}

// %d or %0Nd in the file name, N one or two digits.
FramePlace find_percent(std::string_view text, std::size_t file_name) {
  for (std::size_t at = text.find('%', file_name); at != std::string_view::npos;
       at = text.find('%', at + 1)) {
    std::size_t end = at + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    const std::string_view digits = text.substr(at + 1, end - at - 1);
    if (end == text.size() || text[end] != 'd' || digits.size() > 3) continue;
    if (digits.empty()) return {at, end + 1 - at, 1};
    if (digits.front() != '0' || digits.size() < 2) continue;
    return {at, end + 1 - at, static_cast<int>(*parse_whole(digits))};
  }
  return {};
}

std::string with_scene(std::string text, std::string_view scene) {
  for (std::size_t at = text.find(kScene); at != std::string::npos;
       at = text.find(kScene, at + scene.size()))
    text.replace(at, kScene.size(), scene);
  return text;
}

// The first {word} of letters that is none of the placeholders; empty where there is none.
std::string unknown_placeholder(std::string_view text) {
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1)) {
    std::size_t end = at + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end == at + 1 || end == text.size() || text[end] != '}') continue;
    const std::string_view word = text.substr(at, end + 1 - at);
    if (word != kScene) return std::string(word);
  }
  return {};
}

// ".hdr, .pfm or .png".
std::string extensions() {
  const std::vector<std::string> names = picture_format_names();
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "." : i + 1 < names.size() ? ", ." : " or .") + names[i];
  return text;
}

Result<const PictureFormat*> format_of(const std::string& text,
                                       const std::optional<std::string>& wanted,
                                       const Place& where) {
  if (text == "-") return picture_format(wanted.value_or("png"), named_place("--format"));
  const std::string extension = lower_case(std::filesystem::path(text).extension().string());
  if (extension.empty() && wanted) return picture_format(*wanted, named_place("--format"));
  const std::string name = extension.substr(extension.empty() ? 0 : 1);
  if (find_picture_format(name) == nullptr && !if_left_out(where, "picture", name))
    return usage_error(where, fmt::format("'{}' does not end in {}", text, extensions()),
                       "end the name in one of them, as picture.png");
  if (wanted && lower_case(*wanted) != name)
    return usage_error(where, fmt::format("'{}' is not a name for --format {}", text, *wanted),
                       fmt::format("end it in .{}, or leave --format out", *wanted));
  return picture_format(name, where);
}

}  // namespace

OutputPattern::OutputPattern(std::string text, const PictureFormat& format)
    : text_(std::move(text)), format_(&format) {
  const std::size_t slash = text_.find_last_of('/');
  const std::size_t file_name = slash == std::string::npos ? 0 : slash + 1;
  place_ = find_hashes(text_, file_name);
  if (place_.length == 0) place_ = find_percent(text_, file_name);
}

Result<OutputPattern> OutputPattern::parse(std::string text,
                                           const std::optional<std::string>& format,
                                           const Place& where) {
  if (text.empty()) return usage_error(where, "is empty", "say a file name, as out/####.png");
  if (text.back() == '/')
    return usage_error(where, fmt::format("'{}' is a folder", text),
                       fmt::format("say {}frame_####.png", text));
  if (const std::string word = unknown_placeholder(text); !word.empty())
    return usage_error(where, fmt::format("unknown {}", word),
                       "known: {scene}; a name with such braces can be given to the file later");
  if (text.size() > kLongestPattern)
    return usage_error(where, fmt::format("the path has {} bytes", text.size()),
                       fmt::format("at most {} with its folders", kLongestPattern));
  FLATRAY_TRY(known, format_of(text, format, where));
  OutputPattern pattern(std::move(text), **known);
  const std::string name = pattern.path(kScene, 1).filename();
  if (name.size() > kLongestFileName)
    return usage_error(where, fmt::format("the file name has {} bytes", name.size()),
                       fmt::format("at most {} in the name", kLongestFileName));
  if (pattern.has_frame() && utf8_prefix(name) < name.size())
    return usage_error(where, "names files by bytes that are not UTF-8, which no record can hold",
                       "write the name in UTF-8");
  return pattern;
}

OutputPattern OutputPattern::standard(bool sequence, const PictureFormat& format) {
  const char* stem = sequence && !format.is_video() ? "out/{scene}/frame_####." : "out/{scene}.";
  return {std::string(stem) + format.name, format};
}

std::filesystem::path OutputPattern::with_number(std::string_view scene,
                                                 const std::string& number) const {
  std::string result = text_;
  if (has_frame()) result.replace(place_.at, place_.length, number);
  return with_scene(std::move(result), scene);
}

std::filesystem::path OutputPattern::path(std::string_view scene, unsigned frame) const {
  return with_number(scene, fmt::format("{:0{}}", frame, place_.digits));
}

std::string OutputPattern::file_pattern(std::string_view scene) const {
  return with_number(scene, std::string(static_cast<std::size_t>(place_.digits), '#')).filename();
}

std::optional<std::filesystem::path> OutputPattern::link_chosen_by(std::string_view scene) const {
  std::filesystem::path folder;
  for (const std::filesystem::path& part : std::filesystem::path(text_).parent_path()) {
    folder /= with_scene(part.string(), scene);
    std::error_code ignored;
    const bool chosen = part.string().find(kScene) != std::string::npos;
    if (chosen && std::filesystem::is_symlink(folder, ignored)) return folder;
  }
  return std::nullopt;
}

std::string plain_letters(std::string text) {
  for (char& c : text)
    if (!is_letter(c) && !is_digit(c) && c != '_' && c != '-' && c != '.') c = '_';
  return text;
}

Result<std::string> plain_name(std::string_view scene) {
  if (scene.size() > kLongestName)
    return usage_error(named_place(fmt::format("{}...", scene.substr(0, kShownBytes))),
                       fmt::format("the scene's name has {} bytes", scene.size()),
                       fmt::format("at most {} can name the output; say -o FILE", kLongestName));
  std::string name = plain_letters(std::string(scene));
  if (name.empty()) return std::string("scene");
  if (name.front() == '.' || name.front() == '-') name.front() = '_';
  if (name.back() == '.') name.back() = '_';
  const std::string stem = lower_case(name.substr(0, name.find('.')));
  const bool numbered = stem.size() == 4 && is_digit(stem[3]) &&
                        (stem.substr(0, 3) == "com" || stem.substr(0, 3) == "lpt");
  // Names of devices on some systems, with any extension.
  static constexpr std::array<std::string_view, 4> kDevices = {"con", "nul", "aux", "prn"};
  if (numbered || std::ranges::find(kDevices, stem) != kDevices.end())
    name.insert(name.begin(), '_');
  return name;
}

}  // namespace flatray
