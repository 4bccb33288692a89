# SPDX-License-Identifier: BSD-3-Clause
# Nothing in the tree knows the machine it was written on.
. "${TOP:?}/tests/lib.sh"
machine='/(work|farm|root|home/[a-z]+)/|[.]library|[.][.]/shared/'

files() {
    git -C "$TOP" ls-files 2> /dev/null ||
        (cd "$TOP" && find . -type f -not -path './build*' -not -path './out/*' -not -path './.git/*')
}
check 'no file names a path of one machine' '
    ! (cd "$TOP" && files | grep -vE "[.](hdr|exr|png)$" | tr "\n" "\0" | xargs -0 grep -nIE "$machine" /dev/null)'
check 'every source file says its licence' '
    ! (cd "$TOP" && files | grep -E "[.](cpp|h|cl|sh|cmake)$|CMakeLists.txt$|Makefile$" | tr "\n" "\0" |
        xargs -0 grep -L "SPDX-License-Identifier: BSD-3-Clause" | grep .)'
