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

NpyHead head_of_npy(const std::string& file) {
  const std::size_t shape = file.find("'shape'"), end = file.find('\n', shape);
  const std::string_view columns = std::string_view(file).substr(0, shape);
  NpyHead head{{}, {}, end + 1};
  for (std::size_t at = columns.find("('"); at != columns.npos; at = columns.find("('", at + 1)) {
    const std::size_t after = columns.find('\'', at + 2);
    head.columns.push_back(
        {std::string(columns.substr(at + 2, after - at - 2)),
         columns.substr(after, 6) == "', '<f" ? NpyTable::Kind::real : NpyTable::Kind::whole});
  }
  for (std::size_t at = file.find('(', shape) + 1; file[at] >= '0' && file[at] <= '9';) {
    std::uint64_t count = 0;
    for (; file[at] >= '0' && file[at] <= '9'; ++at)
      count = 10 * count + static_cast<std::uint64_t>(file[at] - '0');
    head.shape.push_back(count);
    while (file[at] == ',' || file[at] == ' ') ++at;
  }
  return head;
}

}  // namespace flatray
