#!/usr/bin/env bash
# needs: formats/obj
# What a scene, the folder it came in, or a link in it names elsewhere is neither read, quoted nor written.
source "$(dirname "$0")/lib.sh"
mkdir -p box/in/deep outside plain
echo 'secret = "of another"' > outside/secret.toml
printf 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n' | tee outside/shape.obj > box/in/shape.obj
printf 'flatray = 1\n' > box/in/part.toml
ln -s ../../outside/secret.toml box/in/link.toml
ln -s ../../outside box/in/folder
ln -s deep/../shape.obj box/in/inner.obj
ln -s nowhere box/in/dangling.obj

including() { printf 'flatray = 1\ninclude = ["%s"]\n' "$1"; }
importing() { printf 'flatray = 1\n[[entity]]\nshape = { import = { file = "%s" } }\n' "$1"; }
# refused FROM LINES: the scene of these lines, run in the folder, says that a file lies outside and nothing of it.
refused() {
  printf '%s\n' "$2" > "$work/box/in/scene.toml"
  cd "$work/$1" || exit 1
  run 4 check "$work/box/in/scene.toml"
  says err "lies outside of"
  grep -qe secret -e 'of another' "$work/err.txt" && [[ $2 != *secret* ]] && fail "quoted: $2"
  cd "$work" || exit 1
}
for name in ../../outside/secret.toml link.toml folder/secret.toml; do refused plain "$(including $name)"; done
for name in ../../outside/shape.obj folder/shape.obj "$work/outside/shape.obj" dangling.obj; do refused box "$(importing "$name")"; done
refused plain "$(importing ../shape.obj)"  # which is not there: nobody learns whether it is

# Beneath the root: of the scene, of the command, of --root.
importing inner.obj > box/in/scene.toml
(cd plain && run 0 check ../box/in/scene.toml && exit "$failures") || fail "a link that stays inside is refused"
importing ../shape.obj > box/in/deep/scene.toml
(cd plain && run 4 check ../box/in/deep/scene.toml && exit "$failures") || fail "the scene's folder is not the root"
(cd box && run 0 check in/deep/scene.toml && exit "$failures") || fail "the command's folder is not the root"
(cd plain && run 0 check ../box/in/deep/scene.toml --root ../box && exit "$failures") || fail "--root is not the root"
importing "$work/outside/shape.obj" > box/in/scene.toml
run 0 check box/in/scene.toml --root /

# --root: operands, options, and where output goes that is not named.
importing shape.obj > box/in/scene.toml
run 2 render box/in/scene.toml --root box
says err "'out' lies outside of --root box"
run 2 render box/in/scene.toml --root box -o outside/x.png
says err "--output: error: 'outside/x.png' lies outside of --root box"
run 2 render box/in/scene.toml --root box -o box/in/folder/x.png
run 0 render box/in/scene.toml --root box -o box/x.png --quiet
run 2 check outside/secret.toml --root box
run 2 convert box/in/scene.toml outside/new.toml --root box
run 2 compare box/x.png box/x.png --diff d.png --root box
FLATRAY_ROOT=box run 2 render box/in/scene.toml -o x.png
absent outside/x.png outside/new.toml d.png x.png

# A folder's flatray.toml.
cd plain || exit 1
cp ../box/x.png .
scene scene.toml 1
for place in ../outside/x.png "$work/outside/x.png" link/x.png; do
  ln -sfn ../outside link
  printf 'output = "%s"\n' "$place" > flatray.toml
  run 2 render scene.toml
  says err "output is '$place', outside of this folder"
done
printf 'root = "/"\n' > flatray.toml
run 2 render scene.toml
printf 'output = "sub/x.png"\n' > flatray.toml
run 0 render scene.toml --quiet
exists sub/x.png
rm flatray.toml
ln -s ../outside/secret.toml flatray.toml
run 3 render scene.toml
grep -q 'of another' "$work/err.txt" && fail "flatray.toml quotes another file"
absent ../outside/x.png
finish
