#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# release.sh OUT: what is published of the last commit, in OUT: the sources, packages and wheels of both processors, the
# zip for Windows, the notes of CHANGELOG.md, a page that says how each was tried, and SHA256SUMS.
# The same commit gives the same bytes.  TRY=yes: the goals that try each file are run, too (an hour and more, as root),
# and the page says so.
set -euo pipefail
mkdir -p "$1" && out=$(cd "$1" && pwd) && cd "$(dirname "$0")/.."
tried=${TRY:-no}
changed=$(git status --porcelain --untracked-files=no)
[ -z "$changed" ] || { echo "release: files differ from the last commit:" "$changed" >&2; exit 1; }
version=$(sed -nE 's/^project\(luxpipe VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
name=luxpipe-$version
[ "$(git describe --tags --exact-match --match "v$version" 2> /dev/null)" = "v$version" ] ||
    name=$name+$(git rev-list --count HEAD).g$(git rev-parse --short=9 HEAD)
rm -rf "${out:?}"/* && : > "$out/tried.md"

say() { echo "$*" >> "$out/tried.md"; }
say "# How the files of $name were tried"
say
say 'Each line names a goal of `make` that repeats it.  `docs/platforms.md` has more on each system.'
say
say '| file | bytes | for | tried by |'
say '| --- | --- | --- | --- |'
# part GOAL FILE SYSTEM TEST WORDS: makes the file by the goal, which may have words of make behind it, and tries it.
part() {
    local file how="\`make $4\`: $5"
    # shellcheck disable=SC2086  # a goal and its words
    if ! make -n --no-print-directory $1 > /dev/null 2>&1; then
        say "| none | | $3 | this version has no \`make $1\` |"
        return
    fi
    # shellcheck disable=SC2086
    make --no-print-directory $1 >&2
    file=$(ls $2)
    if [ "$tried" = yes ]; then
        cp "$file" "$out"
        # shellcheck disable=SC2086
        make --no-print-directory $4 >&2
        cmp "$file" "$out/$(basename "$file")" || { echo "release: built again, $file differs" >&2; exit 1; }
        how="$how.  Run before this page was written: passed"
    fi
    cp "$file" "$out"
    say "| $(basename "$file") | $(stat -c %s "$file") | $3 | $how |"
}

git archive --prefix="$name/" HEAD | gzip -9n > "$out/$name.tar.gz"
say "| $name.tar.gz | $(stat -c %s "$out/$name.tar.gz") | sources | \`make test\` of that commit |"
# first, as it fetches ispc where there is none: so the packages for x86-64 have lanes, too
part wheel 'out/wheel/luxpipe-*.whl' 'Python 3.9 or later, Linux, x86-64' test-wheel \
    'empty Debians 11 to 13, no compiler, no OpenCL: frames by bits, pipe, page, `import luxpipe`'
part 'wheel ARCH=aarch64' 'out/wheel/aarch64/luxpipe-*.whl' 'Python 3.9 or later, Linux, ARM' \
    'test-wheel ARCH=aarch64' 'empty Debians for ARM under an emulator; the programs by `make test-arm64`; no machine'
part deb 'out/deb/luxpipe_*.deb' 'Debian 12, x86-64' test-deb 'an empty Debian 12: installed, demo run, removed'
part 'deb ARCH=arm64' 'out/deb/arm64/luxpipe_*.deb' 'Debian 12, ARM' 'test-deb ARCH=arm64' \
    'an empty Debian 12 for ARM under an emulator; the programs by `make test-arm64`; no machine'
part zip 'out/zip/luxpipe*.zip' 'Windows: ptrace (without OpenCL), ptaccum, vcmetrics, vcregion, vcyear' \
    test-windows 'under wine; no machine'
say
[ "$tried" != yes ] || make --no-print-directory test-slow >&2
[ "$tried" != yes ] || make --no-print-directory test-arm64 ALL=1 >&2
[ "$tried" = yes ] || say 'None of these goals was run for this page: `make release TRY=yes` does.'

{ echo "# luxpipe $version"; sed -n "/^## $version/,/^## /p" CHANGELOG.md | grep -v '^## '; } > "$out/notes.md"
(cd "$out" && sha256sum -- * > SHA256SUMS.new && mv SHA256SUMS.new SHA256SUMS)
ls -l "$out"
