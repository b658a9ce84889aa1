#include "image/deflate.h"

#include <algorithm>
#include <bit>

#include "image/bit_writer.h"
#include "image/huffman.h"

namespace flatray {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kLiteralSymbols = 286, kDistanceSymbols = 30, kLengthSymbols = 19;
constexpr std::size_t kEndOfBlock = 256;
constexpr std::uint32_t kLongestMatch = 258, kShortestMatch = 3;
constexpr unsigned kLongestWord = 12;        // so that four literals go between two flushes
constexpr unsigned kLongestLengthWord = 7;   // of the code for the lengths of words
constexpr std::size_t kStoredBlock = 65535;  // bytes a stored block holds

// A length or distance as a symbol and what follows it.
struct Extra {
  std::uint32_t symbol, value, bits;
};

// Two symbols an octave after four of one value each (distances), four after eight (lengths):
// RFC 1951, 3.2.5.
constexpr Extra split(std::uint32_t offset, unsigned fine) {
  const std::uint32_t exact = 2U << fine;
  if (offset < exact) return {offset, 0, 0};
  const auto bits = static_cast<std::uint32_t>(std::bit_width(offset)) - 1 - fine;
  return {(bits << fine) + (offset >> bits), offset & ((1U << bits) - 1), bits};
}
constexpr Extra distance_extra(std::uint32_t distance) { return split(distance - 1, 1); }
constexpr Extra length_extra(std::uint32_t length) {
  if (length == kLongestMatch) return {285, 0, 0};
  const Extra extra = split(length - kShortestMatch, 2);
  return {257 + extra.symbol, extra.value, extra.bits};
}
static_assert(distance_extra(32768).symbol == 29 && distance_extra(24577).symbol == 29);
static_assert(distance_extra(4).symbol == 3 && distance_extra(5).symbol == 4);
static_assert(length_extra(10).symbol == 264 && length_extra(11).symbol == 265);
static_assert(length_extra(257).symbol == 284 && length_extra(257).value == 30);

// The parts a long match is written in, none shorter than 3.
template <class Take>
void cut(std::uint32_t length, const Take& take) {
  while (length > kLongestMatch) {
    const std::uint32_t part =
        length < kLongestMatch + kShortestMatch ? length - kShortestMatch : kLongestMatch;
    take(part);
    length -= part;
  }
  take(length);
}

struct Counts {
  std::array<std::uint32_t, kLiteralSymbols> literals{};
  std::array<std::uint32_t, kDistanceSymbols> distances{};
};

// Four tables: equal bytes after each other would wait for the same count.
void count_literals(Bytes bytes, std::array<std::array<std::uint32_t, 256>, 4>& tables) {
  std::size_t i = 0;
  for (; i + 4 <= bytes.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) ++tables[k][bytes[i + k]];
  for (; i < bytes.size(); ++i) ++tables[0][bytes[i]];
}

Counts count(Bytes bytes, const std::vector<Sequence>& sequences) {
  Counts counts;
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  std::size_t at = 0;
  for (const Sequence& s : sequences) {
    count_literals(bytes.subspan(at, s.literals), tables);
    at += s.literals + s.length;
    if (s.length == 0) continue;
    std::uint32_t parts = 0;
    cut(s.length, [&](std::uint32_t part) {
      ++counts.literals[length_extra(part).symbol];
      ++parts;
    });
    counts.distances[distance_extra(s.distance).symbol] += parts;
  }
  for (const auto& table : tables)
    for (std::size_t i = 0; i < 256; ++i) counts.literals[i] += table[i];
  counts.literals[kEndOfBlock] = 1;
  return counts;
}

// Lengths of words, runs of them shortened by the symbols 16, 17 and 18 (RFC 1951, 3.2.7).
class LengthCode {
 public:
  void add(std::span<const CodeWord> words) {
    for (const CodeWord& word : words) lengths_[size_++] = static_cast<std::uint8_t>(word.bits);
  }

  void finish() {
    for (std::size_t i = 0; i < size_;) i += add_run(i);
    std::array<std::uint32_t, kLengthSymbols> counts{};
    for (std::size_t i = 0; i < symbols_; ++i) ++counts[runs_[i].symbol];
    make_code(counts, kLongestLengthWord, code_);
  }

  std::uint64_t bits() const {
    std::uint64_t sum = 5 + 5 + 4 + 3 * kLengthSymbols;
    for (std::size_t i = 0; i < symbols_; ++i) sum += code_[runs_[i].symbol].bits + runs_[i].bits;
    return sum;
  }

  // All 286, 30 and 19 lengths stand in the file: what leaving the last ones out would save is
  // little.
  void write(BitWriter& out) const {
    out.put(kLiteralSymbols - 257, 5);
    out.put(kDistanceSymbols - 1, 5);
    out.put(kLengthSymbols - 4, 4);
    constexpr std::array<std::uint8_t, kLengthSymbols> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                                 11, 4,  12, 3, 13, 2, 14, 1, 15};
    for (const std::uint8_t symbol : kOrder) {
      out.put(code_[symbol].bits, 3);
      out.flush();
    }
    for (std::size_t i = 0; i < symbols_; ++i) {
      out.put(code_[runs_[i].symbol].word, code_[runs_[i].symbol].bits);
      out.put(runs_[i].value, runs_[i].bits);
      out.flush();
    }
  }

