// The kernels of the film of light for one tier, included inside its namespace: `Lanes`, `Places`
// and `Words` are the tier's vectors of floats and of signed and unsigned numbers of 32 bits;
// nearest() rounds, ties to even;
// FLATRAY_FIRST_PAIRS and FLATRAY_LAST_PAIRS shuffle two vectors into pairs, FLATRAY_ONE_ON moves one on.

constexpr size_t kColumns = sizeof(Lanes) / 4;
// Steps that are worked out before they are added: adding them is then one loop without branches.
constexpr size_t kStepsAtOnce = 256;
static const float kPlaces[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// A step: what one piece adds to the two pixels in one column, `place` and the next. Both are one
// number of 64 bits: sums stay below 2^32, so that none carries into the other.
template <int kChannels>
struct LightSteps {
  int32_t place[kStepsAtOnce + kLightTile + 16];
  uint64_t pair[kChannels][kStepsAtOnce + kLightTile + 16];
};

static inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
static inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }

static inline Words total(float units, Lanes u) {
  return nearest(units * u);
}

// Works out the steps of a piece and gives their number.
template <int kChannels>
static inline size_t work_out(const LightPiece& piece, const LightLayer& layer, size_t count,
                              LightSteps<kChannels>& steps) {
  const int first = (int)piece.from;
  const int columns = (int)piece.to - first + ((float)(int)piece.to < piece.to ? 1 : 0);
  const Lanes none{};
  const Lanes from = none + piece.from, to = none + piece.to, last = none + layer.last_row;
  const int32_t stride = layer.step * kChannels * kLightColumn;
  const int32_t start = (layer.first * kLightColumn + 1) * kChannels;
  Lanes column = load<Lanes>(kPlaces) + (float)first;
  Words ended[kChannels];  // totals where the columns before end; the last one is looked at
#pragma GCC unroll 3
  for (int c = 0; c < kChannels; ++c) ended[c] = total(piece.units[c], from);
  for (int done = 0; done < columns; done += (int)kColumns, column += (float)kColumns) {
    const Lanes u0 = larger(column, from);
    const Lanes u1 = larger(smaller(column + 1.0F, to), u0);
    const Lanes v = piece.minor + piece.slope * u0;
    const Places row = __builtin_convertvector(smaller(larger(v, none), last), Places);
    const Lanes next = __builtin_convertvector(row + 1, Lanes) - piece.minor;
    const Lanes m = smaller(larger(next * piece.run, u0), u1);
    const Places place = __builtin_convertvector(column, Places) * stride + row * kChannels + start;
    const size_t at = count + (size_t)done;
    __builtin_memcpy(steps.place + at, &place, sizeof place);
    Words parts[2 * kChannels];  // the channels of the row, then those of the next
#pragma GCC unroll 3
    for (int c = 0; c < kChannels; ++c) {
      const Words middle = total(piece.units[c], m), end = total(piece.units[c], u1);
      parts[c] = middle - __builtin_shufflevector(ended[c], end, FLATRAY_ONE_ON);
      parts[kChannels + c] = end - middle;
      ended[c] = end;
    }
#pragma GCC unroll 3
    for (int c = 0; c < kChannels; ++c) {
      const Words low = parts[2 * c], high = parts[2 * c + 1];
      const Words pairs[2] = {__builtin_shufflevector(low, high, FLATRAY_FIRST_PAIRS),
                              __builtin_shufflevector(low, high, FLATRAY_LAST_PAIRS)};
      __builtin_memcpy(steps.pair[c] + at, pairs, sizeof pairs);
    }
  }
  return count + (size_t)columns;
}

template <int kChannels>
static inline void add_steps(const LightSteps<kChannels>& steps, size_t count, uint32_t* sums) {
  for (size_t i = 0; i < count; ++i) {
    uint32_t* at = sums + steps.place[i];
#pragma GCC unroll 3
    for (int c = 0; c < kChannels; ++c, at += 2) {
      uint64_t both;
      __builtin_memcpy(&both, at, sizeof both);
      both += steps.pair[c][i];
      __builtin_memcpy(at, &both, sizeof both);
    }
  }
}

template <int kChannels>
static void deposit(const LightPiece* pieces, size_t count, const LightLayer& layer) {
  LightSteps<kChannels> steps;
  size_t waiting = 0;
  for (size_t i = 0; i < count; ++i) {
    waiting = work_out<kChannels>(pieces[i], layer, waiting, steps);
    if (waiting < kStepsAtOnce && i + 1 < count) continue;
    add_steps<kChannels>(steps, waiting, layer.sums);
    waiting = 0;
  }
}
