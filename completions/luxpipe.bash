# SPDX-License-Identifier: BSD-3-Clause
# Completion of options in bash, for all tools: installed under each one's name, found by bash-completion.
# What there is to complete is asked of -help, so that it is never behind the program.
_luxpipe() {
    local word=${COMP_WORDS[COMP_CWORD]}
    COMPREPLY=()
    [[ $word == -* ]] || return 0
    local options
    options=$("$1" -help all 2> /dev/null | sed -nE 's/^  (-[A-Za-z0-9]+)(\[\+-\])?.*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
}
complete -o default -F _luxpipe ptrace ptaccum vcmetrics vcregion vcyear vcview luxpipe-live
