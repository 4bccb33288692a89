# SPDX-License-Identifier: BSD-3-Clause
# How the code looks: a head that says what a file is for, 120 columns, functions of at most 80 and files of at most 300
# lines, clang-format's layout (.clang-format; version 14).
. "${TOP:?}/tests/lib.sh"

files() {  # patterns: those files, by name
    cd "$TOP" || exit 2
    git ls-files -- "$@" 2> /dev/null ||
        find . \( -path "./build*" -o -path ./.git -o -path ./.ispc \) -prune -o -type f -print
}
cxx() { files '*.cpp' '*.h' '*.inl' '*.cl' | grep -E '[.](cpp|h|inl|cl)$' | sed "s|^|$TOP/|"; }
scripts() {
    files '*.sh' '*.py' '*.awk' '*.cmake' '*CMakeLists.txt' Makefile .ci/run |
        grep -E '[.](sh|py|awk|cmake)$|CMakeLists.txt$|Makefile$|[.]ci/run$' | sed "s|^|$TOP/|"
}
# Tests may be longer: their tables and cases are read from top to bottom.
outside_tests() { grep -v "^$TOP/\(./\)\?tests/"; }
export TOP && export -f files cxx scripts outside_tests

check 'no line is longer than 120 columns' '
    ! { cxx; scripts; } | xargs awk "length > 120 { print FILENAME \":\" FNR \": \" length \" columns\" }" | grep . >&2'
check 'every file begins with its licence and says what it is for' '
    ! cxx | xargs awk "FNR == 1 && !/SPDX/ || FNR == 2 && !/^\/\/ / { print FILENAME \": has no head\" }" | grep . >&2'
check 'no file is longer than 300 lines' '
    ! { cxx; scripts; } | outside_tests | xargs awk "FNR == 301 { print FILENAME }" | grep . >&2'

long_functions() { awk -v most=80 -f "$TOP/tests/docs/long_functions.awk" "$@"; }
export -f long_functions
check 'no function is longer than 80 lines' '! long_functions $(cxx | outside_tests) | grep . >&2'

check 'values, not protocols: nothing is changed behind a const' '
    ! grep -nE "\<mutable\>|const_cast|void ?[*]" "$TOP"/lib/glare/* "$TOP"/tools/vcmetrics/* >&2'
# A method that is not const has an order; a constructor has none.
changing_methods() {
    awk '/^(class|struct) [A-Za-z]/ { name = $2 "("; open = $1 == "struct" } /^};|^(private|protected):/ { open = 0 }
         /^public:/ { open = 1 }
         open && /^    [A-Za-z].*\)( override)?(;| [{].*)$/ && !index($0, name) && !/^[^({]*=/ {
             print FILENAME ":" FNR ": " $0 }' "$@"
}
export -f changing_methods
printf 'class A {\npublic:\n    A(int x);\n    int of() const { return 1; }\n    void add(int x);\n};\n' > order.h
printf 'struct B {\n    int x = f(1);\n    void grow() { x = 2; }\nprivate:\n    void own();\n};\n' >> order.h
check 'values, not protocols: what measures has no methods with an order' '
    [ "$(changing_methods order.h | cut -d : -f 2 | tr "\n" " ")" = "5 9 " ]
    ! grep -n "^class" "$TOP"/tools/vcmetrics/* >&2'
# Nor has what renders, wires or shows, but for so many methods of these headers: a cache, a stream of commands, the
# thread that reads them, a batch of rays, sums and reports that grow.  Their numbers may only fall.
cat > with_order << 'END'
lib/glare/filled.h 1
lib/live 20
lib/render/command_reader.h 1
lib/render/control.h 6
lib/render/image_tracer.h 6
lib/render/pixel_text.h 1
tools/ptaccum/sums.h 2
tools/ptrace/report.h 2
END
with_order() {  # those that have more such methods than they may
    (cd "$TOP" && changing_methods lib/glare/*.h lib/render/*.h lib/live/*.h tools/*/*.h) |
        awk -F : 'NR == FNR { split($0, word, " "); may[word[1]] = word[2]; next }
            { at = $1 ~ /^lib.live/ ? "lib/live" : $1; if (++has[at] > may[at] + 0) print }' with_order -
}
export -f with_order
check 'values, not protocols: no new method with an order' '! with_order | grep . >&2'
# The page; its numbers, too, may only fall.
page() { files 'lib/live/page/*' | grep 'lib/live/page/' | sed "s|^|$TOP/|"; }
export -f page
check 'the page: no more lines of over 120 columns than 75, and no file but regions.js of over 300 lines' '
    [ "$(page | xargs awk "length > 120" | wc -l)" -le 75 ]
    ! page | grep -v /regions.js$ | xargs awk "FNR == 301 { print FILENAME }" | grep . >&2'

# set -e takes no notice of "!" unless it comes last (not, in tests/lib.sh).
unheard() { grep -nE "^ +([^#']*; ((do|then|else) )?)?! ([^'{|]*; [^}]|[^'{]*[^'\"|\\]\$)" "$@" | grep -v "||"; }
export -f unheard
printf "check x '\n    ! grep a b\n    a; ! test -e b; c\n    for a in b; do ! c a; done; d\n    ! grep c d'\n" > heard
check 'what must not hold fails a check in its middle, too' '
    [ "$(unheard heard | cut -d : -f 1 | tr "\n" " ")" = "2 3 4 " ]
    ! files "tests/*.sh" | grep "tests/.*[.]sh$" | sed "s|^|$TOP/|" | xargs bash -c "unheard \"\$@\"" - >&2'

unity() { cxx | grep -E '/(lib|tools)/.*[.]cpp$'; }
export -f unity
mkdir a b
printf 'namespace {\nint f(int x) {\n}\nconstexpr int few = 1, many = 2;\n}  // namespace\nint g = 3;\n' > a/one.cpp
printf 'namespace {\nstruct f {\n};\n}  // namespace\nint g = 3;\nstatic std::set<int> many{1};\n' > a/two.cpp
cp a/two.cpp b
check 'no two files of a library have a name of their own in common: make compiles eight of them as one' '
    unnamed() { awk -f "$TOP/tests/docs/unnamed.awk" "$@"; }
    unnamed a/one.cpp a/two.cpp b/two.cpp | cut -d : -f 1-3 > seen
    printf "a/two.cpp:2: f\na/two.cpp:6: many\n" | diff - seen
    for made in -v -e; do  # files of Windows are not compiled with the others
        unnamed $(unity | grep $made _windows.cpp)
    done > clashes; ! grep . clashes >&2'

lines() { for ((i = 0; i < $1; i++)); do echo "        x += $i;"; done; }
{ echo 'int f(int x,'; echo '      int y) {'; lines 77; echo '}'; } > 80.cpp
{ echo 'int f(int x,'; echo '      int y) {'; lines 78; echo '}'; } > 81.cpp
{ echo 'class A {'; echo '    int f() const {  // a member'; lines 79; echo '    }'; echo '};'; } > member.cpp
check 'a function of 81 lines is seen, in a class too' '
    long_functions 80.cpp 81.cpp member.cpp | cut -d : -f 1,2 > seen
    printf "81 81.cpp:1\n81 member.cpp:2\n" | diff - seen'

check 'every shell script can be parsed' 'for script in $(scripts | grep "[.]sh$"); do bash -n "$script"; done'
if command -v clang-format > /dev/null; then
    check 'clang-format would change nothing' 'cxx | grep -E "[.](cpp|h)$" | xargs clang-format --dry-run --Werror'
fi
