#!/usr/bin/env bash
# make_seeds.sh: writes tests/fuzz/seeds/<target>/ again: stiff texts and headers, small. What the project's scenes and
# goldens hold is not copied: tools/fuzz gives their folders to the targets as well.
set -euo pipefail
cd "$(dirname "$0")"
rm -rf seeds
mkdir -p seeds/{toml,obj,list,hill,hqz,png,film,override,render,query}

repeat() { printf "%.0s$1" $(seq "$2"); }
seed() { cat > "seeds/$1"; }
entity='flatray = 1\n[[entity]]\nname = "a"\n'

printf '' | seed toml/empty
printf 'flatray = 1' | seed toml/no_final_newline
printf '\xef\xbb\xbfflatray = 1\r\n[[ray]]\r\nat = [0, 0]\r\ndirection = [1, 1]\r\n' | seed toml/bom_crlf
printf 'flatray = 1\n# \x00 NUL\nseed = \x000' | seed toml/nul
printf "$entity"'fill = "\xff\xfe\xc0\x80"\n' | seed toml/invalid_utf8
printf "$entity"'label = "\xc2\x9b31m"\n' | seed toml/control
{ printf 'a = '; repeat '[' 300; } | seed toml/brackets
{ printf 'a = '; repeat '{a=' 300; } | seed toml/braces
{ repeat 'a.' 100; printf 'a = 1'; } | seed toml/dots
{ printf "$entity"'shape = { polygon = { points = ['; repeat '[0, 1e300], [5e-324, -1], ' 4; printf ']}}\n'; } | seed toml/points
printf "$entity"'shape = { box = { min = [1e16, 0], max = [10000000000000001, 1] } }\n' | seed toml/lost_feature
printf "$entity"'shape = { circle = { radius = -0.0 } }\nstroke = { width = 1e300, colour = "#00000000" }\n' | seed toml/stroke
printf 'flatray = 1\nfilm = { size = [4294967297, 0] }\nframes = -1\nfps = inf\nseed = 1e400\n' | seed toml/numbers
printf 'flatray = 1\n[markov.a]\nA = { A = 0.3, B = 0.3 }\nB = { B = 1 }\n' | seed toml/chain
printf "$entity"'shape = { import = { file = "f.toml" } }\n' | seed toml/self_import

disc="$entity"'shape = { circle = { radius = 1 } }\n'
printf "$disc"'fill = { radial = { radius = 1, stops = ["#ff000080", "#00ff00"] } }\nopacity = 0.5\n' | seed render/gradient
printf "$disc"'stroke = { width_px = 3, dashes = [2, 1, 0, 1], caps = "square", colour = "#123456" }\nvelocity = [1e3, -1]\n' | seed render/dashes
printf 'frames = 3\n'"$disc"'at = { keys = [[0, [0, 0]], [0.1, [1, 2]]], ease = "smooth" }\nrepeat = { ring = { count = 5, radius = 3 } }\n' | seed render/curve
printf "$entity"'shape = { ngon = { sides = 40, radius = { uniform = [1e-9, 1e9] } } }\nstroke = { width = 1, joins = "miter", miter_limit = 99 }\nrepeat = { scatter = { count = 9, in = [[0, 0], [9, 9]] } }\n' | seed render/random
printf "$entity"'shape = { sector = { radius = 3, inner = 1, from = 0, to = 360 } }\nstroke = { width = 0.2 }\nfollow = { path = [[0, 0], [5, 5], [0, 5]], duration = 2, closed = true, turn = true }\n' | seed render/sector
printf 'flatray = 1\nfilm = { coverage = "centre" }\n[[chamber]]\nshape = { box = { min = [0, 0], max = [9, 5] } }\nopacity = 0.4\npillars = [{ shape = { circle = { radius = 1 } }, at = [4, 2] }]\n[[ray]]\nat = [1, 1]\ndirection = [3, 1]\nbounces = 9\nhit_points = "#000000"\n' | seed render/chamber
printf 'flatray = 1\nframes = 2\n[[group]]\nname = "g"\nangular_velocity = 90\n[[entity]]\ngroup = "g"\nat = [3, 0]\nshape = { text = { string = "ab", size = 2 } }\nbounding_box = { width = 0.1 }\n[[entity]]\nshape = { polygon = { points = [[0, 0], [4, 4], [4, 0], [0, 4]], fill_rule = "even-odd" } }\n' | seed render/group

# A find: edge rays of an entity whose shape is wrong.
seed render/edge_rays <<'END'
# The paper's case I, block a: one ray against one polygon. The inside part is drawn thick.
# The ray runs from (1,2) to ([5, 5]] } }
fill   = "#b9dfb4"
stroke = { width_px = 1.5, colour = "#2c7a3f" }
bounding_box = { width_px = 1, colour = "#2c7a3f66" }

[[entity]]
name   = "ray"
shape  = { segment = { from = [1, 2], ti = [23, 12] } }
stroke = { width_px = 1, colour = "#2f5fb3" }

[[edge_rays]]
from    = "ray"
against = "polygon"
stroke  = { width_px = 1.25, colour = "#2f5fb3" }
inside  = "#1d3f80"
enter   = "#1e9e4a"
exit    = "#d62728"
END

