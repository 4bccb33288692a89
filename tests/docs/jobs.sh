# SPDX-License-Identifier: BSD-3-Clause
# The ten jobs of README.md run as they stand, one after another in one folder, only smaller.
. "${TOP:?}/tests/lib.sh"
needs ptrace ptaccum vcmetrics vcregion vcyear make
cp "$TOP"/examples/scenes/office/* "$TOP/mk/luxpipe.mk" .

awk '/^\*\*Ten jobs\*\*/ { jobs = 1 }
     jobs && /^```/ { if (on) exit; on = 1; next }
      on && /^# / { n++; print > ("title." n) }
     on { print > ("job." n) }' "$TOP/README.md"
sed -i -E 's/-([xy]) (128|64)/-\1 24/g; s/SIZE=64 FRAMES=17/SIZE=24 FRAMES=5/
    s/seq 30/seq 3/; s/-pixel 80,100/-pixel 12,20/
    s/-spacing .5/-spacing 1/; s/-wea days.wea/& -frames 5/' job.*
jobs=$(ls job.* | sort -t . -k 2n)
check 'there are ten' '[ "$(echo "$jobs" | wc -l)" = 10 ]'
for job in $jobs; do
    check "$(cut -c 3-90 "title.${job#job.}")" "timeout 100 bash -eo pipefail $job > $job.out"
done
check 'numbers come with intervals: of a view, of points, of an hour, of a difference, of a variant' '
    head -n 1 job.1.out | grep -q "	DGPf.lo	DGPf.hi	"; head -n 1 job.2.out | grep -q "	floor.df.lo	floor.df.hi"
    head -n 1 hours.tsv | grep -q "	DGPf.lo	"; head -n 1 job.5.out | grep -q "	lo	hi	"
    [ "$(awk "NR == 1 { print \$4, \$7 } NR > 1 && \$3 < \$2 && \$2 < \$4" table.tsv | wc -l)" = 4 ]'
check 'a year has its class and its map, sensors have sDA and UDI' '
    grep -q "^DGPe5.*EN 17037" job.3.out; grep -q "<svg" hours.svg; grep -q "^sDA" job.4.out; grep -q UDI job.4.out'
check 'a foreign picture has a class, a report its numbers, a pixel its lights' '
    [ "$(tail -n 1 job.6.out | cut -f 4)" != "" ]; grep -q "</html>" open.html; grep -q "^light	sun" job.10.out'
check 'the picture that went on has all 128 frames' 'ptaccum blinds.exr -o x.hdr; grep -aq "^FRAMES=128" x.hdr'
