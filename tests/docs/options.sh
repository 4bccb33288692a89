# SPDX-License-Identifier: BSD-3-Clause
# Each option is declared once (base/options.h); -help prints it, and the manual says it again in the same words before
# it goes on.  Here the two are compared: spellings, arguments, sentences, units and defaults.
. "${TOP:?}/tests/lib.sh"
needs mandoc ptaccum vcmetrics vcregion

# "-x n <tab> Horizontal resolution (512)." for each option of the help; broken lines are put together.
help_items() {  # TOOL [PROGRAM]
    "$1" -help "${2-all}" | awk '
        /^  -/ { if (head) print head "\t" text; text = ""; sub(/^  /, "")
                 if (match($0, /   */)) { head = substr($0, 1, RSTART - 1); text = substr($0, RSTART + RLENGTH) }
                 else head = $0; next }
        /^   / && head { sub(/^ */, ""); text = text (text ? " " : "") $0; next }
        { if (head) print head "\t" text; head = "" }'
}

# The words of the page's OPTIONS section, one blank between two.
page_words() {
    mandoc -T ascii -O width=1000 "$TOP/man/$1.1" | sed 's/.\x08//g' |
    awk '/^[A-Z]/ { on = ($1 == "OPTIONS") } on' | tr -s ' \n' ' '
}

# Words that begin an item of the OPTIONS section: "-a x, -b y" is -a and -b.
page_options() {
    mandoc -T ascii "$TOP/man/$1.1" | sed 's/.\x08//g' |
    awk '/^[A-Z]/ { on = ($1 == "OPTIONS") } on' | sed -nE 's/^ {5,8}(-[A-Za-z0-9].*)/\1/p' | cut_names
}
cut_names() {
    sed -E 's/  .*//; s/, ?-/\n-/g' | sed -E 's/[^A-Za-z0-9_-].*//; s/-$//' |
    grep -E '^-[A-Za-z0-9]' | sort -u
}

# Options of the help, one a line, that page $2 does not say word by word.
not_said() {
    while IFS=$'\t' read -r head text; do
        grep -qF -e " $head $text " "$2" || printf '%s\n%s\n' "$head" "$text"
    done < "$1"
}

for tool in ptrace ptaccum vcmetrics vcregion vcyear vcview luxpipe-live; do
    command -v $tool > /dev/null || continue
    help_items $tool | tee $tool.items.all > $tool.items
    page_words $tool > $tool.words
    cut -f 1 $tool.items | cut_names > $tool.names
    [ $tool != vcmetrics ] || sed -i '/^-metrics/s/: .*/: those of vcmetrics-formulas(7)./' $tool.items
    check "$tool: -help lists options" "test -s $tool.items"
    check "$tool: every option of -help is in the page, and no other" "page_options $tool | diff $tool.names -"
    check "$tool: the page says of each what -help says" "
        not_said $tool.items $tool.words > missing; cat missing >&2; test ! -s missing"
    check "$tool: -help breaks its lines" "$tool -help all | awk 'length > 100' | wc -l | grep -qx 0"
done

check 'vcmetrics-formulas(7) has the columns that -help lists' '
    names=$(help_items vcmetrics | sed -n "s/^-metrics list.*separated: //p"); [ -n "$names" ]
    mandoc -T ascii -O width=1000 "$TOP/man/vcmetrics-formulas.7" | sed "s/.\x08//g" | tr -s " \n" " " |
        grep -qF "${names%.}"'

check "evalglare's options stand under -help evalglare, the others under -help" '
    help_items vcmetrics "" > own; help_items vcmetrics evalglare > others
    grep -q "^-metrics" own; grep -q "^-T x y angle" others; vcmetrics -help | not grep "not here"
    [ "$(cat own others | sort)" = "$(sort vcmetrics.items.all)" ]; [ "$(wc -l < others)" -gt 35 ]'

printf -- '-x n\tSize (3).\n' > one.items
echo ' OPTIONS -x n Size (4). More words. ' > one.words
check 'another default in the page is seen' 'not_said one.items one.words | grep -q Size'

if command -v ptrace > /dev/null; then
    ignored() { tr -s ' \n' ' ' | grep -o "$1[^)]*" | grep -oE -e '-[A-Za-z]+' | sort; }
    check 'ptrace(1) names the options that are read past' '
        ptrace -help rpict | ignored "Accepted and not needed:" > ours
        mandoc -T ascii "$TOP/man/ptrace.1" | sed "s/.\x08//g" | ignored "named once in a warning:" | diff ours -'
fi