 private:
  std::size_t add_run(std::size_t from) {
    const std::uint8_t length = lengths_[from];
    std::size_t end = from;
    while (end < size_ && lengths_[end] == length) ++end;
    const std::size_t run = end - from;
    if (length == 0 && run >= 11) return add(18, std::min<std::size_t>(run, 138), 11, 7);
    if (length == 0 && run >= 3) return add(17, run, 3, 3);
    if (from > 0 && lengths_[from - 1] == length && run >= 3)
      return add(16, std::min<std::size_t>(run, 6), 3, 2);
    return add(length, 1, 1, 0);
  }
  std::size_t add(std::uint32_t symbol, std::size_t run, std::size_t least, std::uint32_t bits) {
    runs_[symbols_++] = {symbol, static_cast<std::uint32_t>(run - least), bits};
    return run;
  }

  std::array<std::uint8_t, kLiteralSymbols + kDistanceSymbols> lengths_{};
  std::array<Extra, kLiteralSymbols + kDistanceSymbols> runs_{};
  std::array<CodeWord, kLengthSymbols> code_{};
  std::size_t size_ = 0, symbols_ = 0;
};

// One block with codes of its own.
class Block {
 public:
  Block(Bytes bytes, const std::vector<Sequence>& sequences)
      : bytes_(bytes), sequences_(sequences), counts_(count(bytes, sequences)) {
    make_code(counts_.literals, kLongestWord, literals_);
    make_code(counts_.distances, kLongestWord, distances_);
    header_.add(literals_);
    header_.add(distances_);
    header_.finish();
  }

  std::uint64_t bits() const {
    std::uint64_t sum = 3 + header_.bits();
    for (std::uint32_t i = 0; i < kLiteralSymbols; ++i)
      sum += std::uint64_t{counts_.literals[i]} * (literals_[i].bits + extra_bits_of_length(i));
    for (std::uint32_t i = 0; i < kDistanceSymbols; ++i)
      sum += std::uint64_t{counts_.distances[i]} * (distances_[i].bits + (i < 4 ? 0 : i / 2 - 1));
    return sum;
  }

  void write(BitWriter& out) const {
    out.put(0b100, 3);  // not the last block; codes of its own
    header_.write(out);
    const std::uint8_t* at = bytes_.data();
    for (const Sequence& s : sequences_) {
      write_literals(at, s.literals, out);
      at += s.literals + s.length;
      if (s.length > 0) write_match(s, out);
    }
    out.put(literals_[kEndOfBlock].word, literals_[kEndOfBlock].bits);
    out.flush();
  }

 private:
  static std::uint32_t extra_bits_of_length(std::uint32_t symbol) {
    return symbol < 265 || symbol == 285 ? 0 : (symbol - 261) / 4;
  }

  void write_literals(const std::uint8_t* at, std::uint32_t count, BitWriter& out) const {
    const std::uint8_t* const end = at + count;
    for (; end - at >= 4; at += 4) {
      for (int i = 0; i < 4; ++i) out.put(literals_[at[i]].word, literals_[at[i]].bits);
      out.flush();
    }
    for (; at != end; ++at) out.put(literals_[*at].word, literals_[*at].bits);
    out.flush();
  }

  void write_match(const Sequence& s, BitWriter& out) const {
    const Extra far = distance_extra(s.distance);
    const CodeWord& word = distances_[far.symbol];
    const std::uint64_t distance = far.value << word.bits | word.word;
    cut(s.length, [&](std::uint32_t part) {
      const Extra length = length_extra(part);
      out.put(literals_[length.symbol].word, literals_[length.symbol].bits);
      out.put(length.value, length.bits);
      out.put(distance, word.bits + far.bits);
      out.flush();
    });
  }

  Bytes bytes_;
  const std::vector<Sequence>& sequences_;
  Counts counts_;
  std::array<CodeWord, kLiteralSymbols> literals_;
  std::array<CodeWord, kDistanceSymbols> distances_;
  LengthCode header_;
};

void put_stored(Bytes bytes, std::vector<std::byte>& out) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  out.push_back(std::byte{0});
  for (const std::uint32_t half : {size, ~size})
    for (const unsigned shift : {0U, 8U}) out.push_back(static_cast<std::byte>(half >> shift));
  const auto bytes_of = std::as_bytes(bytes);
  out.insert(out.end(), bytes_of.begin(), bytes_of.end());
}

std::uint64_t stored_bits(std::size_t size) {
  return 8 * (size + 5 * ((size + kStoredBlock - 1) / kStoredBlock));
}

}  // namespace

void Deflater::pack(Bytes bytes, std::size_t pixel, std::vector<std::byte>& out) {
  const Block block(bytes, finder_.find(bytes, pixel));
  const std::uint64_t bits = block.bits();
  if (bits >= stored_bits(bytes.size())) {
    for (std::size_t at = 0; at < bytes.size(); at += kStoredBlock)
      put_stored(bytes.subspan(at, std::min(kStoredBlock, bytes.size() - at)), out);
    return;
  }
  constexpr std::size_t kRoom = 16;  // an empty stored block, and what the writer needs beyond
  const std::size_t before = out.size();
  out.resize(before + bits / 8 + kRoom);
  BitWriter writer(out.data() + before);
  block.write(writer);
  writer.put(0, 3);  // an empty stored block ends on a whole byte
  std::byte* const end = writer.finish();
  out.resize(static_cast<std::size_t>(end - out.data()));
  for (const unsigned value : {0x00U, 0x00U, 0xffU, 0xffU}) out.push_back(std::byte(value));
}

}  // namespace flatray
