#include "collide/complementarity.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace flatray {
namespace {

// L D L^T of the rows and columns of M that are chosen, each row of L from its first entry on that is
// not 0. Columns that hang on those before have D = 0 and z = 0.
template <class Number>
class Factors {
 public:
  Factors(const Couplings<Number>& m, const std::vector<bool>& in) {
    for (std::size_t i = 0; i < in.size(); ++i)
      if (in[i]) chosen_.push_back(i);
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      fill(m, i);
      factor(i);
    }
  }

  // Products it took.
  double work() const {
    double sum = 0;
    for (const std::vector<Number>& row : rows_)
      sum += 0.5 * static_cast<double>(row.size()) * static_cast<double>(row.size());
    return sum;
  }

  // The z of M z = -q in those rows, of which all others are 0.
  std::vector<Number> solve(const std::vector<Number>& q) const {
    std::vector<Number> z;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      z.push_back(-q[chosen_[i]]);
      for (std::size_t k = first_[i]; k < i; ++k) z[i] -= row(i, k) * z[k];
    }
    for (std::size_t i = z.size(); i-- > 0;) {
      z[i] = hangs_[i] ? Number(0) : z[i] / diagonal_[i];
      for (std::size_t k = i + 1; k < z.size(); ++k)
        if (first_[k] <= i) z[i] -= hangs_[i] ? Number(0) : row(k, i) * z[k];
    }
    std::vector<Number> all(q.size(), Number(0));
    for (std::size_t i = 0; i < z.size(); ++i) all[chosen_[i]] = std::move(z[i]);
    return all;
  }

 private:
  const Number& row(std::size_t i, std::size_t k) const { return rows_[i][k - first_[i]]; }

  void fill(const Couplings<Number>& m, std::size_t i) {
    std::vector<std::pair<std::size_t, Number>> entries;
    for (const auto& [column, value] : m[chosen_[i]]) {
      const auto at = std::ranges::lower_bound(chosen_, column);
      if (at == chosen_.end() || *at > chosen_[i] || *at != column) continue;
      entries.emplace_back(at - chosen_.begin(), value);
    }
    std::size_t first = i;
    for (const auto& [column, value] : entries) first = std::min(first, column);
    first_.push_back(first);
    rows_.emplace_back(i - first + 1, Number(0));
    for (const auto& [column, value] : entries) rows_[i][column - first] = value;
  }

  void factor(std::size_t i) {
    std::vector<Number>& mine = rows_[i];
    const Number whole = mine.back();
    for (std::size_t k = first_[i]; k < i; ++k)
      for (std::size_t c = std::max(first_[i], first_[k]); c < k; ++c)
        mine[k - first_[i]] -= mine[c - first_[i]] * row(k, c);
    for (std::size_t k = first_[i]; k < i; ++k) {
      Number& entry = mine[k - first_[i]];
      const Number before = entry;
      entry = hangs_[k] ? Number(0) : entry / diagonal_[k];
      mine.back() -= before * entry;
    }
    constexpr double kRounding = 0x1p-40;  // of doubles, which only guess
    const bool exact = std::is_same_v<Number, Rational>;
    hangs_.push_back(nearest(mine.back()) <= (exact ? 0 : kRounding) * nearest(whole));
    diagonal_.push_back(mine.back());
  }

  std::vector<std::size_t> chosen_;
  std::vector<std::vector<Number>> rows_;
  std::vector<std::size_t> first_;
  std::vector<Number> diagonal_;
  std::vector<bool> hangs_;
};

// w of all.
template <class Number>
std::vector<Number> result(const Couplings<Number>& m, const std::vector<Number>& q,
                           const std::vector<Number>& z) {
  std::vector<Number> w = q;
  for (std::size_t i = 0; i < w.size(); ++i)
    for (const auto& [column, value] : m[i]) w[i] += value * z[column];
  return w;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double x : values) most = std::max(most, std::fabs(x));
  return most;
}

// Which unknowns are not 0, by doubles: those that are wrong are changed, all of them as long as they
// become fewer, else the last one.
Complementarity<double> guess(const Couplings<double>& m, const std::vector<double>& q) {
  constexpr double kRounding = 0x1p-40;
  constexpr int kPatience = 8;
  std::vector<bool> in(q.size(), false);
  std::size_t least = q.size() + 1;
  int patience = kPatience;
  double work = 0;
  for (std::size_t step = 0;; ++step) {
    const Factors<double> factors(m, in);
    work += factors.work();
    std::vector<double> z = factors.solve(q);
    if (work > kMostGuess) return {{}, std::vector<bool>(q.size(), false), false, true};
    const std::vector<double> w = result(m, q, z);
    const double least_z = -kRounding * largest(z), least_w = -kRounding * largest(q);
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < in.size(); ++i)
      if (in[i] ? z[i] < least_z : w[i] < least_w) wrong.push_back(i);
    if (wrong.empty() || step > 64 + q.size()) return {std::move(z), in, wrong.empty()};
    if (wrong.size() < least) {
      least = wrong.size();
      patience = kPatience;
    } else if (patience-- <= 0) {
      wrong = {wrong.back()};
    }
    for (const std::size_t i : wrong) in[i] = !in[i];
  }
}

