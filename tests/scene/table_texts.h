#pragma once
#include <string>

namespace flatray {

/// A scene with a place for one more key of a table.
struct TableText {
  const char *name, *text;  // @ stands where a key may
};

/// Every table of the language.
inline constexpr TableText kTables[] = {
    {"scene", "flatray = 1\n@"},
    {"film", "flatray = 1\nfilm = { @ }"},
    {"camera", "flatray = 1\n[camera]\n@"},
    {"entity", "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\n@"},
    {"markov",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmarkov = { chain = \"c\", @ "
     "}\n[markov.c]\nA = { A = 1 }"},
    {"state A",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmarkov = { chain = \"c\" "
     "}\nstates = { A = { @ } }\n[markov.c]\nA = { A = 1 }"},
    {"stroke", "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nstroke = { @ }"},
    {"curve",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nangle = { keys = [[0, 0]], @ "
     "}"},
    {"follow",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nfollow = { path = [[0, 0], [1, "
     "0]], speed = 1, @ }"},
    {"collisions", "flatray = 1\n[collisions]\n@"},
    {"group", "flatray = 1\n[[group]]\nname = \"g\"\n@"},
    {"repeat", "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nrepeat = { @ }"},
    {"repeat.grid",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nrepeat = { grid = { count = "
     "[1, 1], step = [1, 1], @ } }"},
    {"repeat.ring",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nrepeat = { ring = { count = 1, "
     "radius = 1, @ } }"},
    {"repeat.scatter",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nrepeat = { scatter = { count = "
     "1, in = [[0, 0], [1, 1]], @ } }"},
    {"linear",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nfill = { linear = { from = [0, "
     "0], "
     "to = [1, 0], stops = [\"#000000\", \"#ffffff\"], @ } }"},
    {"radial",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nfill = { radial = { radius = "
     "1, "
     "stops = [\"#000000\", \"#ffffff\"], @ } }"},
    {"chamber", "flatray = 1\n[[chamber]]\nshape = { circle = { radius = 1 } }\n@"},
    {"pillar",
     "flatray = 1\n[[chamber]]\nshape = { circle = { radius = 9 } }\n[[chamber.pillars]]\nshape = "
     "{ circle = { radius = 1 } }\n@"},
    {"hole",
     "flatray = 1\n[[chamber]]\nshape = { circle = { radius = 9 } }\n[[chamber.holes]]\nfrom = "
     "0.1\nto = 0.2\n@"},
    {"ray", "flatray = 1\n[[ray]]\nat = [0, 0]\ndirection = [1, 0]\n@"},
    {"ray.fan", "flatray = 1\n[[ray]]\nat = [0, 0]\ndirection = [1, 0]\nfan = { count = 2, @ }"},
    {"ray.ball",
     "flatray = 1\n[[ray]]\nat = [0, 0]\ndirection = [1, 0]\nball = { speed = 1, radius = 1, @ "
     "}"},
    {"edge_rays",
     "flatray = 1\n[[entity]]\nname = \"a\"\nshape = { circle = { radius = 1 } "
     "}\n[[edge_rays]]\nfrom = \"a\"\nagainst = \"a\"\n@"},
    {"markov.c", "flatray = 1\n[markov.c]\nA = { A = 1 }\n@"},
    {"box", "flatray = 1\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1], @ } }"},
    {"cell", "flatray = 1\n[[entity]]\nshape = { cell = { a = [1, 0], b = [0, 1], @ } }"},
    {"circle", "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1, @ } }"},
    {"convex",
     "flatray = 1\n[[entity]]\nshape = { convex = { points = [[0, 0], [1, 0], [0, 1]], @ } }"},
    {"polygon",
     "flatray = 1\n[[entity]]\nshape = { polygon = { points = [[0, 0], [1, 0], [0, 1]], @ } }"},
    {"segment", "flatray = 1\n[[entity]]\nshape = { segment = { from = [0, 0], to = [1, 0], @ } }"},
    {"ngon", "flatray = 1\n[[entity]]\nshape = { ngon = { sides = 5, radius = 1, @ } }"},
    {"polyline",
     "flatray = 1\n[[entity]]\nshape = { polyline = { points = [[0, 0], [1, 0]], @ } }"},
    {"star", "flatray = 1\n[[entity]]\nshape = { star = { points = 5, outer = 2, inner = 1, @ } }"},
    {"arc", "flatray = 1\n[[entity]]\nshape = { arc = { radius = 1, from = 0, to = 9, @ } }"},
    {"capsule",
     "flatray = 1\n[[entity]]\nshape = { capsule = { from = [0, 0], to = [1, 0], radius = 1, @ } "
     "}"},
    {"ellipse", "flatray = 1\n[[entity]]\nshape = { ellipse = { radii = [2, 1], @ } }"},
    {"sector", "flatray = 1\n[[entity]]\nshape = { sector = { radius = 1, from = 0, to = 9, @ } }"},
    {"lens",
     "flatray = 1\n[[entity]]\nshape = { lens = { height = 1, thickness = 1, radii = [1, 1], @ } "
     "}"},
    {"mushroom",
     "flatray = 1\n[[entity]]\nshape = { mushroom = { radius = 2, width = 1, height = 1, @ } }"},
    {"bezier",
     "flatray = 1\n[[entity]]\nshape = { bezier = { points = [[0, 0], [1, 0], [2, 1], [3, 3]], @ } "
     "}"},
    {"conic",
     "flatray = 1\n[[entity]]\nshape = { conic = { vertex = [0, 0], focus = [0, 1], width = 2, @ } "
     "}"},
    {"parabola",
     "flatray = 1\n[[entity]]\nshape = { parabola = { vertex = [0, 0], focus = [0, 1], width = 2, "
     "@ "
     "} }"},
    {"penrose", "flatray = 1\n[[entity]]\nshape = { penrose = { size = 1, @ } }"},
    {"tokarsky", "flatray = 1\n[[entity]]\nshape = { tokarsky = { size = 1, @ } }"},
    {"text", "flatray = 1\n[[entity]]\nshape = { text = { string = \"a\", size = 1, @ } }"},
    {"lamp", "flatray = 1\n[[lamp]]\nsource = { point = {} }\n@"},
    {"lamp state A",
     "flatray = 1\n[[lamp]]\nsource = { point = {} }\nmarkov = { chain = \"c\" }\nstates = { A = "
     "{ @ } }\n[markov.c]\nA = { A = 1 }"},
    {"light", "flatray = 1\n[light]\n@"},
    {"lamp.arc", "flatray = 1\n[[lamp]]\nsource = { arc = { radius = 1, @ } }"},
    {"lamp.beam", "flatray = 1\n[[lamp]]\nsource = { beam = { width = 1, @ } }"},
    {"lamp.cone", "flatray = 1\n[[lamp]]\nsource = { cone = { spread = 1, @ } }"},
    {"lamp.point", "flatray = 1\n[[lamp]]\nsource = { point = { @ } }"},
    {"lamp.ranges", "flatray = 1\n[[lamp]]\nsource = { ranges = { @ } }"},
    {"lamp.ray", "flatray = 1\n[[lamp]]\nsource = { ray = { @ } }"},
    {"lamp.segment",
     "flatray = 1\n[[lamp]]\nsource = { segment = { from = [0, 0], to = [1, 0], @ } }"},
    {"material.diffuse",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { diffuse = { @ } "
     "}"},
    {"material.glass",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { glass = { @ } }"},
    {"material.isotropic",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { isotropic = { @ } "
     "}"},
    {"material.mirror",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { mirror = { @ } }"},
    {"material.mix",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { mix = { @ } }"},
    {"material.pass",
     "flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nmaterial = { pass = { @ } }"},
    {"import", "flatray = 1\n[[entity]]\nshape = { import = { file = \"a.obj\", @ } }"},
};

inline std::string with_key(const TableText& table, const std::string& key,
                            const std::string& value = "1") {
  std::string text = table.text;
  return text.replace(text.find('@'), 1, key + " = " + value);
}

/// A table's name in the documents: that in messages but for states, pillars and chains.
inline std::string documented_name(const std::string& name) {
  if (name == "state A") return "entity.states";
  if (name == "lamp state A") return "lamp.states";
  if (name == "markov") return "entity.markov";
  if (name == "pillar") return "chamber.pillars";
  if (name == "hole") return "chamber.holes";
  return name == "markov.c" ? "markov.NAME" : name;
}

/// The text of the table that the documents call so, or nullptr.
inline const TableText* text_of(const std::string& documented) {
  for (const TableText& table : kTables)
    if (documented_name(table.name) == documented) return &table;
  return nullptr;
}

}  // namespace flatray
