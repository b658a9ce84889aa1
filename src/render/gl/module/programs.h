#pragma once
#include <array>
#include <string>

#include "render/gl/module/functions.h"

namespace flatray::gl {

/// What the shaders do, each made when it is first used.
enum class Task {
  paint,    ///< shows the light of the vertices
  gradient  ///< shows the gradients that the vertices name
};

/// Texture units.
enum class Unit { gradients, stops };

class Programs {
 public:
  explicit Programs(const Functions& gl) : gl_(gl) {}

  /// Where the tile lies, for all that follows.
  struct Place {
    float shift[2];
    int corner[2];  ///< of the film
  };
  void set(const Place& place) { place_ = place; }

  /// False where this GL does not compile it.
  bool use(Task task, std::string& error);
  void stop();

 private:
  struct Program {
    GLuint name = 0;
    GLint shift = -1, corner = -1;
  };
  bool make(Task task, Program& program);

  const Functions& gl_;
  Place place_{};
  std::array<Program, 2> programs_;  // by task
};

}  // namespace flatray::gl
