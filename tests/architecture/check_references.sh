#!/bin/sh
# check_references.sh REFERENCES FOLDER...: fails where a page, source or case cites what REFERENCES
# does not list: tags of two capitals in brackets, or `Author (year)` in any of its usual forms.
references=$1
shift
found=$(mktemp) && trap 'rm -f "$found"' EXIT
find "$@" -type f \( -name '*.md' -o -name '*.hpp' -o -name '*.cpp' -o -name '*.py' -o -name '*.ini' \
    -o -name '*.profile' -o -name '*.convex' \) -exec awk -v references="$references" '
BEGIN {
    while ((getline line < references) > 0) {
        if (line ~ /^- /) { entry++ }
        text[entry] = text[entry] " " line
    }
    author = "[A-Z][a-z]+(-[A-Z][a-z]+)?"
    citation = author "(,? (and|&) " author "|, " author ",? (and )?" author "| et al\\.)?,? [[(]?(19|20)[0-9][0-9][])]?"
    no_author = "^(Pa,|January|February|March|April|May|June|July|August|September|October|November|December) "
}
function is_listed(name, year,    k) {
    for (k = 1; k <= entry; k++)
        if (index(text[k], name) && index(text[k], year)) return 1
    return 0
}
function missing(what) { print FILENAME ":" FNR ": " what " is not in " references }
{
    rest = $0
    while (match(rest, /\[[A-Z][A-Z]\]/)) {
        tag = substr(rest, RSTART, RLENGTH)
        known = 0
        for (k = 1; k <= entry; k++) if (index(text[k], "- " tag " ")) known = 1
        if (!known && tag != "[MB]") missing(tag)
        rest = substr(rest, RSTART + RLENGTH)
    }
    rest = $0
    while (match(rest, citation)) {
        cited = substr(rest, RSTART, RLENGTH)
        name = cited
        sub(/[^A-Za-z-].*/, "", name)
        year = cited
        gsub(/[^0-9]/, "", year)
        if (cited !~ no_author && !is_listed(name, year)) missing(cited)
        rest = substr(rest, RSTART + RLENGTH)
    }
}' {} + >"$found"
cat "$found"
! [ -s "$found" ]
