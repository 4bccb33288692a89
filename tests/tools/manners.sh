# SPDX-License-Identifier: BSD-3-Clause
# What people see on a terminal, what they can complete, install and remove, and what headers tell them later.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics
printf 'void light l 0 0 3 1 1 1\nl source s 0 0 4 0 0 1 30\n' > sky.rad
cp "$TOP"/tests/golden/glare/images/office256.hdr .
on_terminal() { script -qec "$1" typescript < /dev/null > /dev/null; tr '\r' '\n' < typescript; }

if command -v script > /dev/null; then
    check 'bare vcmetrics says what it waits for' '
        on_terminal "timeout --foreground 1 vcmetrics </dev/tty || true" > t
        grep -q "^.\[Kvcmetrics: waits for pictures on the standard input" t'
    check 'progress tells the last frame and the time left' '
        on_terminal "ptrace -w- -x 256 -y 256 -vta -vh 180 -vv 180 -vd 0 0 1 -vu 0 1 0 -frames 40 sky.rad | cat > x" |
            grep -qE "ptrace: frame [0-9]+ of 39, .* s left, "'
    check 'a start that may take long is told of' '
        on_terminal "OCL_ICD_VENDORS=/nonexistent ptrace -device opencl -frames 1 sky.rad | cat > x" > t
        grep -q "ptrace: starts opencl; its kernels are compiled the first time" t'
    check 'a row of a table takes the place of progress' '
        on_terminal "vcmetrics office256.hdr" | grep -q "^.\[Koffice256.hdr"
        vcmetrics office256.hdr | grep -q "^office256.hdr"'
    # what stays on the screen, line by line
    screen() {
        python3 -c '
import re, sys
done, line, at = [], "", 0
for text in re.findall(r"\r|\n|\x1b\[K|[^\r\n\x1b]+", sys.stdin.read()):
    if text == "\r": at = 0
    elif text == "\n": done.append(line); line, at = "", 0
    elif text == "\x1b[K": line = line[:at]
    else: line = line[:at] + text + line[at + len(text):]; at += len(text)
print("\n".join(done))'
    }
    check 'a pipe has one line of progress, which is neither in the table nor in a message' '
        on_terminal "ptrace -x 256 -y 256 -vta -vh 180 -vv 180 -vd 0 0 1 -vu 0 1 0 sky.rad | ptaccum |
            vcmetrics -metrics Ev -max-frames 31" > t; grep -q "ptrace: frame" t
        screen < typescript | sed "1d;/^$/d;/^Script/d" > s; grep -c "^ *[0-9]* *[0-9.]* *[0-9.]*$" s | grep -qx 31
        grep -v "^ *[0-9]* *[0-9.]* *[0-9.]*$" s > others; sed "s/ after.*//" others | tr "\n" " " > t
        grep -qE "^ *frame +seconds +Ev vcmetrics: stopped $" t'
fi
check 'options are completed' '
    . "$TOP/completions/luxpipe.bash"
    COMP_WORDS=(ptrace -fr) COMP_CWORD=1; _luxpipe ptrace; [ "${COMPREPLY[*]}" = -frames ]
    COMP_WORDS=(vcmetrics scene) COMP_CWORD=1; _luxpipe vcmetrics; [ "${#COMPREPLY[@]}" = 0 ]'
check 'make install asks for no packages; make uninstall removes what was installed' '
    make -s -n -C "$TOP" install > t; grep -qF "[ \"no\" = no ]" t
    mkdir -p build p/bin; : > p/bin/ptrace; : > p/other; echo "$PWD/p/bin/ptrace" > build/install_manifest.txt
    make -s -C "$TOP" uninstall BUILD="$PWD/build"
    test ! -e p/bin/ptrace; test -e p/other; test ! -e build/install_manifest.txt'

echo '-ab 2 -x 8 -y 8' > render.opt
check 'headers tell what @files and $VARIABLES said' '
    export MORE="-frames 1"
    ptrace @render.opt "\$MORE" sky.rad | strings | grep -qx "ptrace -ab 2 -x 8 -y 8 -frames 1 sky.rad"'
if command -v oconv > /dev/null; then
    check 'an octree tells its oconv' '
        oconv -f sky.rad > frozen.oct; ptrace -frames 1 -x 8 -y 8 frozen.oct | strings | grep -qx "oconv -f sky.rad"'
fi
check 'a file has the date of its pixels, a stream has none' '
    ptrace -frames 2 -x 8 -y 8 -vta -vh 180 -vv 180 sky.rad | SOURCE_DATE_EPOCH=86400 ptaccum -o a.exr -o a.hdr
    strings a.hdr | grep -qx "CAPDATE= 1970:01:02 00:00:00"; ptaccum a.exr -o b.hdr
    [ "$(strings b.hdr | grep -c CAPDATE=)" = 1 ]
    ptaccum a.hdr -o c.hdr; strings c.hdr | grep -qx "CAPDATE= 1970:01:02 00:00:00"
    ptrace -frames 2 -x 8 -y 8 sky.rad | ptaccum -last | strings | { ! grep -q CAPDATE; }'
