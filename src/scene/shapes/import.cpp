#include <fmt/core.h>

#include "scene/reading/format.h"
#include "scene/shape.h"

namespace flatray::import_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"file", "\"outline.obj\"", kRequired},
                             {"format", "\"obj\"", "by the file's extension"},
                             {"scale", "number", "1"},
                             {"centre", "true or false", "false"}};

Result<const Format*> outline_format(Args& args, const std::string& file) {
  const std::string name = args.string("format");
  const Format* format = name.empty() ? format_for_name(file) : find_format(name);
  if (format != nullptr && format->outline != nullptr) return format;
  std::vector<std::string> known;
  for (const Format* one : formats())
    if (one->outline != nullptr) known.emplace_back(one->name);
  return fail(args.place(name.empty() ? "file" : "format"),
              fmt::format("'{}' is not an outline this program reads", name.empty() ? file : name),
              "formats of outlines: " + comma_list(known));
}

Result<Shape> build(Args& args) {
  const std::string file = args.string("file");
  const double scale = args.number("scale", 1);
  const bool centre = args.flag("centre");
  if (scale == 0)
    return fail(args.place("scale"), "a scale of 0 leaves nothing", "write another number");
  FLATRAY_TRY(format, outline_format(args, file));
  FLATRAY_TRY(source, args.imports().open(file, args.place("file")));
  Diagnostics warnings;
  Result<Shape> shape = args.imports().outline(*source, **format, scale, centre, warnings);
  args.warnings(std::move(warnings));
  return shape;
}

}  // namespace

extern const ShapeType entry = {"import", kKeys, &build};

}  // namespace flatray::import_shape
