#!/bin/sh
# debian_package.sh CPACK CONFIG [PYTHON]: packs the build, installs the packages into an empty root, and uses them from
# there; with PYTHON the module, too.
set -eu
cpack=$1 config=$2 python=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cpack" -G DEB --config "$config" -B "$folder/packed" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
root=$folder/root
mkdir -p "$root"

# unpack PACKAGE DEPENDENCY: what it is, what it needs, and its files.
unpack() {
  package=$(ls "$folder"/packed/"$1"_*.deb)
  for field in Depends Recommends Description; do
    dpkg-deb -f "$package" $field | grep -q . || { echo "$1: no $field"; exit 1; }
  done
  dpkg-deb -f "$package" Depends | grep -q "$2" || { echo "$1 does not depend on $2"; exit 1; }
  dpkg-deb -x "$package" "$root"
}

unpack mariotte libsundials
[ ! -e "$root/usr/lib/python3" ] || { echo "mariotte holds the Python module"; exit 1; }
cd "$folder"
clean() { env -i PATH="$root/usr/bin:/usr/bin:/bin" HOME="$folder" mariotte "$@"; }
clean demo | grep -q 'Five steel balls'
clean init triplet && clean run triplet.toml --json | grep -q '"ending": "separated"'
clean run root/usr/share/mariotte/scenes/y_chain.toml -q >/dev/null
clean reproduce acary-1c --out figures >/dev/null
gzip -dc "$root"/usr/share/man/man1/mariotte.1* 2>/dev/null | grep -q MARIOTTE || grep -q MARIOTTE "$root/usr/share/man/man1/mariotte.1"

[ -n "$python" ] || exit 0
unpack python3-mariotte python3-numpy
env -i HOME="$folder" PYTHONPATH="$root/usr/lib/python3/dist-packages" "$python" -c '
import mariotte as mt
hit = mt.simulate(mt.load("triplet.toml"))
assert mt.__file__.startswith("'"$root"'"), mt.__file__
print(hit.ending.name, hit.velocity)' | grep -q '^separated'
