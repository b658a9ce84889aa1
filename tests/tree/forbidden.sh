#!/usr/bin/env bash
# forbidden.sh ROOT: looks for what must not stand in the sources, and prints file:line of each find.
# Comments (// and #) are passed over where the row says `code`. Each row first proves itself on a line it must catch
# and on a line it must let through.
set -euo pipefail
cd "$1"

libm='sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erf|erfc|tgamma|lgamma'
failures=0

# rule NAME KIND FILES ALLOWED PATTERN CATCHES PASSES
#   KIND     code: without comments; text: every line
#   FILES    regular expression of the paths that are read; ALLOWED: of those that may
#   PATTERN  what is forbidden there; CATCHES and PASSES: a line that is, a line that is not
rule() {
  local name=$1 kind=$2 files=$3 allowed=$4 pattern=$5 catches=$6 passes=$7
  if ! grep -qE -e "$pattern" <<<"$catches" || grep -qE -e "$pattern" <<<"$passes"; then
    echo "tests/tree/forbidden.sh: the rule '$name' is wrong about its own examples"
    failures=$((failures + 1))
  fi
  local read_files finds
  mapfile -t read_files < <(grep -E -e "$files" <<<"$all_files" | grep -vE -e "$allowed")
  ((${#read_files[@]} > 0)) || return 0
  finds=$(cd "$copy/$kind" && grep -nHE -e "$pattern" "${read_files[@]}" || true)
  [[ -n $finds ]] || return 0
  sed "s|\$|    <- $name|" <<<"$finds"
  failures=$((failures + $(wc -l <<<"$finds")))
}

all_files=$(find . \( -path ./build -o -path ./out -o -path ./.git -o -path ./tests/tree -o -name node_modules \) -prune -o -type f -print |
  sed 's,^\./,,' | grep -vE '\.(png|hdr|swp)$|~$' | sort)

# Two copies of the tree to search: `text` as it is, `code` without comments.
copy=$(mktemp -d)
trap 'rm -r "$copy"' EXIT
mkdir "$copy/text" "$copy/code"
xargs -d '\n' cp --parents -t "$copy/text" <<<"$all_files"
cp -r "$copy/text/." "$copy/code"
find "$copy/code" \( -name '*.h' -o -name '*.cpp' \) -exec sed -i 's,//.*,,' {} +
find "$copy/code" -type f -not -name '*.h' -not -name '*.cpp' -exec sed -i -E 's,(^|[[:space:]])#.*,,' {} +

sources='^(src|tests|benchmarks|examples)/.*\.(h|cpp)$'
library='^src/(base|geom|trace|image|scene|anim|collide|transport|precise|render|oracle|study)/.*\.(h|cpp)$'
build='(^|/)(CMakeLists\.txt|CMakePresets\.json)$|\.cmake$'
none='^$'

rule 'functions of libm differ between machines: use base/portable_math' code \
  '^src/.*\.(h|cpp)$' '^src/base/portable_math\.(h|cpp)$' \
  "(^|[^A-Za-z0-9_:.>])(::)?(std::)?($libm)[fl]?[[:space:]]*\\(" \
  'const double y = std::sin(x);' 'const double y = portable::sin(x) + my_exp(x) + std::sqrt(x);'
rule "Eigen's angles and norms use libm" code '^src/.*\.(h|cpp)$' "$none" \
  'Rotation2D|AngleAxis|hypotNorm|\.array\(\)\.(sin|cos|tan|exp|log|pow)' \
  'Eigen::Rotation2Dd turn(angle);' 'const double length = v.norm();'
rule 'the generators of <random> differ between libraries: use base/philox' code "$sources" "$none" \
  '<random>|std::(mt19937|minstd_rand|default_random_engine|random_device|uniform_[a-z]+_distribution|shuffle)|[^_a-z]s?rand\(' \
  '#include <random>' 'random_bits(seed, Stream::markov, step, entity, 0);'
rule 'the build downloads nothing' code "$build" "$none" \
  'FetchContent|ExternalProject|file\(DOWNLOAD|CPMAddPackage' \
  'include(FetchContent)' 'find_package(fmt REQUIRED)'
rule 'flags that change the bits' code "$build|^tools/|^\\.ci/" "$none" \
  '-ffast-math|-Ofast|-march=native|-ffp-contract=(fast|on)|-funsafe-math' \
  'add_compile_options(-march=native)' 'add_compile_options(-ffp-contract=off -mavx2 -mfma)'
rule 'a bare epsilon' code '^src/(geom|trace|image|scene|anim|collide|transport|precise|render)/.*\.(h|cpp)$' \
  '^src/geom/error_bounds\.h$' \
  '[0-9.]e-(0?[4-9]|[1-9][0-9])([^0-9]|$)|numeric_limits<(double|float)>::epsilon' \
  'if (std::fabs(d) < 1e-9) return;' 'const double half = 0.5e-3;'
rule 'libraries neither print nor exit' code "$library" '^src/base/check\.cpp$' \
  '#include <iostream>|std::(cout|cerr|clog|puts|printf|exit|abort|terminate)|fmt::print|[^a-z_:]f?printf\(|(^|[;{}])[[:space:]]*(exit|abort|_exit)\(' \
  '  if (x) { exit(1); }' ': enter(low), exit(high) { out += fmt::format("{}", x); }'
rule 'no run-time type information' code "$sources" "$none" \
  'dynamic_cast|typeid\(' 'auto* p = dynamic_cast<A*>(q);' 'static_cast<int>(x)'
rule 'work that is left open' text "$sources|$build|^tools/|^docs/|^[A-Z]+\\.md$" '^tests/tree/' \
  '(^|[^A-Za-z])(TODO|FIXME|XXX|HACK)([^A-Za-z]|$)' '// TODO: later' '// to do this, see below'
rule 'a merge left half done' text '.' "$none" '^(<<<<<<<|>>>>>>>)( |$)' '<<<<<<< HEAD' 'std::cout << x;'
rule 'paths of one machine' text '.' '^\.git$' \
  '(^|[^A-Za-z0-9_.}])/(work|root|home|mnt|Users)/[a-z]' \
  'path = "/home/me/scene.toml"' 'see tests/root/a and $prefix/home/x'
rule 'toml++ belongs to one scene format' code "$sources" '^src/scene/formats/[a-z_]+\.cpp$' \
  '#include <toml\+\+/' '#include <toml++/toml.h>' '#include <Eigen/Core>'
rule 'nlohmann-json stays out of headers and of the geometry' code "$sources" \
  '^(src/base/(read_)?json|tests/.*)\.cpp$' \
  '#include <nlohmann/' '#include <nlohmann/json.hpp>' '#include <Eigen/Core>'
rule 'GMP belongs to geom/exact and the oracle' code "$sources" '^src/(geom/exact|oracle/.*)\.cpp$|^tests/.*\.cpp$' \
  '#include <(gmp|gmpxx)\.h>' '#include <gmp.h>' '#include <Eigen/Core>'
rule 'SLEEF belongs to base/portable_math' code "$sources" '^src/base/portable_math\.cpp$' \
  '#include <sleef' '#include <sleef.h>' '#include <Eigen/Core>'
rule 'MPFR belongs to precise, and to tests as a second opinion' code "$sources" '^src/precise/ball\.h$|^tests/.*\.cpp$' \
  '#include <mpfr' '#include <mpfr.h>' '#include <Eigen/Core>'
rule 'stb belongs to the image module, its font to one source' code "$sources" '^(src/image(/encoders)?|benchmarks(/peers)?)/[a-z_]+\.cpp$|^src/scene/outlines/easy_font\.cpp$' \
  '#include ["<](stb/|stb_)' '#include <stb_image.h>' '#include <Eigen/Core>'
rule 'of Eigen, headers take the core' code '\.h$' "$none" \
  '#include <Eigen/(Dense|LU|QR|SVD|Geometry|Eigenvalues)>' '#include <Eigen/Dense>' '#include <Eigen/Core>'

echo "forbidden: $(wc -l <<<"$all_files") files, $failures finds"
((failures == 0))
