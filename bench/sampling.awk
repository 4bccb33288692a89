# SPDX-License-Identifier: BSD-3-Clause
# sampling.awk SCENE.rpict.tsv SCENE.cached.tsv SCENE.plain.tsv ...: the table of bench/sampling.sh.  A line a way with
# its last errors; for a way of ours then three rows: rpict's seconds over those until each of its errors is reached,
# the same beside rpict with its cache, and plain's errors over this way's in equal time.  Between the points of a curve
# errors follow powers of time.  `>9` means that all points are better, `<.5` that the last is not yet.
FNR == 1 { files++; name[files] = FILENAME; sub(/\.tsv$/, "", name[files])
           way = name[files]; sub(/.*\./, "", way); ways[files] = way; index_of[way] = files; points[files] = 0 }
{ k = ++points[files]; t[files, k] = $2; for (i = 1; i <= 4; i++) error[files, k, i] = $(i + 2); frames[files] = $1 }

function between(x, x0, x1, y0, y1) { return y0 * exp(log(y1 / y0) * log(x / x0) / log(x1 / x0)) }
# how many times less than `have` seconds until error i is no more than `aim`, and stays so
function factor(f, i, aim, have,   k, s) {
    for (k = points[f]; k > 0 && error[f, k, i] <= aim; k--) {}
    if (k == points[f]) return sprintf("<%.2f", have / t[f, k])
    if (k == 0) return sprintf(">%.1f", have / t[f, 1])
    s = error[f, k + 1, i] > 0 ? between(aim, error[f, k, i], error[f, k + 1, i], t[f, k], t[f, k + 1]) : t[f, k + 1]
    return sprintf("%.2f", have / s)
}
function error_at(f, i, s,   k) {
    for (k = 2; k < points[f] && t[f, k] < s; k++) {}
    return error[f, k, i] > 0 ? between(s, t[f, k - 1], t[f, k], error[f, k - 1, i], error[f, k, i]) : 0
}
function beside(f, g,   i) {
    printf "  %s: seconds over", ways[g]
    printf "\t%s", name[f]
    for (i = 1; i <= 4; i++) printf "\t%s", factor(f, i, error[g, points[g], i], t[g, points[g]])
    print ""
}
END {
    for (f = 1; f <= files; f++) {
        printf "%s\t%d\t%.2f", name[f], frames[f], t[f, points[f]]
        for (i = 1; i <= 4; i++) printf "\t%.4f", error[f, points[f], i]
        print ""
    }
    for (f = 1; f <= files; f++) {
        if (ways[f] == "rpict" || ways[f] == "cached") continue
        if ("rpict" in index_of) beside(f, index_of["rpict"])
        if ("cached" in index_of) beside(f, index_of["cached"])
        if (ways[f] == "plain" || !("plain" in index_of)) continue
        p = index_of["plain"]
        s = t[f, points[f]] < t[p, points[p]] ? t[f, points[f]] : t[p, points[p]]
        printf "  plain: errors over, %.1f s\t%s", s, name[f]
        for (i = 1; i <= 4; i++) { e = error_at(f, i, s); printf("\t%.2f", e > 0 ? error_at(p, i, s) / e : 0) }
        print ""
    }
}
