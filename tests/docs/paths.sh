# SPDX-License-Identifier: BSD-3-Clause
# Nothing in the tree knows the machine it was written on.
. "${TOP:?}/tests/lib.sh"
machine='/(work|farm|root|home/[a-z]+)/|[.]library|[.][.]/shared/'

files() {
    git -C "$TOP" ls-files 2> /dev/null ||
        (cd "$TOP" &&
            find . \( -path './build*' -o -path ./out -o -path ./.git -o -path ./.ispc \) -prune -o -type f -print)
}
check 'no file names a path of one machine' '
    ! (cd "$TOP" && files | grep -vE "[.](hdr|exr|png)$" | tr "\n" "\0" | xargs -0 grep -nIE "$machine" /dev/null)'
check 'every source file says its licence' '
    ! (cd "$TOP" && files | grep -E "[.](cpp|h|cl|sh|cmake)$|CMakeLists.txt$|Makefile$" | tr "\n" "\0" |
        xargs -0 grep -L "SPDX-License-Identifier: BSD-3-Clause" | grep -v "^lib/spectrum/cie_" | grep .)'
check 'tables of the CIE say theirs' '
    ! grep -L "SPDX-License-Identifier: CC-BY-SA-4.0" "$TOP"/lib/spectrum/cie_* | grep .'

named() {  # files in comments and pages; CHANGELOG tells of files that were
    (cd "$TOP" && files > "$TMP/list"
     grep -E '[.](h|cpp|cl|inl|sh|py|md|awk|cmake|[157])$|(CMakeLists.txt|Makefile)$' "$TMP/list" |
         grep -vE '^([.]/)?(tests/golden/|CHANGELOG)' | xargs awk -f tests/docs/names.awk "$TMP/list")
}
check 'every file that a comment or page names is there' 'named > ghosts; cat ghosts >&2; test ! -s ghosts'

echo '// as in lib/gone.cpp, ghost.h and mat_NAME.h' > page.cpp
check 'a name without a file is seen' '
    echo lib/base/error.h | awk -f "$TOP/tests/docs/names.awk" - page.cpp | sed "s/.*: //" | sort | tr "\n" " " > seen
    grep -qx "ghost.h lib/gone.cpp " seen'
