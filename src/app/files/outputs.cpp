#include "app/files/outputs.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "app/options/option_values.h"
#include "base/file.h"
#include "image/picture_format.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

struct Kind {
  std::string_view name, beginning;
};
// Besides pictures.
constexpr std::array<Kind, 4> kKinds = {{{"an SVG", "<?xml"},
                                         {"a page of HTML", "<!DOCTYPE html"},
                                         {"JSON", "{"},
                                         {"a text", ""}}};  // of none of these kinds

Kind kind_of(std::string_view content) {
  if (const PictureFormat* format = picture_format_of(std::as_bytes(std::span(content))))
    return {format->kind, format->beginning};
  return *std::ranges::find_if(
      kKinds, [&](const Kind& kind) { return content.starts_with(kind.beginning); });
}

// Of JSON the name that comes first, of a text each cell of its first line.
std::vector<std::string_view> first_words(const Kind& kind, std::string_view content) {
  if (kind.name == "JSON") return {content.substr(0, content.find(':'))};
  return split(content.substr(0, content.find('\n')), ',');
}

// Tables of one kind share a column at least, reports in JSON the first name.
bool are_alike(std::string_view there, std::string_view here) {
  const Kind kind = kind_of(here), other = kind_of(there);
  if (there.empty() || kind.name != other.name) return there.empty();
  if (kind.name != "JSON" && !kind.beginning.empty()) return true;
  if (here.starts_with(there)) return true;  // what a full disk left
  const auto theirs = first_words(kind, there), ours = first_words(kind, here);
  return std::find_first_of(ours.begin(), ours.end(), theirs.begin(), theirs.end()) != ours.end();
}

Result<std::string> beginning_of(const fs::path& path) {
  FLATRAY_TRY(file, open_regular(path, O_RDONLY, "read", Trouble::output));
  std::string content(4096, '\0');
  const ssize_t count = ::read(file->get(), content.data(), content.size());
  content.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return content;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Outputs::Outputs(const Arguments& arguments) : force_(arguments.has("force")), can_force_(true) {
  for (const std::string& operand : arguments.operands()) add_input(operand);
}

void Outputs::add_input(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) inputs_.emplace(status.st_dev, status.st_ino);
}

Result<void> Outputs::judge(const fs::path& path, std::string_view content, bool ours,
                            bool force) const {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return {};  // what else is wrong, writing tells
  std::string what;
  bool replaceable = true;
  if (S_ISLNK(status.st_mode)) {
    what = "is a link";
  } else if (!S_ISREG(status.st_mode)) {
    what = S_ISDIR(status.st_mode) ? "is a folder" : "is not a plain file";
    replaceable = false;
  } else if (inputs_.contains({status.st_dev, status.st_ino})) {
    what = "is an input of this command";
  } else if (ours) {
    return {};
  } else {
    FLATRAY_TRY(there, beginning_of(path));
    if (are_alike(*there, content)) return {};
    what = fmt::format("is there already, and nothing of the kind that is written here: {}",
                       kind_of(content).name);
  }
  if (replaceable && force) return {};
  return fail(named_place(path.string()), what,
              replaceable && can_force_ ? "name another file; --force replaces this one"
                                        : "name another file",
              Trouble::output);
}

Result<void> Outputs::allow(const fs::path& path, std::string_view content, bool ours) const {
  return judge(path, content, ours, force_).and_then([&] { return expect_writable(path); });
}

Result<void> Outputs::make_way(const fs::path& path, std::string_view content) const {
  if (auto allowed = judge(path, content, false, force_); !allowed || !force_) return allowed;
  if (!judge(path, content, false, false)) {
    std::error_code ignored;  // what stays, opening it tells
    fs::remove(path, ignored);
  }
  return {};
}

Result<void> Outputs::write(const fs::path& path, std::span<const std::byte> bytes) const {
  if (auto allowed = allow(path, text_of(bytes)); !allowed) return allowed;
  return write_file(path, bytes);
}

Result<void> Outputs::write(const fs::path& path, const std::string& text) const {
  return write(path, std::as_bytes(std::span(text)));
}

}  // namespace flatray
