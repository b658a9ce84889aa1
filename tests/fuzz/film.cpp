// The bytes as they are, and with the checksum put right: what is read is written again as the same bytes.
#include "base/hash.h"
#include "fuzz/target.h"
#include "image/film_file.h"

namespace {

using Bytes = std::vector<std::byte>;

void repair_checksum(Bytes& bytes) {
  if (bytes.size() < 8) return;
  const std::uint64_t sum = flatray::Hash().add(std::span(bytes).first(bytes.size() - 8)).value();
  for (std::size_t i = 0; i < 8; ++i)
    bytes[bytes.size() - 8 + i] = static_cast<std::byte>(sum >> (8 * i));
}

void decode(const Bytes& bytes) {
  const auto film = flatray::decode_film(bytes, "f.film");
  if (!film && flatray::format(film.error()).empty()) std::abort();
  if (!film) return;
  if (flatray::encode_film(*film) != bytes) std::abort();
  flatray::FilmFile twice = *film;
  const bool empty = film->rounds.words().empty();
  if (flatray::add_film(twice, *film, "f.film").has_value() && !empty) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const flatray::OneSecond limit;
  const auto* first = reinterpret_cast<const std::byte*>(data);
  Bytes bytes(first, first + size);
  decode(bytes);
  repair_checksum(bytes);
  decode(bytes);
  return 0;
}
