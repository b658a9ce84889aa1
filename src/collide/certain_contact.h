#pragma once
#include <cstddef>
#include <vector>

#include "collide/contact_batch.h"

namespace flatray {

/// The contacts of many pairs for t in [0, length], from the edges a kernel has guessed.
///
/// Needs   shapes that are ready, in relative motion; length > 0; no more than kMost pairs.
/// Gives   what contact() does, but for pairs where no guess is proven right, or an end of the range
///         is met exactly: those are `undecided`.
/// Source  an edge of the Minkowski difference is one where the neighbours of the vertex that meets
///         it lie beyond that vertex; the origin comes in by it where its ends are on the left and
///         right of its way. Four predicates prove an edge, whoever found it, and their signs lead
///         from an edge beside it along the outline.
class CertainContacts {
 public:
  static constexpr std::size_t kMost = pairs::kMostEdges / 2;

  CertainContacts(const BodySet& bodies, double length, decltype(pairs::Kernels::certify) kernel)
      : bodies_(bodies), length_(length), kernel_(kernel) {
    items_.reserve(kMost);
    asks_.reserve(pairs::kMostEdges);
  }

  /// Needs   a contact that is a miss; pair and contact outlive run().
  void add(const MovingPair& pair, const pairs::Candidates& guess, Contact& contact);
  /// Proves all that was added, and forgets it; undecided(pair, contact) for what is left.
  template <class Undecided>
  void run(const Undecided& undecided) {
    prove();
    for (const Item& item : items_) {
      if (item.apart)
        *item.contact = {};
      else if (item.unsure)
        undecided(*item.pair, *item.contact);
    }
    items_.clear();
    asks_.clear();
  }

 private:
  struct Item {
    const MovingPair* pair;
    Contact* contact;
    const BodySet::Ready *a, *b;
    bool apart = false, unsure = false;
  };
  // An edge of the difference: it begins at corner `a` of the first shape minus corner `b` of the
  // second, and goes on along the one or the other.
  struct Ask {
    Item* item;
    int a, b;
    bool of_a, comes_in;

    void move_edge(bool on);
  };

  void ask(Item& item, float guess, bool comes_in);
  void prove();
  bool settle(Ask& ask, std::size_t at);
  void accept(const Ask& ask, bool before, double time) const;

  const BodySet& bodies_;
  const double length_;
  const decltype(pairs::Kernels::certify) kernel_;
  std::vector<Item> items_;
  std::vector<Ask> asks_;
  pairs::Edges proofs_;
};

}  // namespace flatray
