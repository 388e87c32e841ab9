#!/bin/sh
# pip_install.sh PYTHON SOURCE: what doc/python.md says of pip, in an environment that is empty, without a network where
# that can be had.
set -eu
python=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
alone=
! unshare -rn true 2>/dev/null || alone="unshare -rn"
"$python" -m venv --system-site-packages "$folder/env"
$alone "$folder/env/bin/pip" install --no-index --no-build-isolation "$source"
cd "$folder"
env -u PYTHONPATH "$folder/env/bin/python" -c "
import mariotte as mt
assert mt.__file__.startswith('$folder/env'), mt.__file__
hit = mt.simulate(mt.Chain(balls=3, radius='10 mm', material='steel', law='hertz', velocity=[1, 0, 0]))
assert abs(hit.icr[0] - 1.0768217704) < 1e-8, hit.icr
print('mariotte', mt.__version__, hit.ending.name)"
