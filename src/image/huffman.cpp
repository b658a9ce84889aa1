#include "image/huffman.h"

#include <algorithm>

namespace flatray {
namespace {

constexpr std::size_t kMostSymbols = 288;

struct Node {
  std::uint32_t count;
  std::uint16_t symbol;  // of a leaf
  std::uint16_t parent;
};

// Leaves in order of their counts, then the inner nodes as they are made: each is no smaller than
// the one before, so that the two smallest always stand at the front of one of the two halves.
class Tree {
 public:
  explicit Tree(std::span<const std::uint32_t> counts) {
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] > 0) add(counts[i], i);
    for (std::size_t i = 0; leaves_ < 2; ++i)
      if (counts[i] == 0) add(1, i);
    std::sort(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(leaves_),
              [](const Node& a, const Node& b) {
                return a.count != b.count ? a.count < b.count : a.symbol < b.symbol;
              });
    join();
  }

  std::size_t leaves() const { return leaves_; }
  std::size_t symbol(std::size_t leaf) const { return nodes_[leaf].symbol; }

  // How many leaves lie at each depth; those deeper than `longest` count there.
  std::array<std::uint32_t, kMostSymbols> depths(unsigned longest) const {
    std::array<std::uint32_t, kMostSymbols> leaves_at{};
    std::array<std::uint32_t, 2 * kMostSymbols> depth;
    depth[end_ - 1] = 0;
    for (std::size_t i = end_ - 1; i-- > 0;) {
      depth[i] = depth[nodes_[i].parent] + 1;
      if (i < leaves_) ++leaves_at[std::min<std::size_t>(depth[i], longest)];
    }
    return leaves_at;
  }

 private:
  void add(std::uint32_t count, std::size_t symbol) {
    nodes_[leaves_++] = {count, static_cast<std::uint16_t>(symbol), 0};
  }

  void join() {
    std::size_t leaf = 0, inner = leaves_;
    end_ = leaves_;
    const auto take_smallest = [&] {
      const bool is_leaf =
          leaf < leaves_ && (inner == end_ || nodes_[leaf].count <= nodes_[inner].count);
      const std::size_t taken = is_leaf ? leaf++ : inner++;
      nodes_[taken].parent = static_cast<std::uint16_t>(end_);
      return nodes_[taken].count;
    };
    while (end_ < 2 * leaves_ - 1) {
      const std::uint32_t first = take_smallest();
      const std::uint32_t both = first + take_smallest();
      nodes_[end_++] = {both, 0, 0};
    }
  }

  std::array<Node, 2 * kMostSymbols> nodes_;
  std::size_t leaves_ = 0, end_ = 0;
};

// Cutting words to `longest` bits takes more than the whole room: words get longer until it fits.
template <class Depths>
void fit(Depths& leaves_at, unsigned longest) {
  std::uint64_t room = 0;
  for (unsigned bits = 1; bits <= longest; ++bits)
    room += std::uint64_t{leaves_at[bits]} << (longest - bits);
  for (; room > std::uint64_t{1} << longest; --room) {
    unsigned bits = longest - 1;
    while (leaves_at[bits] == 0) --bits;
    --leaves_at[bits];
    leaves_at[bits + 1] += 2;
    --leaves_at[longest];
  }
}

std::uint32_t reversed(std::uint32_t word, std::uint32_t bits) {
  std::uint32_t result = 0;
  for (std::uint32_t i = 0; i < bits; ++i) result |= ((word >> i) & 1) << (bits - 1 - i);
  return result;
}

}  // namespace

void make_code(std::span<const std::uint32_t> counts, unsigned longest, std::span<CodeWord> code) {
  const Tree tree(counts);
  auto leaves_at = tree.depths(longest);
  fit(leaves_at, longest);
  std::fill(code.begin(), code.end(), CodeWord{});
  std::size_t leaf = tree.leaves();
  for (unsigned bits = 1; bits <= longest; ++bits)
    for (std::uint32_t i = 0; i < leaves_at[bits]; ++i) code[tree.symbol(--leaf)].bits = bits;
  std::uint32_t word = 0;
  for (unsigned bits = 1; bits <= longest; ++bits, word <<= 1)
    for (CodeWord& c : code)
      if (c.bits == bits) c.word = reversed(word++, bits);
}

}  // namespace flatray
