#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# uncorrelated.sh OUT NAME ...: the reference pictures once more with rtrace -u+, whose samples are independent, and
# otherwise the options they were made with (tests/golden/reference/README.md).  Needs RADIANCE's programs on PATH.
# Writes OUT/NAME.hdr (floats) and OUT/NAME.blocks.tsv for `GOLDEN=OUT run.sh`; RAYS (4) jittered rays per pixel, whose
# scatter gives the standard errors.
set -euo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1" && out=$(cd "$1" && pwd) && shift
golden=$top/tests/golden/reference rays=${RAYS:-4}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for name; do
    [ ! -f "$out/$name.hdr" ] || continue
    cd "$top/examples/scenes/${name%%_*}"
    case $name in office_*) view=view.vf ;; *) view=${name#*_}.vf ;; esac
    ds=.05
    [ "$name" != classroom_back_row ] || ds=0
    oconv $(awk -F '\t' -v name="${name/west/east}" '$1 == name { print $4 }' "$golden/ev.tsv") > "$work/scene.oct"
    vwrays -ff -vf "$view" -x 256 -y 256 -pj 1 -c "$rays" |
        rtrace -h -fff -u+ -ds $ds -dj 1 -dt 0 -dc 1 -dr 2 -dp 0 -aa 0 -ab 6 -ad 64 -as 0 -lr -12 -lw 1e-6 -st 0 -ss 4 \
            "$work/scene.oct" |
        perl -e '
            my ($out, $rays) = @ARGV;
            my (@sum, @square, $picture);
            binmode STDIN;
            for my $i (0 .. 65535) {
                read(STDIN, my $bytes, 12 * $rays) == 12 * $rays or die "rtrace ended early\n";
                my @v = unpack("f<*", $bytes);
                my (@mean, $lum, $square);
                for my $k (0 .. $rays - 1) {
                    my ($r, $g, $b) = @v[3 * $k .. 3 * $k + 2];
                    my $l = 179 * (0.265074126 * $r + 0.670114631 * $g + 0.064811243 * $b);
                    $lum += $l / $rays; $square += $l * $l / $rays;
                    $mean[$_] += $v[3 * $k + $_] / $rays for 0 .. 2;
                }
                $picture .= pack("f<3", @mean);
                my $block = int($i / 4096) * 16 + int($i % 256 / 16);
                $sum[$block] += $lum / 256;
                $square[$block] += ($square - $lum * $lum) / ($rays - 1) / 65536;
            }
            open(my $h, ">", "$out.hdr.part") or die;
            print $h "#?RADIANCE\nNCOMP=3\nFORMAT=float\nBigEndian=0\n\n-Y 256 +X 256\n$picture";
            close $h or die;
            open(my $b, ">", "$out.blocks.tsv") or die;
            print $b "column\trow\tmean\tse\n";
            for my $r (0 .. 15) { for my $c (0 .. 15) {
                my $k = 16 * $r + $c;
                printf $b "%d\t%d\t%.6g\t%.3g\n", $c, $r, $sum[$k], sqrt($square[$k]) if $sum[$k] > 0;
            } }
            close $b or die;
            rename "$out.hdr.part", "$out.hdr" or die;' "$out/$name" "$rays"
    echo "$name: $rays rays a pixel" >&2
done
