# SPDX-License-Identifier: BSD-3-Clause
# The programs that Debian 12 builds run on RHEL 9, too: of the C library they use nothing newer than 2.34, of C++'s
# nothing newer than gcc 11 (docs/decisions/0048-other-processors.md).  Other systems' headers ask for other versions.
. "${TOP:?}/tests/lib.sh"
needs objdump getconf
[ "$(getconf GNU_LIBC_VERSION)" = 'glibc 2.36' ] || skip 'not the C library of Debian 12'

newer() {  # PROGRAM VERSION...: its symbols of versions above these (GLIBC_2.34)
    objdump -T "$1" | grep -F '*UND*' | sed -nE 's/.*\(?((GLIBC|GLIBCXX|CXXABI)_[0-9.]+)\)? +(.*)/\1 \3/p' > symbols
    shift
    for most; do
        sed -n "s/^${most%_*}_/&/p" symbols | while read -r version name; do
            [ "$(printf '%s\n' "$version" "$most" | sort -V | tail -n 1)" = "$most" ] || echo "$version $name"
        done
    done
}
for tool in ptrace ptaccum vcmetrics vcregion vcyear vcview; do
    command -v $tool > /dev/null || continue
    check "$tool needs nothing newer" "
        newer '$BIN/$tool' GLIBC_2.34 GLIBCXX_3.4.29 CXXABI_1.3.13 > found
        cat found >&2; [ ! -s found ]; [ -s symbols ]"
done
check 'what is newer is seen' "newer '$BIN/vcmetrics' GLIBC_2.33 | grep -q '^GLIBC_2.34 __libc_start_main'"
