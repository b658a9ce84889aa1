#include "image/compare.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "app/files/output_pattern.h"
#include "app/files/outputs.h"
#include "app/files/scene_input.h"
#include "app/options/places.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/file.h"
#include "base/parallel.h"
#include "base/shown_text.h"
#include "image/hdr.h"
#include "image/metric.h"
#include "image/picture_format.h"
#include "image/png.h"

namespace flatray::compare_verb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> metric_names() { return names_of(metrics()); }

Result<const Metric*> metric_called(const std::string& name, const Place& where) {
  return word_of(name, where, metric_names()).map([](std::size_t i) { return metrics()[i]; });
}

struct Options : Arguments {
  const Metric* metric = nullptr;
  std::optional<fs::path> diff;
  unsigned threads = 1;

  void rows(OptionTable& row) {
    row("--metric NAME", "also print this number: flatray list metrics", metric, &metric_called,
        &metric_names);
    row("--diff OUT.png", "write the difference x16; of two folders, a folder", diff, &as_text);
    row(kForceRow);
    row_of_threads(row, threads);
    row(kJsonRow);
  }
};

struct Pair {
  std::string name;  ///< below both folders; "" for two files
  fs::path actual, expected;
};

struct Outcome {
  Difference difference;
  std::optional<double> metric{};
  const char* unit = "levels";
};

bool is_read(const PictureFormat& format) {
  return format.read_picture != nullptr || format.read_light != nullptr;
}

Result<std::vector<std::string>> pictures_below(const fs::path& folder) {
  FLATRAY_TRY(files, files_below(folder));
  std::vector<std::string> names;
  Diagnostics links;
  for (const fs::path& path : *files) {
    std::error_code error;
    if (fs::is_symlink(path, error) && fs::is_directory(path, error))
      links.push_back({named_place(path.string()), "is a link to a folder, which is not followed",
                       "put the pictures there, or compare the folder itself", Trouble::missing});
    const PictureFormat* format = picture_format_by_name(path);
    if (format != nullptr && is_read(*format))
      names.push_back(path.lexically_relative(folder).generic_string());
  }
  if (!links.empty()) return tl::unexpected(std::move(links));
  std::ranges::sort(names);
  return names;
}

void expect_all(const std::vector<std::string>& names, const std::vector<std::string>& others,
                const fs::path& other_folder, Diagnostics& problems) {
  for (const std::string& name : names)
    if (!std::ranges::binary_search(others, name))
      problems.push_back({named_place((other_folder / name).string()), "is missing",
                          "both folders must hold the same pictures", Trouble::missing});
}

struct Pairs {
  std::vector<Pair> all;
  Diagnostics problems{};  ///< of pictures that have no pair
};

Result<Pairs> pairs(const std::string& a, const std::string& b) {
  std::error_code error;
  const bool folder_a = fs::is_directory(a, error), folder_b = fs::is_directory(b, error);
  for (const std::string& one : {a, b})
    if (!fs::exists(one, error))
      return fail(named_place(one), "is not there", "", Trouble::missing);
  if (folder_a != folder_b)
    return usage_error(named_place(folder_a ? a : b), "is a folder and the other is not",
                       "compare two pictures or two folders");
  if (!folder_a) return Pairs{{{"", a, b}}};
  FLATRAY_TRY(names_a, pictures_below(a));
  FLATRAY_TRY(names_b, pictures_below(b));
  if (names_a->empty() && names_b->empty())
    return fail(named_place(a), "holds no PNG, HDR or PFM", "", Trouble::missing);
  Pairs pairs;
  expect_all(*names_a, *names_b, b, pairs.problems);
  expect_all(*names_b, *names_a, a, pairs.problems);
  for (const std::string& name : *names_a)
    if (std::ranges::binary_search(*names_b, name))
      pairs.all.push_back({name, fs::path(a) / name, fs::path(b) / name});
  return pairs;
}

struct Picture {
  Image image;
  std::optional<LinearImage> light;  // of a format that holds it
};

Result<Picture> read_picture(const std::string& path, bool named) {
  ReadLimits limits{.bytes = kMostPictureBytes, .pipes = named};
  for (const PictureFormat* format : picture_formats())
    if (is_read(*format)) limits.begins.push_back(format->beginning);
  FLATRAY_TRY(content, read_file(path, limits));
  const auto bytes = std::as_bytes(std::span(*content));
  const PictureFormat* format = picture_format_of(bytes);
  if (format != nullptr && format->read_light != nullptr) {
    FLATRAY_TRY(light, format->read_light(bytes, path));
    return Picture{develop(*light), std::move(*light)};
  }
  FLATRAY_TRY(image, format != nullptr && format->read_picture != nullptr
                         ? format->read_picture(bytes, path)
                         : decode_png(bytes, path));
  return Picture{std::move(*image), std::nullopt};
}

// Of two pictures as shown or, where both hold it, of their light.
template <class Image>
Result<Outcome> measure(const Image& actual, const Image& expected, const Metric* metric,
                        double (*Metric::*value)(const Image&, const Image&),
                        const std::optional<fs::path>& diff, const Outputs& outputs) {
  FLATRAY_TRY(difference, compare(actual, expected));
  if (diff) {
    FLATRAY_TRY(written, outputs.write(*diff, encode_png(difference_image(actual, expected))));
  }
  Outcome outcome{*difference};
  if (metric != nullptr) outcome.metric = (metric->*value)(actual, expected);
  return outcome;
}

