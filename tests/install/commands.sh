#!/bin/sh
# commands.sh MARIOTTE SCENES: every command of an installed mariotte once, none of its programs is missing.
set -eu
program=$1 scenes=$2 tried=
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

try() {
  tried="$tried $1"
  "$program" "$@" >output 2>&1 || {
    echo "mariotte $* failed:"
    cat output
    exit 1
  }
}

try version
try help run
try demo
try check "$scenes/triplet.toml"
try run "$scenes/triplet.toml" --out run
try report run
try law "$scenes/triplet.toml"
try sweep "$scenes/triplet_map.toml" --out sweep --no-figures --accuracy 1e-6
try capture "$scenes/microsphere.toml" --tolerance 1e-2
try restitution "$scenes/steel_pair.toml" --from 0.1 --to 1
try modes "$scenes/pressed_row.toml"
try sensitivity "$scenes/triplet.toml"
try uncertainty "$scenes/triplet.toml" --set "chain.velocity[0]=1 +- 1 %" --samples 10
try fit "$scenes/sphere_fit.toml" "$scenes/sphere_fit.csv"
try explain S010
try materials
try man
try reproduce acary-1c
try study icr-table --kappa 2
try study stress --scenes 1
for study in scaling stiffness work-precision; do try study "$study" --help; done
for file in man/man1/mariotte.1 bash-completion/completions/mariotte zsh/vendor-completions/_mariotte \
            fish/vendor_completions.d/mariotte.fish mariotte/scenes/triplet.toml; do
  [ -s "$(dirname "$program")/../share/$file" ] || { echo "not installed: $file" && exit 1; }
done
try init triplet
try completion

commands=$(sed -n "s/^  local words='\([^']*\)'.*/\1/p" output)
[ -n "$commands" ] || { echo "no commands among the completions" && exit 1; }
for command in $commands; do
  case "$tried " in
    *" $command "*) ;;
    *) case $command in -*) ;; *) echo "not tried: $command" && exit 1 ;; esac ;;
  esac
done
