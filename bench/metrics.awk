# SPDX-License-Identifier: BSD-3-Clause
# metrics.awk TRUTH RUNS: a line of bench/metrics.sh from lines of seed, seconds and four metrics.
FNR == NR { for (i = 1; i <= 4; i++) truth[i] = $i; next }
!($1 in last) { seeds++; for (i = 1; i <= 5; i++) since[i, $1] = -1 }
{
    together = 1
    for (i = 1; i <= 4; i++) {
        error[i, $1] = $(i + 2) / truth[i] - 1
        right = error[i, $1] <= .01 && error[i, $1] >= -.01
        if (!right) since[i, $1] = -1
        else if (since[i, $1] < 0) since[i, $1] = $2
        if (i <= 3) together = together && right
    }
    if (!together) since[5, $1] = -1
    else if (since[5, $1] < 0) since[5, $1] = $2
    last[$1] = $2
}
# the middle of what seeds needed; those that are not there yet come last
function median(i,   seed, n, k, other, values) {
    for (seed in last) {
        for (k = n++; k > 0 && (since[i, seed] >= 0 && (values[k - 1] < 0 || values[k - 1] > since[i, seed])); k--)
            values[k] = values[k - 1]
        values[k] = since[i, seed]
    }
    return values[int(n / 2)]
}
END {
    printf "%s", name
    for (i = 1; i <= 5; i++) { m = median(i); printf("\t%s", m < 0 ? "-" : sprintf("%.2f", m)) }
    printf "\terrors"
    for (i = 1; i <= 4; i++) {
        squares = 0
        for (seed in last) squares += error[i, seed] ^ 2
        printf "\t%.2f", 100 * sqrt(squares / seeds)
    }
    print ""
}
