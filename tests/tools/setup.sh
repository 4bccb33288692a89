# SPDX-License-Identifier: BSD-3-Clause
# make and packages: what is missing is named before it is installed, no more than the goal needs, nothing with
# SETUP=no.
# dpkg-query and apt-get are played by scripts here.
. "${TOP:?}/tests/lib.sh"
needs make
mkdir bin && PATH=$TMP/bin:$PATH
touch there
printf '#!/bin/sh\ngrep -qx "$4" "%s/there" || exit 1\nprintf "install ok installed"\n' "$TMP" > bin/dpkg-query
printf '#!/bin/sh\necho "apt-get $*" >> "%s/asked"; cat "%s/said" >> "%s/asked" 2> /dev/null\n' "$TMP" "$TMP" "$TMP" \
        > bin/apt-get
printf '#!/bin/sh\n[ "$1" = -u ] && echo 0\n' > bin/id
chmod +x bin/*
setup() { rm -f asked; sh "$TOP/scripts/setup.sh" "$@" 2> said; }
parts() { make -s -n -C "$TOP" "$@" | sed -nE 's/.*scripts[/]setup.sh (.*)/\1/p' | tr -s ' '; }

check 'what is missing is named before apt-get runs' '
    setup tools; grep -q "missing and will be installed.* libfmt-dev" said
    grep -n . asked | grep -q "^2:setup: .*libfmt-dev"; grep -q "apt-get install .*libfmt-dev" asked'
check 'the way out is named, too'           'grep -q SETUP=no said'
check 'the three tools need neither Embree nor OpenCL' '! grep -qiE "embree|opencl|doctest|gnuplot|mandoc" asked'
check 'ptrace needs both, and no PoCL' '
    setup tools ptrace; grep -q embree asked; grep -q opencl-headers asked; ! grep -q pocl asked'
check 'nothing runs when all are there'     '
    sed -nE "s/.*apt-get install -q -y --no-install-recommends //p" asked | tr " " "\n" > there
    setup tools ptrace; test ! -e asked; test ! -s said'
check_exit 'an unknown part is reported' 1  'setup everything'
check 'make all and make install leave tests and plots alone' '
    for goal in all install; do test "$(parts $goal)" = "tools ptrace"; done'
check 'make test adds what the tests need'  'parts test | grep -qx "tools ptrace tests"'
check 'so do the goals that build tests' 'for goal in test-gpu test-sanitize compare-radiance; do
    parts $goal | grep -qx "tools ptrace tests"; done'
check 'make fuzz, make deb and make wheel need more' '
    parts wheel | grep -qx "tools ptrace wheel"; setup wheel; grep -q " python3-venv" asked; not grep -q numpy asked
    parts fuzz | grep -qx "tools ptrace tests fuzz"; parts deb | grep -qx "tools ptrace deb"
    parts deb ARCH=arm64 | grep -qx "tools ptrace deb arm64"; parts test-arm64 | grep -qx "tools ptrace tests arm64"'
if [ "$(uname -m)" = x86_64 ] && ! command -v ispc > /dev/null; then
    check 'where no ispc can be had the build goes on without it, and says so' '
        sh "$TOP/scripts/ispc.sh" none 2> said; grep -q "built without lanes" said; test ! -e none/ispc'
fi
check 'a machine without make gets it from .ci/run' '
    parts=$(sed -n "s/.*setup.sh//p" "$TOP/.ci/run"); : > there; setup $parts; grep -q " make " asked'
check 'make demo adds the plot'             'parts demo | grep -qx "tools ptrace demo"'
demo() { make -s -n -C "$TOP" demo BUILD="$TMP/new build"; }
check 'and builds its own programs, without lanes as long as they are not built' '
    demo > planned; grep -q "target ptrace ptaccum vcmetrics vcregion$" planned
    grep -q -e "-DLUXPIPE_LANES=\"" planned; not grep -q ispc.sh planned
    mkdir -p "new build/lib/device"; touch "new build/lib/device/"lanes8.o "new build/lib/device/"lanes16.o
    demo | grep -qE -e "-DLUXPIPE_LANES=(8|16)\""'
check 'without ptrace its libraries are not asked for' 'parts all FLAGS=-DLUXPIPE_PTRACE=OFF | grep -qE "^tools ?$"'
check 'SETUP=no installs nothing'           'rm -f asked; : > there; make -s -C "$TOP" setup SETUP=no; test ! -e asked'
check 'and without it, it does'             'make -s -C "$TOP" setup; test -e asked'

# Words of the commands that make runs, one a line; cmake is played, too.
printf '#!/bin/sh\nprintf "%%s\\n" "$@" >> "%s/words"\n' "$TMP" > bin/cmake
chmod +x bin/cmake
check 'folders may have blanks in their names' '
    rm -f words; make -s -C "$TOP" install SETUP=no BUILD="$TMP/a build" PREFIX="$TMP/my programs"
    grep -qx -e "$TMP/a build" words; grep -qx -e "-DCMAKE_INSTALL_PREFIX=$TMP/my programs" words
    grep -qx "$TMP/my programs" words; ! grep -E "^(build|programs)" words'
rm bin/cmake
configure() { cmake -S "$TOP" -B b --log-level=ERROR -G Ninja -DLUXPIPE_PTRACE=OFF "$@" > configured; }
check 'without ptrace its page is not installed' '
    configure; mkdir -p b/bin; for tool in ptaccum vcmetrics vcregion vcyear vcview; do cp /bin/true b/bin/$tool; done
    cmake --install b --prefix x; test -e x/share/man/man1/vcregion.1
    test -e x/share/man/man5/luxpipe-stream.5; ! find x | grep "ptrace"'
check 'a packager may say a later C++' '
    configure -DCMAKE_CXX_STANDARD=20; grep -q "std=c++20" b/build.ninja; not grep -q "std=c++17" b/build.ninja
    rm -r b; configure; grep -q "std=c++17" b/build.ninja'
