# SPDX-License-Identifier: BSD-3-Clause
# Sentences in shell.  A test script starts with   . "${TOP:?}/tests/lib.sh"   and says what must hold:
#   check      'later -vp overrides the view file'         'command'       status 0 (set -e, pipefail)
#   check_exit 'an undefined modifier is an input error' 1 'command'       that status
#   check_error 'it names the file'  1 '^ptrace: bad.rad:3: ' 'command'    that status, one line on stderr that matches
#   needs ptrace                                                          skips the script where a program is missing
# Scripts run in bash, in an empty folder of their own ($TMP, removed at the end), with the built tools first in PATH.
# ctest gives TOP (the source tree) and BIN (the built tools); by hand: TOP=. BIN=build/bin bash tests/tools/x.sh
TOP=$(cd "${TOP:-.}" && pwd)
BIN=${BIN:-$TOP/build/bin}
PATH=$BIN:$PATH
export TOP BIN PATH LC_ALL=C
TMP=$(mktemp -d "${TMPDIR:-/tmp}/luxpipe-test.XXXXXX") || exit 2
cd "$TMP" || exit 2
tests_run=0 tests_failed=0

finish() {
    status=$?
    trap - EXIT
    cd / && rm -rf "$TMP"
    [ "$status" -eq 77 ] && exit 77
    echo "1..$tests_run"
    [ "$tests_run" -gt 0 ] || { echo "no check was made"; exit 1; }
    [ "$tests_failed" -eq 0 ] && exit "$status"
    exit 1
}
trap finish EXIT

skip() { echo "skipped: $*"; exit 77; }
needs() { for program in "$@"; do command -v "$program" > /dev/null || skip "no $program here"; done; }

# smaller SIZE: from here on ptrace and vcregion make pictures of SIZE where nothing else is said (512 otherwise).
smaller() {
    mkdir -p "$TMP/smaller"
    for tool in ptrace vcregion; do
        printf '#!/bin/sh\nexec "%s" -x %s -y %s "$@"\n' "$BIN/$tool" "$1" "$1" > "$TMP/smaller/$tool"
    done
    chmod +x "$TMP"/smaller/*
    PATH=$TMP/smaller:$PATH
}

# grep -q leaves at its first match, and under pipefail the program before it then fails of SIGPIPE, now and then.
# Here it reads to the end of its input: it counts (-c), unseen.
grep() {
    case $1 in
        -*q*) command grep "${1/q/c}" "${@:2}" | cat > /dev/null; return "${PIPESTATUS[0]}" ;;
        *) command grep "$@" ;;
    esac
}

# not COMMAND: inside a check, where set -e takes no notice of "!" unless it comes last.
not() { "$@" && return 1; [ $? = 1 ]; }

# report ok|bad sentence [command]: one TAP line; a failure shows the command and what it said.
report() {
    tests_run=$((tests_run + 1))
    [ "$1" = ok ] && { echo "ok $tests_run - $2"; return; }
    tests_failed=$((tests_failed + 1))
    echo "not ok $tests_run - $2"
    printf '%s\n' "$3" | sed 's/^/#   /'
    head -c 2000 .stdout | tr -d '\000' | sed 's/^/#   stdout: /'
    head -c 2000 .stderr | sed 's/^/#   stderr: /'
}

# Runs in a subshell, so that set -e and cd stay there; variables set before are visible.
run_command() { (set -eo pipefail; eval "$1") > .stdout 2> .stderr < /dev/null; status=$?; }

check() { check_exit "$1" 0 "$2"; }

check_exit() {
    run_command "$3"
    if [ "$status" -eq "$2" ]; then report ok "$1"; else report bad "$1" "status $status, not $2, of: $3"; fi
}

check_error() {
    run_command "$4"
    if ! expr "$status" : "$2$" > /dev/null; then report bad "$1" "status $status, not $2, of: $4"
    elif [ "$(wc -l < .stderr)" -ne 1 ]; then report bad "$1" "not one line on stderr, of: $4"
    elif ! grep -qE -e "$3" .stderr; then report bad "$1" "stderr does not match $3, of: $4"
    else report ok "$1"; fi
}

# build_commands BUILD TARGET: ninja's commands, with one for each source that a file of a unity build includes.
build_commands() {
    command ninja -C "$1" -t commands "$2" > .commands || return
    sed -n 's|.* -c \([^ ]*/unity_[0-9]*_cxx.cxx\)$|\1|p' .commands | while read -r unity; do
        sed -n 's|^#include "\(.*[.]cpp\)"$|\1|p' "$unity" | while read -r source; do
            sed -n "s| -c $unity\$| -c $source|p" .commands
        done
    done
    cat .commands
}
