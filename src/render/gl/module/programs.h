#pragma once
#include <array>

#include "render/gl/module/functions.h"

namespace flatray::gl {

/// What the shaders do, each made when it is first used.
enum class Task {
  paint,     ///< shows the light of the vertices
  gradient,  ///< shows the gradients that the vertices name
  sum,       ///< 1 where triangles run one way, -1 where they run the other
  find,      ///< what a sheet has at one sample: nothing where that is 0
  lay        ///< shows a sheet at one sample, faded by the vertices' first number
};

/// Texture units.
enum class Unit { gradients, stops, sheet };

class Programs {
 public:
  explicit Programs(const Functions& gl) : gl_(gl) {}

  /// Where the tile lies, for all that follows.
  struct TilePosition {
    float shift[2];
    int corner[2];  ///< of the film
  };
  void set(const TilePosition& place) { place_ = place; }

  /// Fails where this GL does not compile it. `multisampled`: the sheets are.
  void use(Task task, bool multisampled);
  /// Which sample of the sheet the task in use shows.
  void read_sample(int sample) { gl_.set_integer(sample_, sample); }
  void stop();

 private:
  struct Program {
    GLuint name = 0;
    GLint shift = -1, corner = -1, sample = -1;
  };
  bool make(Task task, bool multisampled, Program& program);

  const Functions& gl_;
  TilePosition place_{};
  std::array<Program, 10> programs_;  // by task, for sheets of pixels and of samples
  GLint sample_ = -1;                 // of the task in use
};

}  // namespace flatray::gl
