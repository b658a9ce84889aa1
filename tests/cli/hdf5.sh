#!/usr/bin/env bash
# needs: experiments/mean_free_path experiments/poincare
# HDF5 is a module that the program does not link: experiments without it, what is said where it is not there, and
# what h5dump reads of what it wrote.
source "$(dirname "$0")/lib.sh"
sinai=$root/scenes/chamber/sinai.toml
module=$(dirname "$flatray")/flatray_hdf5.so

# Without the module --hdf5 is exit 5 before anything is measured; without --hdf5 nobody asks for it.
FLATRAY_HDF5_MODULE=absent.so run 5 experiment mean-free-path "$sinai" --hdf5 -o none
says err "absent.so is not there"
says err "libhdf5-dev"
silent out
absent none
FLATRAY_HDF5_MODULE=absent.so run 0 experiment mean-free-path "$sinai" --count 2000 -o plain
absent plain/mean_free_path.h5
readelf -d "$flatray" | grep NEEDED | grep -qE 'hdf5' && fail "flatray links HDF5"
[[ -e $module ]] || finish
run 0 --version
says out "HDF5 files"
[[ ! -e ${module/hdf5/embree} ]] || says out "tracer embree"

# numbers_of NPY: what stands behind its head, whose length is in bytes 8 and 9.
numbers_of() { tail -c "+$((11 + $(od -An -j8 -N2 -tu2 "$1")))" "$1"; }

run 0 experiment poincare "$sinai" --count 2000 --hdf5 -o one
sleep 1.1  # times of objects, if there were any, are whole seconds
run 0 experiment poincare "$sinai" --count 2000 --hdf5 -o two -j 2
exists one/poincare.h5 one/poincare_points.npy
cmp one/poincare.h5 two/poincare.h5 || fail "the same numbers are other bytes"
# A sweep has a table alone.
run 0 experiment mean-free-path "$sinai" --count 2000 --hdf5 -o swept --sweep chamber.0.pillars.0.shape.circle.radius=0.2,0.3
says err "no .h5 is written"
exists swept/sweep.csv
absent swept/mean_free_path.h5
command -v h5dump > /dev/null || finish
for name in poincare_points poincare_density; do
  h5dump -d "/$name" -b FILE -o "$name.bin" one/poincare.h5 > "$name.txt"
  cmp "$name.bin" <(numbers_of "one/$name.npy") || fail "$name: the numbers are not those of the .npy file"
done
grep -q 'H5T_IEEE_F64LE "sine"' poincare_points.txt || fail "columns have no names"
grep -q 'SIMPLE { ( 410, 820 )' poincare_density.txt || fail "the density has another shape"
h5dump -A one/poincare.h5 > all.txt
grep -q 'angle to the normal' all.txt || fail "no caption"
grep -q "sinai.toml" all.txt || fail "what was asked is not in it"
h5dump -w 0 -d /measures one/poincare.h5 | grep -q mean_square_sine || fail "no measures"
finish
