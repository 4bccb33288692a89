# SPDX-License-Identifier: BSD-3-Clause
# How the code looks: a head that says what a file is for, 120 columns, clang-format's layout (.clang-format; version 14).
. "${TOP:?}/tests/lib.sh"

files() {  # patterns: those files, by name
    cd "$TOP" || exit 2
    git ls-files -- "$@" 2> /dev/null || find . -path ./build\* -prune -o -type f -print
}
cxx() { files '*.cpp' '*.h' '*.inl' '*.cl' | grep -E '[.](cpp|h|inl|cl)$' | sed "s|^|$TOP/|"; }
export TOP && export -f files cxx

check 'no line is longer than 120 columns' '
    ! cxx | xargs awk "length > 120 { print FILENAME \":\" FNR \": \" length \" columns\" }" | grep . >&2'
check 'every file begins with its licence and says what it is for' '
    ! cxx | xargs awk "FNR == 1 && !/SPDX/ || FNR == 2 && !/^\/\/ / { print FILENAME \": has no head\" }" | grep . >&2'
if command -v clang-format > /dev/null; then
    check 'clang-format would change nothing' 'cxx | grep -E "[.](cpp|h)$" | xargs clang-format --dry-run --Werror'
fi
