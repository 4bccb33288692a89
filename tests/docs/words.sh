# SPDX-License-Identifier: BSD-3-Clause
# Names that no reader can look up stay out of the code: docs/glossary.md has the field's terms for them.
. "${TOP:?}/tests/lib.sh"

# Whole words of names and comments.  A name is added here when the last of its kind is renamed.
words='Swayed swayed Calm Calmed calmer MoreLight OffAtEye weave Lesson carry_across in_the_middle in_doubt Doubtful
know_frame0 far_worth path_thin path_weigh gift takes_place promise find_shares look_through choose_way at_far
FAR_ENOUGH HAS_FAR_END is_near_end gate_shuts good_slots leaves_host_free aim_shares MODE_WALK MET_LAMP know_links
speak_as evalglare_says Connector bright_in Chooser GreyMean PrecisionRule HARDLY CLEARLY SELDOM WORTH_IT PATH_GOES_ON
GATE_FLOATS MT_SHINES NearEnd LinkWords clip_beyond prefix_thr least_reach to_strips densities SeenPixels Shot
Certainty Weighing Survey worth_of_shared may_share group_share threads_to_be_had to_share keep_inputs
trace_on'

# "file:line:text" for each of them in the folders given.
private() {
    grep -rnwE "$(echo $words | tr ' ' '|')" --include='*.h' --include='*.cpp' --include='*.cl' --include='*.isp*' "$@"
}

check 'no private words in the code' '! private "$TOP/lib" "$TOP/tools" "$TOP/tests/unit" "$TOP/tests/physics" >&2'

echo 'int Swayed = 0;' > x.cpp
check 'such a word is seen' 'private . | grep -q x.cpp:1:'

check 'each term of the glossary has a meaning and a source' '
    awk -F "|" "/^\|/ && ++n > 2 && (NF != 5 || \$2 \$3 \$4 ~ /^ *$/ || \$3 ~ /^ *$/ || \$4 ~ /^ *$/)" \
        "$TOP/docs/glossary.md" > bad; cat bad >&2; test ! -s bad'
