#include "scene/imports/obj_text.h"

#include <algorithm>
#include <string_view>

#include "base/counted.h"
#include "base/parallel.h"
#include "scene/imports/obj_chunk.h"

namespace flatray {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 18;

// Bytes at which chunks begin, and the end of the text.
std::vector<std::size_t> cuts_of(std::string_view text) {
  std::vector<std::size_t> all{0};
  while (all.back() < text.size())
    all.push_back(end_of_records(text, std::min(all.back() + kChunkBytes, text.size())));
  return all;
}

// Where the parts of a chunk go in the whole.
struct ChainsStart {
  std::size_t corners = 0, chains = 0;
};
struct Start {
  std::size_t vertices = 0;
  ChainsStart faces, lines;
};

ChainsStart after(const ChainsStart& start, const ObjChunk::Chains& chains) {
  return {start.corners + chains.corners.size(), start.chains + chains.ends.size()};
}

struct Merger {
  const SourcePtr& source;
  const std::vector<std::size_t> cuts;
  const unsigned threads;
  std::vector<ObjChunk> chunks = std::vector<ObjChunk>(cuts.size() - 1);
  std::vector<Start> starts{};
  ObjText obj{};

  Result<ObjText> merge() {
    parallel_for(chunks.size(), threads, [this](std::size_t i) {
      chunks[i] = read_obj_chunk(source, cuts[i], cuts[i + 1]);
    });
    Diagnostics problems = problems_of_chunks();
    if (problems.size() < kMaxObjProblems) {
      make_room();
      const bool whole = place_chunks();
      if (!whole) add_missing(problems);
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    name_ignored();
    return std::move(obj);
  }

  // A chunk that stopped early is followed by nothing: it has as many problems as are told.
  Diagnostics problems_of_chunks() {
    Diagnostics problems;
    for (ObjChunk& chunk : chunks)
      for (Diagnostic& problem : chunk.problems)
        if (problems.size() < kMaxObjProblems) problems.push_back(std::move(problem));
    return problems;
  }

  void make_room() {
    Start next;
    for (const ObjChunk& chunk : chunks) {
      starts.push_back(next);
      next = {next.vertices + chunk.vertices.size(), after(next.faces, chunk.faces),
              after(next.lines, chunk.lines)};
    }
    obj.vertices.resize(next.vertices);
    make_room(obj.faces, next.faces);
    make_room(obj.lines, next.lines);
  }
  static void make_room(ObjText::Chains& chains, const ChainsStart& size) {
    chains.corners.resize(size.corners);
    chains.begin.resize(size.chains + 1);
  }

  // Whether there is a vertex for every corner.
  bool place_chunks() {
    std::vector<char> whole(chunks.size());  // not bits, which threads would share
    parallel_for(chunks.size(), threads, [&](std::size_t i) {
      ObjChunk& chunk = chunks[i];
      const Start& start = starts[i];
      std::ranges::copy(chunk.vertices,
                        obj.vertices.begin() + static_cast<std::ptrdiff_t>(start.vertices));
      const bool faces = place(chunk.faces, start.vertices, start.faces, obj.faces);
      const bool lines = place(chunk.lines, start.vertices, start.lines, obj.lines);
      whole[i] = faces && lines ? 1 : 0;
    });
    return std::ranges::find(whole, 0) == whole.end();
  }

  // Numbers of the whole text, in place.
  bool place(ObjChunk::Chains& from, std::size_t vertices_before, const ChainsStart& start,
             ObjText::Chains& to) const {
    for (const std::uint32_t i : from.backward)
      from.corners[i] += static_cast<std::int32_t>(vertices_before);
    bool whole = true;
    for (std::size_t i = 0; i < from.corners.size(); ++i) {
      whole = whole && is_vertex(from.corners[i]);
      to.corners[start.corners + i] = static_cast<std::uint32_t>(from.corners[i]);
    }
    for (std::size_t i = 0; i < from.ends.size(); ++i)
      to.begin[start.chains + i + 1] = static_cast<std::uint32_t>(start.corners + from.ends[i]);
    return whole;
  }
  bool is_vertex(std::int32_t index) const {
    return index >= 0 && static_cast<std::size_t>(index) < obj.vertices.size();
  }

  void add_missing(Diagnostics& problems) const {
    for (const auto chains : {&ObjChunk::faces, &ObjChunk::lines})
      for (std::size_t i = 0; i < chunks.size(); ++i) add_missing(problems, i, chains);
  }
  // Where corners stand is not kept while all is well: a chunk with a wrong one is read again.
  void add_missing(Diagnostics& problems, std::size_t chunk,
                   ObjChunk::Chains ObjChunk::*chains) const {
    const std::vector<std::int32_t>& corners = (chunks[chunk].*chains).corners;
    const auto good = [this](std::int32_t index) { return is_vertex(index); };
    if (std::ranges::all_of(corners, good)) return;
    const ObjChunk again = read_obj_chunk(source, cuts[chunk], cuts[chunk + 1], true);
    for (std::size_t i = 0; i < corners.size() && problems.size() < kMaxObjProblems; ++i)
      if (!good(corners[i]))
        problems.push_back({obj_corner_place(source, (again.*chains).offsets[i]),
                            "there is no such vertex",
                            "the file has " + counted(obj.vertices.size(), "vertex", "vertices")});
  }

  void name_ignored() {
    auto& names = obj.ignored;
    for (ObjChunk& chunk : chunks)
      for (std::string& name : chunk.ignored)
        if (names.size() < kMaxObjIgnored && std::ranges::find(names, name) == names.end())
          names.push_back(std::move(name));
  }
};

}  // namespace

Result<ObjText> parse_obj(const SourcePtr& source, unsigned threads) {
  return Merger{source, cuts_of(source->text()), threads}.merge();
}

}  // namespace flatray
