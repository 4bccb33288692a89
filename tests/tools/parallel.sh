# SPDX-License-Identifier: BSD-3-Clause
# examples/cluster by GNU parallel: shares merge to the bits of one run, and what was done before is not done again.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum mkstream parallel
cp -r "$TOP/examples" .
cd examples/cluster || exit 2
export SIZE=16 FRAMES=40 PARALLEL_HOME=$TMP
bash share.sh 0 1 single

check 'eight shares merge to the bits of one run' '
    bash parallel.sh --will-cite && [ "$(mkstream differ single/0.exr out/whole.exr)" = 0 ]'
check 'a second run makes nothing' '
    touch -d 2000-01-01 out/3.exr && bash parallel.sh --will-cite && [ -z "$(find out/3.exr -newermt 2001-01-01)" ]'
check 'a share that was stopped is made again, alone' '
    mkdir broken; printf "#!/bin/bash\ncase \$* in *20:24*) exit 9;; esac; exec $BIN/ptrace \"\$@\"\n" > broken/ptrace
    chmod +x broken/ptrace; export OUT=again
    PATH=$PWD/broken:$PATH not bash parallel.sh --will-cite; ls again; not test -e again/4.exr
    touch -d 2000-01-01 again/3.exr; bash parallel.sh --will-cite
    [ -z "$(find again/3.exr -newermt 2001-01-01)" ]
    [ "$(mkstream differ single/0.exr again/whole.exr)" = 0 ]'
