// `-D key=value`, a line each, on a scene with something under every key.
#include "fuzz/loading.h"

namespace {

constexpr const char* kScene = R"(flatray = 1
film = { size = [32, 20], world = [[-1, -2], [30, 40]], background = "#01020304" }
camera = { follow = "runner", offset = [3, 4] }
[[entity]]
name = "runner"
shape = { box = { min = [0, 0], max = [4, 4] } }
velocity = [12, 0.5]
stroke = { width = 0.5, colour = "#102030" }
markov = { chain = "run", start = "RUN" }
states = { RUN = [{ fill = "#000001" }, { fill = "none" }] }
[[ray]]
at = [15, 5]
direction = [1, -1e-3]
[markov.run]
hold = 10
RUN = { RUN = 0.25, DIE = 0.75 }
DIE = { DIE = 1 }
)";

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatray;
  const OneSecond limit;
  std::vector<Override> overrides;
  std::string rest = text_of(data, size);
  for (std::size_t begin = 0; begin < rest.size() && overrides.size() < 16;) {
    const std::size_t end = std::min(rest.find('\n', begin), rest.size());
    const std::string line = rest.substr(begin, end - begin);
    const std::size_t equals = std::min(line.find('='), line.size());
    overrides.push_back({line.substr(0, equals), line.substr(std::min(equals + 1, line.size()))});
    begin = end + 1;
  }
  (void)load_fuzzed("f.toml", kScene, overrides);
  return 0;
}
