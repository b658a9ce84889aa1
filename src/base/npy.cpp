#include "base/npy.h"

#include <fmt/core.h>

#include <bit>

namespace flatray {

namespace {

// All that stands before the numbers.
std::string head_of(const std::string& kind, const std::string& shape) {
  std::string head = "{'descr': " + kind + ", 'fortran_order': False, 'shape': (" + shape + "), }";
  constexpr std::size_t kBefore = 10,
                        kAligned = 64;  // what stands before the head; where rows begin
  while ((kBefore + head.size() + 1) % kAligned != 0) head += ' ';
  head += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\x01';
  bytes += '\0';
  bytes += static_cast<char>(head.size() & 0xff);
  bytes += static_cast<char>(head.size() >> 8);
  return bytes + head;
}

void append(std::string& bytes, std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(number >> shift & 0xff);
}

}  // namespace

NpyTable::NpyTable(const std::vector<Column>& columns, std::uint64_t rows) {
  std::string kinds = "[";
  for (const Column& column : columns)
    kinds += fmt::format("('{}', '{}'), ", column.name, column.kind == Kind::real ? "<f8" : "<u8");
  bytes_ = head_of(kinds + "]", fmt::format("{},", rows));
  bytes_.reserve(bytes_.size() + 8 * columns.size() * rows);
}

void NpyTable::add(std::uint64_t cell) { append(bytes_, cell); }

void NpyTable::add(double cell) { add(std::bit_cast<std::uint64_t>(cell)); }

std::string npy_grid(std::span<const std::uint64_t> counts, std::uint64_t rows,
                     std::uint64_t columns) {
  std::string bytes = head_of("'<u8'", fmt::format("{}, {}", rows, columns));
  bytes.reserve(bytes.size() + 8 * counts.size());
  for (const std::uint64_t count : counts) append(bytes, count);
  return bytes;
}

}  // namespace flatray
