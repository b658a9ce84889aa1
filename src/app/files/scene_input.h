#pragma once
#include <algorithm>
#include <array>

#include "anim/frame_state.h"
#include "app/options/arguments.h"
#include "scene/load.h"

namespace flatray {

/// Options several verbs have, so that they mean the same everywhere.
inline constexpr Option kDefineOption = {"define", 'D', "KEY=VALUE",
                                         "change a key of the scene, as -D film.size=[64,64]",
                                         OptionKind::list};
inline constexpr Option kMaxPixelsOption = {"max-pixels", '\0', "N",
                                            "most pixels a picture may have (default 268435456)"};
inline constexpr Option kMaxEntitiesOption = {
    "max-entities", '\0', "N", "most entities a scene may have, copies too (default 1000000)"};
inline constexpr Option kMaxCornersOption = {
    "max-corners", '\0', "N",
    "most corners a scene may have, copies too, and draw in a frame (default 33554432)"};
inline constexpr Option kMaxBytesOption = {
    "max-bytes", '\0', "N", "most bytes of a scene and all its files (default 1073741824)"};
inline constexpr Option kMaxDepthOption = {
    "max-depth", '\0', "N", "most groups in groups, and files in files (default 64)"};
inline constexpr Option kSeedOption = {"seed", '\0', "N",
                                       "seed of all draws instead of the scene's"};
inline constexpr Option kThreadsOption = {"jobs", 'j', "N",
                                          "threads (default: all of the machine)"};
inline constexpr Option kForceOption = {
    "force", '\0', "", "also replace inputs, and what no such command wrote", OptionKind::flag};
inline constexpr Option kFrameOption = {"frame", 'f', "K",
                                        "frame whose positions are used (default 1)"};
inline constexpr Option kJsonOption = {"json", '\0', "", "print one JSON object", OptionKind::flag};
inline constexpr Option kCsvOption = {"csv", '\0', "", "print comma-separated values",
                                      OptionKind::flag};
inline constexpr Option kQuietOption = {"quiet", 'q', "", "print no warnings and no summary",
                                        OptionKind::flag};

/// A verb's own options and those of every verb that reads scenes.
template <std::size_t count>
constexpr auto with_scene_options(const Option (&own)[count]) {
  constexpr std::array kShared = {kDefineOption,     kMaxPixelsOption, kMaxEntitiesOption,
                                  kMaxCornersOption, kMaxDepthOption,  kMaxBytesOption,
                                  kQuietOption};
  std::array<Option, count + kShared.size()> all{};
  std::copy(kShared.begin(), kShared.end(), std::copy(own, own + count, all.begin()));
  return all;
}

/// --max-pixels, --seed, -j as given, or their defaults.
Result<std::uint64_t> max_pixels(const Arguments& arguments);
Result<std::uint64_t> seed(const Arguments& arguments, const Scene& scene);
Result<unsigned> threads(const Arguments& arguments);

/// Loads a scene with the -D of the command line, then `more`. Its warnings are not printed yet.
Result<LoadedScene> load_input(const Arguments& arguments, const std::string& path,
                               const std::vector<Override>& more = {});

/// The same with the scene's description.
Result<ReadScene> read_input(const Arguments& arguments, const std::string& path,
                             const std::vector<Override>& more = {});

/// The same for verbs of one scene: the first operand, its warnings printed.
Result<Scene> load_only_input(const Arguments& arguments);

/// State of the scene at --frame with --seed.
Result<FrameState> frame_of(const Arguments& arguments, const Scene& scene);

}  // namespace flatray
