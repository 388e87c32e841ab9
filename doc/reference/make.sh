#!/bin/sh
# make.sh DOXYGEN DOXYFILE WARNINGS: make the pages, and fail on what Doxygen has to say. Namespaces, types and free
# functions need words; constants and members whose names say it all need none.
set -eu
"$1" "$2"
! grep -vE 'warning: Member .* (\(variable\) of namespace|of (struct|class)) [^ ]+ is not documented\.$' "$3" >&2
