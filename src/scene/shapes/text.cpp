
#include "base/counted.h"
#include "scene/outlines/easy_font.h"
#include "scene/shape.h"

namespace flatray::text_shape {
namespace {

enum class Align { left, centre, right };
constexpr Word<Align> kAligns[] = {
    {"left", Align::left}, {"centre", Align::centre}, {"right", Align::right}};

constexpr KeyInfo kKeys[] = {{"string", "\"TEXT\"", kRequired},
                             {"size", "number or a curve", kRequired},
                             {"align", R"("left", "centre" or "right")", R"("left")"}};

// What the font lacks becomes a question mark; one character of several bytes is one of those.
std::string printable(Args& args, const std::string& text) {
  std::string shown;
  std::size_t lacking = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n' || (byte >= ' ' && byte <= '~')) {
      shown += c;
    } else if ((byte & 0xC0U) != 0x80U) {
      shown += '?';
      ++lacking;
    }
  }
  if (lacking > 0)
    args.warning(args.place("string"), "the font lacks " + counted(lacking, "character"),
                 "it has those of ASCII; a question mark stands for any other");
  return shown;
}

Result<Shape> build(Args& args) {
  const std::string text = printable(args, args.string("string"));
  const double scale = args.size("size") / kFontCapitals;
  const double before = 0.5 * static_cast<int>(args.word<Align>("align", Align::left, kAligns));
  if (args.gone()) return Shape{};
  Shape shape;
  int baseline = 0;
  for (std::size_t begin = 0; begin <= text.size(); baseline -= kFontLineStep) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const FontLine line = font_line(std::string_view(text).substr(begin, end - begin));
    add_line(shape, line, {-before * line.width, baseline}, scale);
    begin = end + 1;
  }
  if (shape.piece_count() == 0)
    return fail(args.place("string"), "the text shows nothing", "write some letters");
  const Vec2 one = shape.vertices[1] - shape.vertices[0];
  if (!(one.x() > 0) || !(shape.vertices.back().cwiseAbs().maxCoeff() <= kFarthest))
    return fail(args.place("size"), "letters of this size are lost in rounding",
                "write a size between 1e-290 and 1e290");
  return shape;
}

}  // namespace

extern const ShapeType entry = {"text", kKeys, &build};

}  // namespace flatray::text_shape
