#!/usr/bin/env bash
# needs: pictures/mp4 pictures/webm pictures/gif shapes/box
# What ffmpeg makes of a sequence, where it is installed: all frames, at their rate, in their colours.
source "$(dirname "$0")/lib.sh"
command -v ffmpeg > /dev/null && command -v ffprobe > /dev/null || {
  echo "skipped: there is no ffmpeg"
  exit 77
}
ffmpeg -v quiet -encoders | grep -q libx264 && ffmpeg -v quiet -encoders | grep -q libvpx-vp9 || {
  echo "skipped: this ffmpeg has no H.264 or VP9"
  exit 77
}
scene box.toml 30
# shows FILE KEY=VALUE...: what ffprobe tells of it, asked once.
shows() {
  local told entry keys=width,height,color_space,color_range,avg_frame_rate,nb_read_frames
  told=$(ffprobe -v error -count_frames -show_entries "stream=$keys" -of default=nw=1 "$1" | tr '\n' ' ')
  for entry in "${@:2}"; do [[ " $told" == *" $entry "* ]] || fail "$1 is not of $entry: $told"; done
}
# near FILE: a pixel within the box, of #c0392b, and one outside, in the first frame.
near() {
  ffmpeg -v error -i "$1" -frames:v 1 -pix_fmt rgb24 -f rawvideo - > raw
  local at pixel i
  for at in $(((30 * $2 + 12) * 3)):192,57,43 $(((5 * $2 + 50) * 3)):255,255,255; do
    read -ra pixel < <(od -An -tu1 -j "${at%:*}" -N 3 raw)
    IFS=, read -ra wanted <<< "${at#*:}"
    for i in 0 1 2; do
      ((pixel[i] - wanted[i] <= 8 && wanted[i] - pixel[i] <= 8)) || fail "$1: a pixel of ${pixel[*]}, not ${wanted[*]}"
    done
  done
}
for format in mp4 webm gif; do
  run 0 render box.toml -o box.$format -j 2 --quiet
  colours=(color_space=bt709 color_range=tv avg_frame_rate=24/1)
  [[ $format != gif ]] || colours=()
  shows box.$format nb_read_frames=30 width=64 height=48 "${colours[@]}"
  near box.$format 64
  [[ -z $(find . -name '.*.part') ]] || fail "a temporary file stayed"
done
# Delays of a GIF are hundredths of a second, of 2 at least: of other rates it is told.
for fps in 50 24 0.01; do
  run 0 render box.toml -f 1..2 -D fps=$fps -o box.gif
  grep -q warning err.txt && fail "a GIF of $fps frames a second is warned of"
done
run 0 render box.toml -f 1..2 -D fps=60 -o box.gif
says err "--output: warning: a GIF keeps from 0.00153 to 50 frames a second, not the 60 of 'box'"
says err "say -D fps=50"
run 0 render box.toml -f 1..2 -D fps=0.001 -o slow.gif
says err "not the 0.001 of 'box'"
# The nearest rate that a format holds is written; a film of one frame has none.
run 0 render box.toml -f 1..20 -D fps=0.000001 -o slow.mp4
says err "an MP4 video keeps from 0.001 to 1e+06 frames a second"
shows slow.mp4 avg_frame_rate=1/1000 nb_read_frames=20
run 0 render box.toml -f 1 -D fps=0.000001 -o one.mp4
grep -q warning err.txt && fail "a film of one frame is warned of its rate"
# The same command again writes the same file, over the one before.
cp box.mp4 before.mp4
run 0 render box.toml -o box.mp4 -j 1 --quiet
cmp -s box.mp4 before.mp4 || fail "the same frames give another file"
# H.264 takes even sizes.
run 0 render box.toml --size 65x49 -f 1..3 -o odd.mp4 --quiet
shows odd.mp4 width=66 height=50
run 0 render box.toml --size 65x49 -f 1..3 -o odd.webm --quiet
shows odd.webm width=65 height=49
# A pipe into it does the same.
"$flatray" render box.toml -o - --format y4m | ffmpeg -v error -y -i - piped.mkv
shows piped.mkv nb_read_frames=30
# In the sandbox it is kept in, too.
mkdir out
"$flatray" render box.toml -f 1 -o out/p.png --sandbox --quiet 2> err.txt && {
  run 0 render box.toml -o out/box.mp4 --sandbox --quiet
  cmp -s out/box.mp4 box.mp4 || fail "another file in the sandbox"
}
finish
