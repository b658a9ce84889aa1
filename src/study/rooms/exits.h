#pragma once
#include <array>

#include "study/plots/plot.h"
#include "study/rooms/pixel_map.h"

namespace flatray {

/// How orbits of starts drawn on the walls leave a room by its holes: by which, after how many
/// bounces, on how long a way, where along the hole and under which angle.
///
/// What leaves late does so as the conditionally invariant measure has it: that of what is left
/// after long, which is spread the same at every later bounce, but for its size.
class Exits {
 public:
  /// `late`: from so many bounces on they count as such; none where orbits do not leave
  /// exponentially.
  Exits(const ExperimentContext& context, const Room& room, std::span<const PixelOutcome> drawn,
        std::optional<double> late);

  /// By hole, of those that leave at the first wall, mean bounces and ways.
  ///
  /// Gives   of starts by the measure that reflection keeps the share that leaves at the first wall
  ///         is the holes' share of the walls, whatever the room. Means have errors where orbits
  ///         leave exponentially; else their variance may be infinite.
  std::vector<Measure> measures() const;
  /// By hole, place and sine.
  Table table() const;
  Plot plot_of_places() const;
  Plot plot_of_sines() const;

 private:
  static constexpr std::size_t kCells = 20;  // of a hole, and of the sine
  using Grid = std::array<std::array<double, kCells>, kCells>;
  struct Hole {
    std::uint32_t surface;
    std::string name;
    Grid all{}, late{};  // by place, then sine
  };
  void add(const PixelOutcome& one, bool is_late);
  Measure mean(std::string name, const std::function<double(const PixelOutcome&)>& of,
               double from) const;
  Plot plot_by(std::string title, std::string x_label,
               double (*x_of)(std::size_t hole, std::size_t place, std::size_t sine)) const;

  const ExperimentContext& context_;
  const Room& room_;
  std::span<const PixelOutcome> drawn_;
  std::optional<double> late_;
  std::vector<Hole> holes_;
  double left_ = 0, left_late_ = 0;
};

/// Holes of the walls by surface.
std::vector<std::uint32_t> holes_of(const Room& room);
/// The length of some walls.
double length_of(const Room& room, std::span<const std::uint32_t> surfaces);

}  // namespace flatray
