# SPDX-License-Identifier: BSD-3-Clause
# Manual pages: clean for mandoc's linter, sections in RADIANCE's order, one page for every tool.
. "${TOP:?}/tests/lib.sh"
needs mandoc

for tool in "$TOP"/tools/*/; do
    check "$(basename "$tool") has a manual page" "test -s '$TOP/man/$(basename "$tool").1'"
done
for page in "$TOP"/man/*.[157]; do
    name=$(basename "$page")
    check "$name: the linter finds nothing" "! mandoc -T lint -W warning '$page' | grep -v 'cross reference' | grep ."
    check "$name: says what it is and what to read next" "
        grep -qE '^[.]S[Hh] \"?NAME' '$page' && grep -qE '^[.]S[Hh] \"?SEE ALSO' '$page'"
done
order='NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLES ENVIRONMENT DIAGNOSTICS NOTES SEE_ALSO'
for page in "$TOP"/man/*.1; do
    check "$(basename "$page"): sections in RADIANCE's order" '
        test "$(sed -nE "s/^[.]S[Hh] +\"?([A-Z ]*[A-Z])\"?.*/\1/p" "$page" | tr " " _ |
            grep -xE "$(echo $order | tr " " "|")" | tr "\n" " ")" = "$order "'
done
