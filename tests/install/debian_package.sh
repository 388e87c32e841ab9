#!/bin/sh
# debian_package.sh CPACK CONFIG: packs the build, unpacks it into an empty root, and uses it from there.
set -eu
cpack=$1 config=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cpack" -G DEB --config "$config" -B "$folder/packed" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
package=$(ls "$folder"/packed/mariotte_*.deb)
for field in Depends Recommends Description; do dpkg-deb -f "$package" $field | grep -q . || { echo "no $field"; exit 1; }; done
dpkg-deb -f "$package" Depends | grep -q libsundials || { echo "does not depend on SUNDIALS"; exit 1; }
mkdir "$folder/root"
dpkg-deb -x "$package" "$folder/root"
cd "$folder"
clean() { env -i PATH="$folder/root/usr/bin:/usr/bin:/bin" HOME="$folder" mariotte "$@"; }
clean demo | grep -q 'Five steel balls'
clean init triplet && clean run triplet.toml --json | grep -q '"ending": "separated"'
clean run root/usr/share/mariotte/scenes/y_chain.toml -q >/dev/null
clean reproduce acary-1c --out figures >/dev/null
gzip -dc "$folder"/root/usr/share/man/man1/mariotte.1* 2>/dev/null | grep -q MARIOTTE || grep -q MARIOTTE "$folder/root/usr/share/man/man1/mariotte.1"
