#include <fmt/core.h>

#include "base/counted.h"
#include "scene/keys/builder.h"
#include "scene/reading/format.h"
#include "scene/reading/made_values.h"
#include "scene/reading/numbers.h"

namespace flatray::list_format {
namespace {

// The paper's block: every object is a box of this size, its lower left corner at the pixel given.
constexpr double kBlockWidth = 64, kBlockHeight = 128;
constexpr const char* kLineHint = "a line reads { NAME, x, y } or NAME, x, y";

Value pair(double x, double y) { return array_value({}, {built_in_number(x), built_in_number(y)}); }

Value block() {
  return table_of({}, member("box", table_of({}, member("min", pair(0, 0)),
                                             member("max", pair(kBlockWidth, kBlockHeight)))));
}

class ListReader {
 public:
  ListReader(SourcePtr source, std::size_t max_entities)
      : source_(std::move(source)), max_entities_(max_entities) {}

  Result<SceneDesc> read() {
    std::string_view rest = source_->text();
    Diagnostics problems;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      if (Result<void> line = read_line(rest.substr(0, end)); !line) {
        problems.insert(problems.end(), line.error().begin(), line.error().end());
        if (entities_.size() >= max_entities_ || problems.size() >= kMostProblems) break;
      }
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    const Place whole{source_, 0, 1};
    Value film = table_of(whole, member("world", string_value(whole, "pixels")));
    return SceneDesc{table_of(whole, Member{"flatray", whole, built_in_number(1)},
                              Member{"fps", whole, built_in_number(1)},
                              member("film", std::move(film)),
                              member("entity", array_value(whole, std::move(entities_))))};
  }

 private:
  Place place(std::string_view part) const { return place_in(source_, part); }

  Result<void> read_line(std::string_view line) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return {};
    if (entities_.size() >= max_entities_)
      return fail(place(line), "the list has more than " + counted(max_entities_, "object"),
                  "--max-entities raises the limit");
    const std::string_view whole = line;
    const bool opened = line.starts_with('{'), closed = line.ends_with('}') && line.size() > 1;
    if (opened != closed)
      return fail(place(whole),
                  opened ? "the closing brace is missing" : "the opening brace is missing",
                  kLineHint);
    if (opened) line = line.substr(1, line.size() - 2);
    return read_fields(whole, line);
  }

  // The name may hold commas; x and y are the last two parts.
  Result<void> read_fields(std::string_view whole, std::string_view fields) {
    const std::size_t second = fields.rfind(',');
    const std::size_t first =
        second == 0 || second == std::string_view::npos ? second : fields.rfind(',', second - 1);
    if (second == 0 || first == std::string_view::npos || second == std::string_view::npos)
      return fail(place(whole), "a name and two numbers are wanted", kLineHint);
    const std::string_view name = trimmed(fields.substr(0, first));
    const std::string_view parts[] = {trimmed(fields.substr(first + 1, second - first - 1)),
                                      trimmed(fields.substr(second + 1))};
    if (name.empty()) return fail(place(whole), "the name is missing", kLineHint);
    std::vector<Value> at;
    for (const std::string_view part : parts) {
      if (!parse_literal(part))
        return fail(place(part.empty() ? whole : part),
                    fmt::format("'{}' is not a finite number", part.substr(0, 40)), kLineHint);
      at.push_back({Value::Kind::number, place(part), {}, {}, {}});
    }
    add(whole, name, std::move(at));
    return {};
  }

  void add(std::string_view line, std::string_view name, std::vector<Value> at) {
    const Place where = place(line);
    entities_.push_back(
        table_of(where, member("name", string_value(place(name), std::string(name))),
                 member("shape", block_), member("at", array_value(where, std::move(at)))));
  }

  SourcePtr source_;
  const std::size_t max_entities_;
  const Value block_ = block();
  std::vector<Value> entities_;
};

Result<SceneDesc> read(const SourcePtr& source, const LoadLimits& limits) {
  return ListReader(source, limits.max_entities).read();
}

bool recognises(std::string_view text) {
  const std::string_view line = first_line(text);
  return line.starts_with('{') ||
         (line.find(',') != std::string_view::npos && line.find('=') == std::string_view::npos &&
          !line.starts_with('['));
}

constexpr std::string_view kExtensions[] = {"txt", "list"};

}  // namespace

extern const Format entry = {"list",      "the paper's object list: a line { NAME, x, y } each",
                             kExtensions, &recognises,
                             &read,       nullptr};

}  // namespace flatray::list_format
