#!/usr/bin/env bash
# needs: shapes/circle
# `flatray accuracy --profile` and `flatray render --profile`: what is chosen, and refused with its place.
source "$(dirname "$0")/lib.sh"
scene box.toml 1 '[[entity]]' 'shape = { circle = { centre = [3.3, 2.1], radius = 1.7 } }'
run 0 accuracy box.toml -o out --choice coverage --budget 5s --profile box.profile
grep -q '"setting":"exact area"' box.profile || fail "no exact area in the profile"
run 0 render box.toml -o area.png
run 0 render box.toml -o chosen.png --profile box.profile --time 1000
says err "profile: exact area, error "
cmp -s area.png chosen.png || fail "the exact area is chosen, and another picture drawn"
error=$(sed -n 's/.*"pixel centres","error":\([^,]*\),.*/\1/p' box.profile)
run 0 render box.toml -o centre.png -D 'film.coverage="centre"'
grep -e schema -e centres box.profile > centres.profile
run 0 render box.toml -o chosen.png --profile centres.profile --error "$error"
says err "profile: pixel centres, error "
cmp -s centre.png chosen.png || fail "pixel centres are chosen, and another picture drawn"
# Of light it knows nothing, and says so.
scene lamp.toml 1 '[light]' 'rays = 1' '[[lamp]]' 'source = { point = {} }' 'at = [1, 1]'
run 0 accuracy lamp.toml -o lit --choice coverage --budget 0.2s --profile lamp.profile
run 0 render lamp.toml -o lit.png --profile lamp.profile --time 1000
says err "s a frame, both without light"
# Several values of one option are a list; older profiles have the option's name again.
run 0 render box.toml -o rows.png -D 'film.coverage="rows"' -D film.rows=16
{ head -1 box.profile; grep '"16 rays a row"' box.profile; } > rows.profile
grep -q '"options":{"define":\["film.coverage=\\"rows\\"","film.rows=16"\]}' rows.profile || fail "no list of values: $(tail -1 rows.profile)"
sed 's/:\["film.coverage/:"film.coverage/; s/,"film.rows=16"\]/,"define":"film.rows=16"/' rows.profile > old.profile
grep -q '"define":"film.coverage=\\"rows\\"","define":"film.rows=16"}' old.profile || fail "no older profile"
echo '{"choice":"light","setting":"1 ray","error":0,"seconds":0,"options":{"define":"light.rays=1"}}' >> old.profile
for profile in rows old; do
  run 0 render box.toml -o chosen.png --profile $profile.profile --error 1
  says err "profile: 16 rays a row, error "
  cmp -s rows.png chosen.png || fail "$profile: 16 rays a row are chosen, and another picture drawn"
done
run 4 render box.toml -o no.png --profile box.profile --error 1e-12
says err "box.profile:3:1: error: no setting is known to have an error of 1e-12 or less"
says err "say --error "
run 4 render box.toml -o no.png --profile centres.profile --error 1e-12
says err "centres.profile:2:1: error: no setting has an error of 1e-12 or less: this is the nearest"
run 4 render box.toml -o no.png --profile box.profile --time 0
says err "this is the quickest"
run 4 render box.toml -o no.png --profile box.profile --time 1 -D fps=12
says err "box.profile:1:1: error: is of another scene"
run 4 render box.toml -o no.png --profile box.toml --time 1
says err "is not a profile"
printf '%s\n' "$(head -1 box.profile)" '{"setting":7}' > bad.profile
run 4 render box.toml -o no.png --profile bad.profile --time 1
says err "bad.profile:2:1: error: is not a setting of a profile"
for options in '"define":[]' '"samples":[4,16]' '"backend":["gl","software"]'; do
  printf '%s\n' "$(head -1 box.profile)" '{"setting":"s","error":0,"seconds":0,"options":{'"$options"'}}' > bad.profile
  run 4 render box.toml -o no.png --profile bad.profile --time 1
  says err "bad.profile:2:1: error: is not a setting of a profile"
done
# An error of which no more is known than a bound says so; a profile may say that it is none.
for at_most in true false; do
  printf '%s\n' "$(head -1 box.profile)" '{"setting":"s","error":0.5,"seconds":0,"at_most":'$at_most',"options":{}}' > bound.profile
  run 0 render box.toml -o bound.png --profile bound.profile --time 1
  [[ $at_most == true ]] && bound="at most " || bound=""
  says err "profile: s, error ${bound}0.5, 0 s a frame"
done
sed 's/"at_most":false/"at_most":1/' bound.profile > bad.profile
run 4 render box.toml -o no.png --profile bad.profile --time 1
says err "bad.profile:2:1: error: is not a setting of a profile"
run 3 render box.toml -o no.png --profile none.profile --time 1
run 2 render box.toml -o no.png --error 0.1
says err "needs --profile"
run 2 render box.toml -o no.png --profile box.profile
says err "needs --error or --time"
run 2 render box.toml -o no.png --profile box.profile --time 1 --backend gl
says err "does not go with --profile"
absent no.png
finish