// Where the difference of a pair is written: in a folder a PNG whose name no other pair has.
std::optional<fs::path> diff_of(const Pair& pair, const std::vector<Pair>& all,
                                const std::optional<fs::path>& diff) {
  if (!diff || pair.name.empty()) return diff;
  std::string name = pair.name;
  while (fs::path(name).extension() != ".png" ||
         (name != pair.name && std::ranges::binary_search(all, name, {}, &Pair::name)))
    name += ".png";
  return *diff / name;
}

Result<Outcome> measure(const Pair& pair, const Metric* metric, const std::optional<fs::path>& path,
                        const Outputs& outputs) {
  const bool named = pair.name.empty();
  FLATRAY_TRY(a, read_picture(pair.actual.string(), named));
  FLATRAY_TRY(b, read_picture(pair.expected.string(), named));
  const bool of_light = a->light && b->light;
  Result<Outcome> outcome =
      of_light ? measure(*a->light, *b->light, metric, &Metric::of_light, path, outputs)
               : measure(a->image, b->image, metric, &Metric::value, path, outputs);
  if (!outcome && !outcome.error().front().where)
    outcome.error().front().where = named_place(pair.actual.string());
  if (outcome) outcome->unit = of_light ? "light" : "levels";
  return outcome;
}

JsonValue as_value(const Pair& pair, const Outcome& outcome, const Metric* metric) {
  const Difference& difference = outcome.difference;
  Fields fields = {{"actual", pair.actual.string()},  {"expected", pair.expected.string()},
                   {"equal", difference.pixels == 0}, {"unit", outcome.unit},
                   {"pixels", difference.pixels},     {"worst", difference.worst}};
  if (difference.pixels != 0)
    fields.emplace_back("at", Fields{{"x", difference.x},
                                     {"y", difference.y},
                                     {"channel", difference.channel},
                                     {"actual", difference.actual},
                                     {"expected", difference.expected}});
  fields.insert(fields.end(),
                {{"mean", difference.mean}, {"rmse", difference.rmse}, {"psnr", difference.psnr}});
  if (metric != nullptr) fields.emplace_back("metric", Fields{{metric->name, *outcome.metric}});
  return fields;
}

std::string as_text(const Pair& pair, const Outcome& outcome, const Metric* metric) {
  std::string text = pair.name.empty() ? "" : shown_text(pair.name) + ": ";
  text += outcome.difference.pixels == 0 ? "equal" : difference_text(outcome.difference);
  text += "\n";
  if (metric != nullptr) text += fmt::format("  {} {}\n", metric->name, *outcome.metric);
  return text;
}

Result<VerbOutput> report(const std::vector<Pair>& all, Diagnostics problems,
                          const std::vector<Result<Outcome>>& outcomes, const Metric* metric) {
  Values values;
  VerbOutput output;
  std::uint64_t differ = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!outcomes[i]) {
      const Diagnostics& why = outcomes[i].error();
      problems.insert(problems.end(), why.begin(), why.end());
      continue;
    }
    if (outcomes[i]->difference.pixels != 0) ++differ;
    values.push_back(as_value(all[i], *outcomes[i], metric));
    output.text.emplace_back(as_text(all[i], *outcomes[i], metric));
  }
  if (values.empty()) return tl::unexpected(std::move(problems));
  if (all.size() > 1)
    output.text.emplace_back(
        fmt::format("{}, {} of them different\n", counted(values.size(), "picture"), differ));
  const bool equal = differ == 0 && problems.empty();
  output.results = Fields{{"equal", equal}, {"pictures", std::move(values)}};
  output.exit_code = differ == 0 ? 0 : 1;
  output.problems = std::move(problems);
  return output;
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(found, pairs(options.operands()[0], options.operands()[1]));
  const std::vector<Pair>& all = found->all;
  std::vector<fs::path> files;
  for (const Pair& pair : all) files.insert(files.end(), {pair.actual, pair.expected});
  if (const auto root = options.text("root")) {  // links below the folders may lead out of it
    FLATRAY_TRY(inside, expect_in_root(*root, files));
  }
  const auto is_png = [](const PictureFormat* format) {
    return format != nullptr && format->name == std::string_view("png");
  };
  if (options.diff && all.size() == 1 && all[0].name.empty() &&
      !is_png(picture_format_by_name(*options.diff)))
    return usage_error(named_place("--diff"),
                       "'" + shown_text(options.diff->string()) + "' does not end in .png",
                       "the difference is written as a PNG");
  Outputs outputs(options);
  for (const fs::path& file : files) outputs.add_input(file);
  std::vector<Result<Outcome>> outcomes(all.size());
  parallel_for(outcomes.size(), options.threads, [&](std::size_t i) {
    outcomes[i] = measure(all[i], options.metric, diff_of(all[i], all, options.diff), outputs);
  });
  return report(all, std::move(found->problems), outcomes, options.metric);
}

}  // namespace

extern const Verb entry = {"compare",
                           "A.png B.png",
                           "say whether two pictures, or two folders of pictures, are equal",
                           kCommand<Options, &run>,
                           "  flatray compare out/a.png out/b.png --diff out/diff.png\n"
                           "  flatray compare out/demo out/demo_of_yesterday --metric psnr\n",
                           "nothing compared",
                           &endings_of_pictures};

}  // namespace flatray::compare_verb
