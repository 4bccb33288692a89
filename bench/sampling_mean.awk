# SPDX-License-Identifier: BSD-3-Clause
# sampling_mean.awk NOISE RUNS: the runs of several seeds (lines of frames, seconds, four errors) as one curve: mean
# seconds, rms errors, without the reference's noise, which is independent of theirs.  What is within it is 0.
FNR == NR { for (i = 1; i <= 4; i++) noise[i] = $i; next }
!($1 in runs) { order[++points] = $1 }
{
    runs[$1]++
    seconds[$1] += $2
    for (i = 1; i <= 4; i++) squares[$1, i] += $(i + 2) ^ 2
}
END {
    for (p = 1; p <= points; p++) {
        n = order[p]
        printf "%d\t%.3f", n, seconds[n] / runs[n]
        for (i = 1; i <= 4; i++) {
            square = squares[n, i] / runs[n] - noise[i] ^ 2
            printf("\t%.4f", square > 0 ? sqrt(square) : 0)
        }
        print ""
    }
}
