#!/bin/sh
# check_math.sh FOLDER...: fails where a source calls a function of the C library or of Eigen whose
# bits depend on the processor, instead of common/math/elementary.hpp. Exact functions (sqrt, abs,
# floor, fmod, remainder, ...) are free. Words in comments and quotes do not count.
find "$@" \( -name '*.hpp' -o -name '*.cpp' \) -exec awk '
BEGIN {
    names = "a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|" \
            "hypot|erfc?|[tl]gamma|fma"
    library_call = "(^|[^A-Za-z0-9_:])(std::|::|Eigen::numext::)(" names ")[fl]?[ \t]*\\("
    plain_call = "(^|[^A-Za-z0-9_:])(" names ")[fl]?[ \t]*\\("
    other = "AngleAxis|slerp|angularDistance|eulerAngles|computeDirect|std::complex|std::polar|" \
            "_distribution *<"
}
{
    line = $0
    gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
    sub(/\/\/.*/, "", line)
    is_ours = FILENAME ~ /(^|\/)common\/math\//
    if (line ~ library_call || (line ~ plain_call && !is_ours) || line ~ other) {
        print "bits of the processor: " FILENAME ":" FNR ": " $0
        found = 1
    }
}
END { exit found }' {} +
