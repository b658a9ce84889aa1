#pragma once
#include <string>
#include <variant>
#include <vector>

#include "geom/vec.h"
#include "image/image.h"

namespace flatray {

/// How a mark is painted. An ink is a role, which is dark on light paper and light on dark: "text",
/// "axis", "grid", "paper" or one of series_ink; or a fixed colour, "#rrggbb". "" paints nothing.
struct Pen {
  std::string stroke{}, fill{};
  double width = 1;      ///< of the stroke
  std::size_t dash = 0;  ///< by number, any; 0 is a whole line
};

/// Inks of curves that are told apart by those who see few colours, too: seven near the palette of
/// Okabe and Ito (2008), with a contrast of 3 or more to the paper, then from the first on.
std::string series_ink(std::size_t n);

/// A diagram: marks, one over the other, in units of which a letter is about seven wide; y points
/// down.
struct Drawing {
  struct Path {
    std::vector<Vec2> points;
    Pen pen;
    bool closed = false;
    bool bezier = false;  ///< the three or four points of a Bezier curve, of degree 2 or 3
    std::string title{};  ///< told by SVG to who points there
  };
  struct Disc {
    Vec2 centre;
    double radius;
    Pen pen;
  };
  struct Words {
    Vec2 at;  ///< half of a line's height above the baseline
    std::string words;
    double anchor = 0;  ///< which part of the words is left of `at`
    std::string ink = "text";
    bool upright = false;  ///< from below upwards
    bool bold = false;
  };
  /// Pixels as squares, as they are. In pixels a picture lies above all other marks.
  struct Picture {
    Vec2 corner, size;
    Image image;
  };
  std::string title;
  Vec2 size{0, 0};
  std::vector<std::variant<Path, Disc, Words, Picture>> marks{};
};

/// How wide words are at most, in units: of either writer's font.
double words_width(const std::string& words);

/// The diagram as SVG that follows what its reader's system prefers, dark or light, and shrinks to
/// the width it has. Gives   well-formed XML of any text given; the same bytes on every machine.
std::string svg(const Drawing& drawing);

/// The diagram on light paper, drawn by the software back end, `scale` pixels a unit; text is
/// ASCII, and question marks. The same bytes on every machine, whatever `threads`.
Image pixels(const Drawing& drawing, double scale, unsigned threads = 1);

/// Text as it stands between tags and in attributes; control characters become question marks.
std::string svg_text(const std::string& text);

/// A PNG as an address that pages and SVG take a picture from.
std::string data_address(const Image& image);

/// What an ink is: "#rrggbb".
std::string ink_colour(const std::string& ink, bool dark);

/// The numbers of dashes and gaps of a pen, in units.
std::vector<double> dashes_of(const Pen& pen);

}  // namespace flatray
