// When moving bodies meet: a box flies towards a wedge, and a disc past another.
// Prints the first and the last time of each pair. The box touches the tip of the wedge at 7/3 and
// leaves it at 5; the discs, whose radii add up to their least distance, touch at 4 alone.
#include <flatray/collide.h>

#include <cstdio>
#include <vector>

namespace fr = flatray::api;

int main() {
  fr::Bodies bodies;
  const std::vector<double> box_x = {0, 1, 1, 0}, box_y = {0, 0, 1, 1};    // body 0
  const std::vector<double> wedge_x = {8, 15, 15}, wedge_y = {0.5, 0, 1};  // body 1
  const std::vector<double> x = {0, 8}, y = {0, 3}, radius = {1, 2};       // bodies 2 and 3
  if (!bodies.add_polygon(box_x, box_y) || !bodies.add_polygon(wedge_x, wedge_y) ||
      !bodies.add_discs(x, y, radius))
    return 1;

  const std::vector<fr::MovingPair> pairs = {{0, 1, 3, 0, 0, 0}, {2, 3, 2, 0, 0, 0}};
  std::vector<fr::Contact> contacts(pairs.size());
  if (!bodies.contacts(pairs, fr::kRay, contacts)) return 1;
  for (const fr::Contact& contact : contacts)
    std::printf("from t = %.17g to t = %.17g\n", contact.first, contact.last);

  return contacts[0].kind == fr::HitClass::through && contacts[0].first == 7.0 / 3.0 &&
                 contacts[0].last == 5 && contacts[1].kind == fr::HitClass::touch &&
                 contacts[1].first == 4 && contacts[1].last == 4
             ? 0
             : 1;
}
