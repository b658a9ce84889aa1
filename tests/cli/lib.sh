# Sourced by every test here as: source "$(dirname "$0")/lib.sh"
# Arguments of the test: the flatray binary, the root of the project, the sanitizers of the build. It runs in an empty
# folder that goes away.
set -u
flatray=$1
root=$2
sanitizers=${3:-}
here=$(cd "$(dirname "$0")" && pwd)
unset CI "${!FLATRAY_@}" 2> /dev/null
# Leaks are looked for where a test has set `leaks` before: to look takes longer than most runs, and Mesa and Embree have some.
[[ -n ${leaks:-} ]] || export ASAN_OPTIONS=detect_leaks=0
work=$(mktemp -d)
trap 'umount "$work/disk" 2> /dev/null; chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}

# run CODE ARGS...: runs flatray, whose output goes to $work/out.txt and $work/err.txt, and expects the exit code.
run() {
  local code=$1 got
  shift
  "$flatray" "$@" > "$work/out.txt" 2> "$work/err.txt"
  got=$?
  ((got == code)) && return
  fail "flatray $*: exit code $got, expected $code"
  sed 's/^/    /' "$work/err.txt" | head -5
}

# says out|err TEXT: the last run wrote the text. A shell that reads it itself is ten times as fast as grep, which knows NUL.
says() {
  local text
  IFS= read -rd '' text < "$work/$1.txt"
  [[ $text == *"$2"* ]] || grep -qF -e "$2" "$work/$1.txt" && return
  fail "std$1 lacks: $2"
  sed 's/^/    /' "$work/$1.txt" | head -8
}
silent() { [[ ! -s $work/$1.txt ]] || fail "std$1 is not empty: $(head -1 "$work/$1.txt")"; }

# limit_memory KIB: of what is run from here on. Sanitizers map more than any limit allows.
limit_memory() { [[ -n $sanitizers ]] || ulimit -v "$1"; }

# same A B WHAT: two folders hold the same pictures, byte for byte, and at least one.
same() {
  local a b
  a=$(cd "$1" && sha256sum -- *.png 2> /dev/null)
  b=$(cd "$2" && sha256sum -- *.png 2> /dev/null)
  [[ -n $a && $a == "$b" ]] || fail "$3: pictures in $1 and $2 differ"
}
# The manifests of a folder as one, by frame.
manifest() { cat "$1"/manifest*.jsonl | sed 's/{"frame":\([0-9]*\).*/\1 &/' | sort -n | cut -d' ' -f2-; }
same_manifest() { [[ $(manifest "$1") == "$(manifest "$2")" ]] || fail "$3: manifests differ"; }

# exists|absent PATH...
exists() { for path; do [[ -e $path ]] || fail "not there: $path"; done; }
absent() { for path; do [[ ! -e $path ]] || fail "should not be there: $path"; done; }

# size_of PNG: "WxH" from its header.
size_of() { printf '%dx%d' $(od -An -j16 -N8 -tu1 "$1" | awk '{ print ($1*256+$2)*65536+$3*256+$4, ($5*256+$6)*65536+$7*256+$8 }'); }

# scene FILE FRAMES [LINE...]: a moving box, with more lines of TOML.
scene() {
  local file=$1 frames=$2
  shift 2
  {
    printf 'flatray = 1\nframes = %s\n' "$frames"
    printf 'film = { size = [64, 48], world = [[0, 0], [16, 12]] }\n'
    printf '%s\n' '[[entity]]' 'name = "box"' 'shape = { box = { min = [0, 0], max = [4, 3] } }' \
      'at = [1, 2]' 'velocity = [12, 3.5]' 'angular_velocity = 30' 'fill = "#c0392b"' "$@"
  } > "$file"
}

finish() { exit $((failures > 0)); }
