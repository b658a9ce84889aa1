#include "image/picture_format.h"

#include <algorithm>

#include "base/entry_named.h"

namespace flatray {

#include "pictures.inc"  // picture_formats()

std::vector<std::string> picture_format_names() {
  std::vector<std::string> names;
  for (const PictureFormat* format : picture_formats()) names.emplace_back(format->name);
  return names;
}

namespace {

template <class Is>
const PictureFormat* first_that(const Is& is) {
  const auto all = picture_formats();
  const auto found = std::find_if(all.begin(), all.end(), is);
  return found == all.end() ? nullptr : *found;
}

}  // namespace

const PictureFormat* find_picture_format(std::string_view name) {
  return entry_named(picture_formats(), name);
}

const PictureFormat* picture_format_of(std::span<const std::byte> content) {
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  const auto begins = [&](const PictureFormat* format) {
    return text.starts_with(format->beginning);
  };
  const PictureFormat* read_back = first_that([&](const PictureFormat* format) {
    return begins(format) && (format->read_picture != nullptr || format->read_light != nullptr);
  });
  return read_back != nullptr ? read_back : first_that(begins);
}

PictureFormat::Bytes PictureFormat::encode(const Image& image) const {
  PngEncoder png(1);
  return of_picture(image, png, [](int, int) { return true; });
}

}  // namespace flatray
