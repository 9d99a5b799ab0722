#!/bin/sh
# check_lane_objects.sh OBJECT...: fails where code that is compiled for certain processors alone
# leaves behind a function that files for all processors may share: the linker keeps one copy of it.
# Templates of vectors of doubles (Dv2_d, Dv4_d, Dv8_d) are of one width and so of one object.
symbols=$(nm --print-file-name --defined-only "$@") || exit 2
found=$(echo "$symbols" | grep -E ' [WVu] ' | grep -vE 'Dv[248]_d') || exit 0
echo "shared with files for all processors:"
echo "$found"
exit 1
