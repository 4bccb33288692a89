# SPDX-License-Identifier: BSD-3-Clause
# Names of files in comments and pages that no file of the tree has.
#   awk -f names.awk LIST file ...       LIST has a path a line; prints "file:line: name"
# A name with folders must be the end of a path, or begin one (docs/decisions/0002); one without must be a file's name.
# Names with capitals or of one letter are placeholders (mat_NAME.h, x.sh).
function known(name,   path) {
    if (name in ends) return 1
    if (index(name, "/"))
        for (path in ends) if (index(path, name) == 1) return 1
    return 0
}

NR == FNR {
    for (rest = $0; rest != "";) {                    # lib/a/b.h: b.h, a/b.h, lib/a/b.h, and the folders lib/a, a, lib
        folder = rest
        while (folder != "") { ends[folder]; if (!sub(/\/[^\/]*$/, "", folder)) folder = "" }
        if (!sub(/^[^\/]*\//, "", rest)) rest = ""
    }
    next
}

FNR == 1 {
    code = FILENAME ~ /[.](cpp|h|cl|inl)$/
    script = FILENAME ~ /[.](sh|py|awk|cmake)$|CMakeLists.txt$|Makefile$/
}

{
    line = $0
    if (code && (line ~ /#include/ || !match(line, /\/[\/*]/))) next
    if (script && !match(line, /(^|[ \t])#/)) next
    if (code || script) line = substr(line, RSTART)
    gsub(/\\-/, "-", line); gsub(/\\f[BIR]/, "", line)
    while (match(line, /[A-Za-z0-9_.$*%{}<>\/-]+/)) {
        name = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH)
        sub(/^[.]\//, "", name); sub(/[.\/]+$/, "", name)
        if (name ~ /[$*%{}<>A-Z]|^\/|[.][.]|-I/ || name ~ /(^|\/)[a-z]([.\/]|$)/) continue
        if (name !~ /[^.\/][.](h|cpp|cl|inl|sh|py|md|awk|cmake)$/ &&
            name !~ /^(lib|tests|docs|tools|studies|bench|scripts|examples|cmake)\/./) continue
        if (!known(name)) print FILENAME ":" FNR ": " name
    }
}
