#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace flatray {

/// A code word as deflate writes it: lowest bit first. 0 bits: the symbol does not occur.
struct CodeWord {
  std::uint32_t word = 0;
  std::uint32_t bits = 0;
};

/// Canonical Huffman code of at most `longest` bits a symbol (RFC 1951, 3.2.2).
///
/// Needs   counts.size() == code.size() <= 288 symbols, at least one count > 0, a sum below 2^32,
///         2^longest symbols or fewer.
/// Gives   a complete code: where only one symbol occurs, another one gets a word too.
///         Depends on nothing but the counts. Cheapest unless words had to be shortened.
void make_code(std::span<const std::uint32_t> counts, unsigned longest, std::span<CodeWord> code);

}  // namespace flatray
