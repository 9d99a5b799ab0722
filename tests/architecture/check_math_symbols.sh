#!/bin/sh
# check_math_symbols.sh PROGRAM...: fails where a finished program takes functions from the C
# library whose bits depend on the processor, be it through a header of another package.
# check_math.sh names the line of a call of ours; `nm --print-file-name --undefined-only` of the
# static libraries names the object of any other.
names='a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erfc?|[tl]gamma|fma'
symbols=$(nm --dynamic --print-file-name --undefined-only "$@") || exit 2
found=$(echo "$symbols" | grep -E " U ($names)[fl]?(@|\$)") || exit 0
echo "bits of the processor:"
echo "$found"
exit 1
