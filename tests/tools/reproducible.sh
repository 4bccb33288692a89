# SPDX-License-Identifier: BSD-3-Clause
# The same sources give the same package, byte for byte, wherever they lie: built twice, in folders of different names.
. "${TOP:?}/tests/lib.sh"
needs cmake ninja cpack dpkg-deb
sources() {
    git -C "$TOP" ls-files 2> /dev/null || (cd "$TOP" && find . -type f -not -path './build*' -not -path './out/*')
}
for place in one another/place; do
    mkdir -p "$place/source"
    (cd "$TOP" && sources | tar -cf - -T -) | tar -xf - -C "$place/source"
done
export FLAGS=-DLUXPIPE_PTRACE=OFF SOURCE_DATE_EPOCH=1700000000 CCACHE_DISABLE=1

check 'a package is built in one folder' 'bash one/source/scripts/deb.sh one/out'
check 'and in another, later' 'sleep 2; bash another/place/source/scripts/deb.sh another/place/out'
check 'both are the same bytes' 'cmp one/out/luxpipe_*.deb another/place/out/luxpipe_*.deb'
check 'no path of this folder is in the programs' "
    dpkg-deb -x one/out/luxpipe_*.deb installed; ! grep -rqF '$TMP' installed"
check 'a source tree without git has the version of the project' "
    version=\$(sed -n 's/^project(luxpipe VERSION \\([0-9.]*\\).*/\\1/p' one/source/CMakeLists.txt)
    installed/usr/bin/ptaccum -version | grep -qF \"\$version\"
    test \"\$(dpkg-deb -f one/out/luxpipe_*.deb Version)\" = \"\$version\""
check 'the manual pages and the licence are in it' '
    test -f installed/usr/share/man/man1/ptaccum.1.gz -a -f installed/usr/share/doc/luxpipe/copyright'
check 'the tools are configured without tests, studies and benchmarks, which a source distribution lacks' '
    rm -r one/source/tests one/source/studies one/source/bench
    cmake -S one/source -B one/sdist -G Ninja -DSKBUILD=2 -DLUXPIPE_PTRACE=OFF > /dev/null'
