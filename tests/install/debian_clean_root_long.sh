#!/bin/sh
# debian_clean_root_long.sh CPACK CONFIG: packs the build, installs the package by apt into a Debian that holds nothing
# else, and runs it there. Exit code 77 without mmdebstrap, root or the archive of Debian.
set -eu
cpack=$1 config=$2
skip() { echo "skipped: $*"; exit 77; }
command -v mmdebstrap >/dev/null || skip "there is no mmdebstrap"
[ "$(id -u)" = 0 ] || skip "only root may change its root"
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
[ -n "$suite" ] || skip "this Debian has no name"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cpack" -G DEB --config "$config" -B "$folder/packed" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
package=$(ls "$folder"/packed/mariotte_*.deb)
root=$folder/root
mmdebstrap --variant=apt "$suite" "$root" >"$folder/log" 2>&1 || { cat "$folder/log"; skip "no Debian to be had"; }
cp "$package" "$root/tmp/mariotte.deb"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get update --quiet >"$folder/log" 2>&1 || { cat "$folder/log"; skip "no Debian to be had"; }
inside apt-get install --yes --quiet --no-install-recommends /tmp/mariotte.deb >"$folder/log" 2>&1 ||
  { cat "$folder/log"; exit 1; }
inside mariotte demo | grep -q 'Five steel balls'
inside mariotte run /usr/share/mariotte/scenes/y_chain.toml -q >/dev/null
inside apt-get remove --yes --quiet mariotte >/dev/null 2>&1
[ ! -e "$root/usr/bin/mariotte" ] || { echo "what was removed is still there"; exit 1; }