square='v 0 0\nv 4 0\nv 4 4\nv 0 4\n'
printf "${square}f 1 2 3 4\n" | seed obj/square
printf "${square}f -4/1/1 -3//2 -2/3 \\\\\r\n -1\nl 1 2 3" | seed obj/backwards
printf 'v 0 0\nv 4 0\nv 4 4\nv 2 1\nv 0 4\nvt 0 0\nf 1/1 2/1 3/1 4/1 5/1\n' | seed obj/not_convex
printf "${square}f 1 3 2 4\nf 1 1 2\nf 1 2 99999999999999999999\n" | seed obj/wrong
printf 'v 1e308 -1e308\nv 5e-324 1e-400\nv 1e16 10000000000000001\nf 1 2 3\nf 3 2 1' | seed obj/stiff
printf '\xef\xbb\xbfv 0 0\x00\r\nv \xff\xfe 1\r\n' | seed obj/bytes
printf 'SPIDER, 200,200\nBAT, 1.5, -2e1\n# end\n' | seed list/two
printf '{ SPIDER MAN, 200,200}\r\n\xff\xc2\x9b, 1e308, 5e-324' | seed list/bytes
{ repeat 'A, 0, 0\n' 20; } | seed list/many

printf '2\n4 1 1 1\n0 0\n4 0\n4 4\n0 4\n3 1 0 0\n1 1\n2 1\n1 2\n' | seed hill/room
printf '1 3 0 0 0 1e308 -1e308 5e-324 0 1e16 10000000000000001 more' | seed hill/odd
printf '99999999999\r\n\xff 2 nan' | seed hill/wrong

view='"resolution":[8,4],"viewport":[0,0,8,4],"exposure":0.5,"rays":9'
printf "{$view"',"gamma":2.2,"seed":1,"lights":[[1,[1,2],2,[0,360],[0,1],[0,360],[5000,"K"]],[1,3,3,0,0,0,[400,500]]],"objects":[[0,1,1,3,0],[0,2,1,3,0],[0,0,0,90,2,0,30]],"materials":[[[0.5,"d"],[0.2,"t"],[0.3,"r"]]]}' | seed hqz/all
printf "{$view"',"lights":[[1,2,2,0,0,[0,360],0]],"objects":[],"materials":[]}\n\n{'"$view"',"lights":[[3,2,2,0,0,[0,360],0]],"objects":[[0,0,0,1,1]],"materials":[[]]}\r\n' | seed hqz/lines
printf "{$view"',"lights":[[1e308,null,-0,1e-400,0,[9,1],-1]],"objects":[[99,0,0,0,0]],"materials":[[[2,"x"],[-1,"d"]]],"x":"\\ud83d\\ude00"}' | seed hqz/wrong
{ repeat '[' 70; } | seed hqz/brackets

printf '{"id":"a","op":"clip","polygon":[[20,2],[16,10],[10,10],[5,5]],"origin":[1,2],"direction":[22,10]}' | seed query/clip
printf '{"op":"clip","disc":{"center":[0,0],"radius":1},"origin":[-2,1],"direction":[1,0],"domain":"line"}' | seed query/disc
printf '{"op":"nearest","walls":[{"segment":[[0,0],[1,1]]},{"circle":{"center":[3,0],"radius":1}},{"arc":{"center":[0,0],"radius":2,"towards":[1,0]}}],"origin":[-1,0.5],"direction":[1,0]}' | seed query/nearest
printf '{"op":"orbit","walls":[{"segment":[[0,0],[4,0]]},{"segment":[[4,0],[0,3]]},{"segment":[[0,3],[0,0]]}],"origin":[1,1],"direction":[1,0.3],"bounces":9}' | seed query/orbit
printf '{"op":"contact","domain":"unit","a":{"polygon":[[0,0],[2,0]],"velocity":[0,0],"spin":-60},"b":{"polygon":[[1,-1],[1,-9],[9,-9]],"velocity":[0,1e308]}}' | seed query/contact
printf '{"id":{"a":[1e400,"\\ud800"]},"op":"clip","op":"none","polygon":[[]]' | seed query/wrong

head='\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHDR'
printf "$head"'\x00\x00\x00\x01\x00\x00\x00\x01\x08\x02\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x0cIDAT\x78\x9c\x63\x60\x60\x60\x00\x00\x00\x04\x00\x01\x00\x00\x00\x00\x00\x00\x00\x00IEND\x00\x00\x00\x00' | seed png/one_pixel
printf "$head"'\x7f\xff\xff\xff\x7f\xff\xff\xff\x10\x06\x00\x00\x01\x00\x00\x00\x00' | seed png/huge
printf "$head"'\x00\x00\x00\x02\x00\x00\x00\x02\x01\x03\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x06PLTE\x00\x00\x00\xff\xff\xff\x00\x00\x00\x00\x00\x00\x00\x0cIDAT\x78\x9c\x63\x60\x60\x60\x00\x00\x00\x04\x00\x01\x00\x00\x00\x00\x00\x00\x00\x00IEND\x00\x00\x00\x00' | seed png/palette
zero='\x00\x00\x00\x00\x00\x00\x00'
film() { printf 'flatray film 1\n'; for number; do printf "\\x$number$zero"; done; }
{ film 02 01 01 01 01 01 01 01 00 00 00; printf '{}'; printf "\\x05$zero\\x07$zero\\x02$zero\\x09\\x00$zero"; } | seed film/one_pixel
film 00 ff ff 03 40 00 00 08 00 00 00 | seed film/huge
printf 'film.size=[3,4]\nentity.0.at=[1,2]\nentity.runner.fill="none"\n' | seed override/three
printf 'markov.run.RUN.DIE=0.7\na.b.c.d={e=[1,{f=2}]}\n=\n..=1\nentity.999999999999.at=1' | seed override/odd
{ repeat 'a.' 200; printf '=1\nfilm='; repeat '[' 300; } | seed override/deep
du -sb seeds
