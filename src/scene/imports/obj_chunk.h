#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "geom/vec.h"

namespace flatray {

/// What a stretch of whole records of an OBJ text holds, before the number of vertices in front of
/// it is known.
struct ObjChunk {
  struct Chains {
    /// Numbers of vertices from 0: of the text, or of the chunk where listed in `backward`. What no
    /// int32 holds is its smallest or largest, which no text has vertices for.
    std::vector<std::int32_t> corners;
    std::vector<std::uint32_t> backward;  ///< corners written as -1, -2, ...
    std::vector<std::uint32_t> ends;      ///< chain i ends before corners[ends[i]]
    std::vector<std::size_t> offsets;     ///< of each corner in the text, where asked for
  } faces, lines;
  std::vector<Vec2> vertices;
  std::vector<std::string> ignored;  ///< as ObjText's
  Diagnostics problems;              ///< the first kMaxObjProblems; there reading stops
};

inline constexpr std::size_t kMaxObjProblems = 20, kMaxObjIgnored = 8;

/// Text [begin, end) of `source`.
/// Needs   begin and end are 0, the text's end, or what `end_of_records` gave.
ObjChunk read_obj_chunk(const SourcePtr& source, std::size_t begin, std::size_t end,
                        bool with_offsets = false);

/// The first byte after `offset` at which a record of its own begins; the text's end if none does.
std::size_t end_of_records(std::string_view text, std::size_t offset);

/// The record of a kind ("v", "f") with a number from 0, for a message. Reads all before it.
Place obj_record_place(const SourcePtr& source, std::string_view record, std::size_t number);

/// The corner written at `offset`, for a message.
Place obj_corner_place(const SourcePtr& source, std::size_t offset);

}  // namespace flatray
