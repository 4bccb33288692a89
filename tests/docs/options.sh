# SPDX-License-Identifier: BSD-3-Clause
# Each option is told twice, by -help and by the manual page; here the two lists are compared.
. "${TOP:?}/tests/lib.sh"
needs mandoc ptaccum vcmetrics vcregion

# Options that begin a line of the help, one dash, joined [+-] and arguments cut off.
help_options() {
    "$1" -help | sed -nE 's/^ {1,8}(--?[A-Za-z0-9].*)/\1/p' | cut_names
}
# Options that begin an item in the page's OPTIONS section.
page_options() {
    mandoc -T ascii "$TOP/man/$1.1" | sed 's/.\x08//g' |
    awk '/^[A-Z]/ { on = ($1 == "OPTIONS") } on' | sed -nE 's/^ {5,8}(-[A-Za-z0-9].*)/\1/p' | cut_names
}
# "-a x, -b y  words" -> -a and -b
cut_names() {
    sed -E 's/  .*//; s/\t.*//; s/, ?-/\n-/g' | sed -E 's/^--/-/; s/[^A-Za-z0-9_-].*//; s/-$//' | grep -E "^-[A-Za-z0-9]" | sort -u
}
for tool in ptrace ptaccum vcmetrics vcregion; do
    command -v $tool > /dev/null || continue
    help_options $tool > $tool.help
    page_options $tool > $tool.page
    check "$tool: -help lists options" "test -s $tool.help"
    check "$tool: every option of -help is in the page, and no other" "diff $tool.help $tool.page"
done