// w - M z - z0 = q as rows solved for one unknown each: w are the columns 0 to n - 1, z the next n,
// then z0, then what is on the right.
class Tableau {
 public:
  Tableau(const Couplings<Rational>& m, const std::vector<Rational>& q) : n_(q.size()) {
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<Rational> row(2 * n_ + 2, Rational(0));
      row[i] = 1;
      for (const auto& [column, value] : m[i]) row[n_ + column] = -value;
      row[extra()] = -1;
      row[right()] = q[i];
      rows_.push_back(std::move(row));
      solved_for_.push_back(i);
    }
  }

  // z; nullopt where there is none. Where z = 0 will not do, z0 is brought in by the row that is least, and
  // then one unknown after the other, always the partner of the one that went, until z0 goes.
  std::optional<std::vector<Rational>> solve() {
    std::size_t least = 0;
    for (std::size_t i = 1; i < n_; ++i)
      if (rows_[i][right()] <= rows_[least][right()]) least = i;
    if (n_ > 0 && rows_[least][right()].sign() == Sign::negative) {
      enter(extra(), least);
      while (left_ != extra()) {
        const std::size_t column = left_ < n_ ? left_ + n_ : left_ - n_;
        std::optional<std::size_t> row;
        for (std::size_t i = 0; i < n_; ++i)
          if (rows_[i][column].sign() == Sign::positive && (!row || is_less(i, *row, column)))
            row = i;
        if (!row) return std::nullopt;
        enter(column, *row);
      }
    }
    std::vector<Rational> found(n_, Rational(0));
    for (std::size_t i = 0; i < n_; ++i)
      if (solved_for_[i] >= n_ && solved_for_[i] < extra())
        found[solved_for_[i] - n_] = rows_[i][right()];
    return found;
  }

 private:
  std::size_t extra() const { return 2 * n_; }
  std::size_t right() const { return 2 * n_ + 1; }

  // Whether row i, divided by what it has in a column, comes before row k in lexicographic order:
  // the right side, then the columns of w. Both have something positive there.
  bool is_less(std::size_t i, std::size_t k, std::size_t column) const {
    for (std::size_t c = right(); c == right() || c < n_; c = c == right() ? 0 : c + 1) {
      const auto order = rows_[i][c] * rows_[k][column] <=> rows_[k][c] * rows_[i][column];
      if (order != 0) return order < 0;
    }
    return false;
  }

  // Solves a row for the unknown of a column, which leaves the others.
  void enter(std::size_t column, std::size_t row) {
    std::vector<Rational>& by = rows_[row];
    const Rational divisor = by[column];
    for (Rational& entry : by)
      if (entry.sign() != Sign::zero) entry /= divisor;
    for (std::size_t i = 0; i < n_; ++i) {
      if (i == row || rows_[i][column].sign() == Sign::zero) continue;
      const Rational times = rows_[i][column];
      for (std::size_t c = 0; c < by.size(); ++c)
        if (by[c].sign() != Sign::zero) rows_[i][c] -= times * by[c];
    }
    left_ = std::exchange(solved_for_[row], column);
  }

  const std::size_t n_;
  std::vector<std::vector<Rational>> rows_;
  std::vector<std::size_t> solved_for_;
  std::size_t left_ = 0;  // the unknown that no row is solved for any more, of the last step
};

}  // namespace

std::optional<Complementarity<Rational>> solve_complementarity(const Couplings<Rational>& m,
                                                               const std::vector<Rational>& q) {
  Couplings<double> near_m(m.size());
  std::vector<double> near_q;
  for (std::size_t i = 0; i < m.size(); ++i) {
    near_q.push_back(nearest(q[i]));
    for (const auto& [column, value] : m[i]) near_m[i].emplace_back(column, nearest(value));
  }
  const std::vector<bool> in = guess(near_m, near_q).touches;
  std::vector<Rational> z = Factors<Rational>(m, in).solve(q), w = result(m, q, z);
  bool proven = true;
  for (std::size_t i = 0; i < q.size(); ++i)
    proven = proven && z[i].sign() != Sign::negative && w[i].sign() != Sign::negative &&
             !(in[i] && w[i].sign() == Sign::positive);
  if (!proven) {
    auto pivoted = Tableau(m, q).solve();
    if (!pivoted) return std::nullopt;
    z = *std::move(pivoted);
    w = result(m, q, z);
  }
  Complementarity<Rational> found{std::move(z), {}};
  for (const Rational& one : w) found.touches.push_back(one.sign() == Sign::zero);
  return found;
}

std::optional<Complementarity<double>> solve_complementarity(const Couplings<double>& m,
                                                             const std::vector<double>& q) {
  Complementarity<double> found = guess(m, q);
  if (!found.refused && !found.holds && q.size() <= kMostPivoted) return std::nullopt;
  return found;
}

// What has been eliminated k times is k times as long.
double work_of_proof(const Couplings<double>& m, double bits) {
  double work = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    std::size_t first = i;
    for (const auto& [column, value] : m[i]) first = std::min(first, column);
    const auto width = static_cast<double>(i - first + 1), words = 1 + width * bits / 64;
    work += width * width / 2 * words * words;
  }
  return work;
}

}  // namespace flatray
