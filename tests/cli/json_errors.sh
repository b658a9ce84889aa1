#!/usr/bin/env bash
# With --json every verb that fails says its mistakes as JSON on standard output, too.
source "$(dirname "$0")/lib.sh"
printf 'flatray = 1\nseed = "\xff"\n' > bytes.toml
printf 'flatray = 1\nfps = 0\nsed = 1\n' > wrong.toml
for verb in render check explain hit orbit; do
  run 4 $verb --json wrong.toml
  says out '"schema":"flatray.'$verb'/1"'
  says out '"file":"wrong.toml","line":2,"column":7,"message":"fps is not above 0"'
  says out '"line":3,"column":1'
  says err 'wrong.toml:2:7: error: fps is not above 0'
  run 4 $verb --json bytes.toml
  says out '"message":"this byte is not UTF-8"'
  run 3 $verb --json none.toml
  says out '"file":"none.toml","message":"cannot read'
done
scene box.toml 2
run 6 render --json box.toml -o 'box.toml/f_####.png'
says out '"errors":[{'
run 4 render wrong.toml
silent out
finish
