# SPDX-License-Identifier: BSD-3-Clause
# A packager's build type and flags, and any compiler, hold for all files, the processor's kernels among them; another
# compiler makes these by an explicit choice alone.  Configures, and looks at the commands; builds nothing.
. "${TOP:?}/tests/lib.sh"
needs cmake ninja
[ -f "${BIN%/bin}/CMakeCache.txt" ] || skip 'no build here'
unset CXXFLAGS CXX LDFLAGS

# configure NAME ARGUMENT ...: the commands that compile kernels go to the file NAME, a line a file.
configure() {
    name=$1
    shift
    cmake -S "$TOP" -B "$name.build" -G Ninja --log-level=WARNING -DLUXPIPE_ISPC= "$@" > "$name.log" 2>&1 ||
        { cat "$name.log"; return 1; }
    command ninja -C "$name.build" -t commands ptrace > "$name.all"
    grep -E -e ' -c [^ ]*/cpu_kernels_[a-z0-9]*\.cpp' "$name.all" > "$name"
    [ "$(wc -l < "$name")" -eq 3 ]
}
all() { [ "$(grep -c -e "$2" "$1")" -eq 3 ]; }
none() { [ "$(grep -c -e "$2" "$1")" -eq 0 ]; }

grep -q '^LUXPIPE_PTRACE:BOOL=ON' "${BIN%/bin}/CMakeCache.txt" || skip 'a build without ptrace'
check 'CXXFLAGS and the build type are those of the kernels, too' '
    CXXFLAGS="-O2 -fstack-protector-strong" configure debug -DCMAKE_BUILD_TYPE=Debug
    all debug "-fstack-protector-strong .*-g "
    all debug "-ffp-contract=off"
    all debug "-fno-trapping-math"
    none debug -DNDEBUG'
check 'the compiler is that of the rest' '
    configure plain
    compiler=$(sed -n "s/^CMAKE_CXX_COMPILER:[A-Z]*=//p" plain.build/CMakeCache.txt)
    all plain "$compiler .* -O3 -DNDEBUG "'
installed() {
    find plain.build -name cmake_install.cmake -exec \
        sed -nE 's,.* TYPE (EXECUTABLE|PROGRAM) FILES ".*/([a-z-]+)".*,\2,p' {} + | sort -u
}
check 'the description of the package names each program that is installed, and counts them' '
    installed > programs; grep -qx luxpipe-live programs
    sed -n "/CPACK_DEBIAN_PACKAGE_DESCRIPTION/,/\")/p" plain.build/CPackConfig.cmake > description
    while read -r program; do grep -qw "$program" description; done < programs
    numbers=(no one two three four five six seven eight nine ten)
    grep -qi "${numbers[$(wc -l < programs)]} programs" description'
if command -v clang++ > /dev/null; then
    check 'another compiler makes them by choice, with the same flags' '
        CXXFLAGS=-fstack-protector-strong configure chosen -DLUXPIPE_KERNEL_CXX=clang++
        all chosen "clang++ .*-fstack-protector-strong.*-O3 -DNDEBUG"
        grep -v cpu_kernels chosen.all > rest
        none rest clang++'
    check 'clang makes all' 'configure clang -DCMAKE_CXX_COMPILER=clang++ && none clang.all "[/ ][cg]++ .* -c "'
fi
