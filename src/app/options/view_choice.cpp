#include "app/options/view_choice.h"

#include <fmt/core.h>

#include "app/options/option_values.h"
#include "base/number_text.h"

namespace flatray {
namespace {

Result<const View*> find_view(const std::string& name, const Place& where) {
  for (const View* view : views())
    if (name == view->name) return view;
  return unknown_name(where, "view", name, view_names());
}

Result<Vec2> read_point(std::string_view text, const std::string& view, const Place& where) {
  const std::vector<std::string_view> parts = split(text, ',');
  const auto x = parse_number(parts[0]);
  const auto y = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (!x || !y)
    return usage_error(where, fmt::format("'{}' is not a point", text),
                       fmt::format("say {}:x,y with two numbers", view));
  return Vec2(*x, *y);
}

}  // namespace

std::vector<std::string> view_names() { return names_of(views()); }

Result<std::optional<ViewRequest>> chosen_view(const Arguments& arguments) {
  const auto text = arguments.text("view");
  if (!text) return std::nullopt;
  if (arguments.has("backend"))
    return usage_error(arguments.where("view"), "is drawn by rays, not by a back end",
                       "leave out --backend");
  const Place where = arguments.where("view");
  const std::string name = text->substr(0, text->find(':'));
  const auto view = find_view(name, where);
  if (!view) return tl::unexpected(view.error());
  ViewRequest request{*view, {0, 0}};
  const bool has_point = name.size() < text->size();
  if (has_point != (*view)->takes_point)
    return usage_error(where, has_point ? "takes no point" : "needs a point",
                       has_point ? "say " + name : fmt::format("say {}:x,y", name));
  if (has_point) {
    const auto point = read_point(std::string_view(*text).substr(name.size() + 1), name, where);
    if (!point) return tl::unexpected(point.error());
    request.point = *point;
  }
  return request;
}

}  // namespace flatray
