#include "scene/reading/include.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <span>

#include "scene/keys/build_scene.h"
#include "scene/reading/format.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

std::string identity(const SourcePtr& source) {
  std::error_code ignored;
  const fs::path known = fs::weakly_canonical(source->name(), ignored);
  return known.empty() ? source->name() : known.string();
}

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  std::ranges::move(from, std::back_inserter(to));
}

template <class T>
void prepend(std::vector<T>&& first, std::vector<T>& to) {
  append(first, std::move(to));
  to = std::move(first);
}

// Puts the members of `under` before those of `over`; where both have one, `both` says what becomes
// of it.
template <class Both>
void put_together(Value&& under, Value& over, const Both& both) {
  std::map<std::string_view, Value*> known;  // tables may be large
  for (Member& member : over.members) known.emplace(member.key, &member.value);
  std::vector<Member> added;
  for (Member& member : under.members) {
    const auto found = known.find(member.key);
    if (found == known.end())
      added.push_back(std::move(member));
    else
      both(std::move(member), *found->second);
  }
  prepend(std::move(added), over.members);
}

// Puts what `over` says over what `under` says, and the result into `over`.
void merge(Reader& in, Value&& under, Value& over) {
  put_together(std::move(under), over, [&](Member&& member, Value& own) {
    if (member.value.kind != own.kind)
      in.problem(member.value.where,
                 fmt::format("{} is {}", member.key, kind_name(member.value.kind)),
                 fmt::format("a file that includes this one has {}", kind_name(own.kind)));
    else if (own.kind == Value::Kind::array)
      prepend(std::move(member.value.items), own.items);
    else if (own.kind == Value::Kind::table)
      put_together(std::move(member.value), own, [](Member&&, Value&) {});
  });
}

class Includer {
 public:
  Includer(Imports& imports, const LoadLimits& limits) : imports_(imports), limits_(limits) {}

  Reader in;

  void take(SceneDesc& desc, const SourcePtr& source) {
    open_.push_back(identity(source));
    known_.insert(open_.back());
    std::vector<SceneDesc> files;
    if (const Member* include = desc.root.find("include"))
      files = all_of({"include", include->value, "[\"part.toml\", ...]"});
    for (SceneDesc& one : files) {
      append(desc.warnings, std::move(one.warnings));
      append(desc.sources, std::move(one.sources));
    }
    std::erase_if(desc.root.members, [](const Member& member) { return member.key == "include"; });
    if (!files.empty()) merge(in, merged(files), desc.root);
    desc.sources.push_back(source);
    open_.pop_back();
  }

 private:
  // In halves, so that no file is gone through for each of the others.
  Value merged(std::span<SceneDesc> files) {
    if (files.size() == 1) return std::move(files.front().root);
    const std::size_t half = files.size() / 2;
    Value under = merged(files.first(half)), over = merged(files.subspan(half));
    merge(in, std::move(under), over);
    return over;
  }

  std::vector<SceneDesc> all_of(const Field& files) {
    std::vector<SceneDesc> all;
    if (!in.is(files, Value::Kind::array, "a list of file names")) return all;
    for (std::size_t i = 0; i < files.value.items.size(); ++i)
      if (std::optional<SceneDesc> one = read(files.item(i))) all.push_back(std::move(*one));
    return all;
  }

  // nullopt where it is wrong, and where it is known already.
  std::optional<SceneDesc> read(const Field& field) {
    const auto file = in.string(field);
    if (!file) return std::nullopt;
    const Place& where = field.value.where;
    if (fs::path(*file).is_absolute())
      return in.refuse({where, fmt::format("'{}' is an absolute path", *file),
                        "write it from the folder of this file on, so that scenes can be moved"});
    const Format* format = format_for_name(*file);
    if (format == nullptr)
      return in.refuse({where, fmt::format("'{}' has no extension of a scene", *file),
                        "known: " + known_extensions()});
    const Result<SourcePtr> source = imports_.include(*file, where);
    if (!source) return in.add(source.error()), std::nullopt;
    if (std::ranges::find(open_, identity(*source)) != open_.end())
      return in.refuse(
          {where, fmt::format("'{}' includes itself", *file), "take this include out"});
    if (known_.count(identity(*source)) != 0) return std::nullopt;
    if (open_.size() > limits_.max_depth)
      return in.refuse({where,
                        fmt::format("files are included more than {} deep", limits_.max_depth),
                        "--max-depth raises the limit"});
    Result<SceneDesc> desc = format->read(*source, limits_);
    if (!desc) return in.add(std::move(desc.error())), std::nullopt;
    check_version(in, desc->root);
    take(*desc, *source);
    return std::move(*desc);
  }

  Imports& imports_;
  const LoadLimits& limits_;
  std::vector<std::string> open_;  // files being read, the scene first
  std::set<std::string> known_;
};

}  // namespace

Result<void> take_includes(SceneDesc& desc, const SourcePtr& source, Imports& imports,
                           const LoadLimits& limits) {
  Includer includer(imports, limits);
  includer.take(desc, source);
  if (!includer.in.problems.empty()) return tl::unexpected(std::move(includer.in.problems));
  return {};
}

}  // namespace flatray
