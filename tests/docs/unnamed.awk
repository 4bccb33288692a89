# SPDX-License-Identifier: BSD-3-Clause
# Names that two files of one folder have in unnamed namespaces or as `static`, in files that clang-format has laid out.
# `make` compiles eight files of a library as one (CMAKE_UNITY_BUILD), where they clash or are taken for each other.
#   awk -f unnamed.awk file ...        prints "file:line: name: also in file"
function declare(name,   folder) {
    folder = FILENAME; sub(/\/[^\/]*$/, "", folder)
    if (!((folder, name) in home)) home[folder, name] = FILENAME
    else if (home[folder, name] != FILENAME) print FILENAME ":" FNR ": " name ": also in " home[folder, name]
}
function last_word(text) { return match(text, /[A-Za-z_][A-Za-z_0-9]*$/) ? substr(text, RSTART) : "" }

FNR == 1 { inside = 0 }
/^namespace [{]/ { inside = 1; next }
/^}  \/\/ namespace/ { inside = 0 }
!(inside || /^static /) || !/^[A-Za-z]/ || /^(using|return|template|namespace|extern|static_assert|operator) ?/ { next }

{
    line = $0; sub(/ *\/\/.*/, "", line); gsub(/"[^"]*"/, "", line)
    while (sub(/<[^<>]*>/, "", line)) {}
}

/^(struct|class|enum|union) .*([{]|[^;]$)/ {
    sub(/ *[:{].*/, "", line); sub(/ final$/, "", line)
    declare(last_word(line))
    next
}

{
    head = line; sub(/[=({;[].*/, "", head); sub(/ *$/, "", head)
    name = last_word(head)
    if (head == name || head ~ /::[A-Za-z_0-9]+$/) next  # a macro, a method of a class
    if (substr(line, length(head) + 1, 1) == "(") { declare(name); next }
    while (match(line, /[A-Za-z_][A-Za-z_0-9]*(\[[^]]*\])*( = |[,;{])/)) {  # constexpr int a = 1, b = 2;
        name = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH)
        more = name ~ /,$/
        sub(/[^A-Za-z_0-9].*/, "", name)
        declare(name)
        if (!more && !sub(/^[^,]*, /, "", line)) break
    }
}
