#include "image/picture_format.h"

#include "base/entry_named.h"

namespace flatray {

#include "pictures.inc"  // picture_formats()

std::vector<std::string> picture_format_names() { return names_of(picture_formats()); }

const PictureFormat* find_picture_format(std::string_view name) {
  return entry_named(picture_formats(), name);
}

const PictureFormat* picture_format_by_name(const std::filesystem::path& file) {
  const std::string end = lower_case(file.extension().string());
  return end.empty() ? nullptr : find_picture_format(end.substr(1));
}

const PictureFormat* picture_format_of(std::span<const std::byte> content) {
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  const PictureFormat* first = nullptr;
  for (const PictureFormat* format : picture_formats()) {
    if (!text.starts_with(format->beginning)) continue;
    if (format->read_picture != nullptr || format->read_light != nullptr) return format;
    if (first == nullptr) first = format;
  }
  return first;
}

PictureFormat::Bytes PictureFormat::encode(const Image& image) const {
  PngEncoder png(1);
  return of_picture(image, png, [](int, int) { return true; });
}

}  // namespace flatray
