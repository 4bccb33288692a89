// SPDX-License-Identifier: BSD-3-Clause
// Hours that are to come, of runs that were cut off, in parts, joined or rendered again.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "base/error.h"
#include "year/wanted.h"

using year::Wanted;

namespace {

// Hours k = first .. last of a run of n, of which number k is at minute begin + 60 k.
void add(int first, int last, int n, int begin, Wanted& to) {
    for (int k = first; k <= last; ++k) to.add(begin + 60 * k, std::to_string(k) + "/" + std::to_string(n), "t.tsv");
}

}  // namespace

TEST_CASE("a run that was cut off lacks its last hours, one that goes on has them all") {
    Wanted w;
    add(1, 1817, 2600, 0, w);
    CHECK(w.missing() == 783);
    add(1818, 2600, 2600, 0, w);
    CHECK(w.missing() == 0);
    add(5, 9, 2600, 0, w);  // rendered again
    CHECK(w.missing() == 0);
}

TEST_CASE("a part of a run lacks the others") {
    Wanted w;
    add(325, 487, 2600, 0, w);
    CHECK(w.missing() == 2600 - 163);
}

TEST_CASE("two runs of as many hours each are two") {
    Wanted w;
    add(1, 1300, 1300, 0, w);
    add(1, 500, 1300, 200000, w);
    CHECK(w.missing() == 800);
}

TEST_CASE("named hours fill a gap, and are no year where they are alone") {
    Wanted alone, w;
    for (Wanted* to : {&alone, &w})
        for (int k = 1818; k <= 2600; ++k) to->add(60 * k, "-", "t.tsv");
    CHECK(alone.missing() == 0);
    add(1, 1817, 2600, 0, w);
    CHECK(w.missing() == 0);
    w.add(60 * 3, "", "t.tsv");  // of a table of an earlier version
    CHECK(w.missing() == 0);
}

TEST_CASE("other words are refused") {
    for (const char* cell : {"3", "x/4", "5/4", "0/4", "-3/4", "1/99999999"})
        CHECK_THROWS_AS(Wanted().add(0, cell, "t.tsv"), base::Error);
}
