#include "base/npy.h"

#include <fmt/core.h>

#include <bit>

namespace flatray {

NpyTable::NpyTable(const std::vector<Column>& columns, std::uint64_t rows) {
  std::string head = "{'descr': [";
  for (const Column& column : columns)
    head += fmt::format("('{}', '{}'), ", column.name, column.kind == Kind::real ? "<f8" : "<u8");
  head += fmt::format("], 'fortran_order': False, 'shape': ({},), }}", rows);
  constexpr std::size_t kBefore = 10,
                        kAligned = 64;  // what stands before the head; where rows begin
  while ((kBefore + head.size() + 1) % kAligned != 0) head += ' ';
  head += '\n';
  bytes_ = "\x93NUMPY";
  bytes_ += '\x01';
  bytes_ += '\0';
  bytes_ += static_cast<char>(head.size() & 0xff);
  bytes_ += static_cast<char>(head.size() >> 8);
  bytes_ += head;
  bytes_.reserve(bytes_.size() + 8 * columns.size() * rows);
}

void NpyTable::add(std::uint64_t cell) {
  for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>(cell >> shift & 0xff);
}

void NpyTable::add(double cell) { add(std::bit_cast<std::uint64_t>(cell)); }

}  // namespace flatray
