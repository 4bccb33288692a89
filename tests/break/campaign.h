// SPDX-License-Identifier: BSD-3-Clause
// A campaign: many trials from a seed, each with its own folder; a table of outcomes; what was found is kept.
// All programs of tests/break take the same options:
//   -tries N    how many (each has a number, from 0)          -seed S    other trials (1)
//   -only K     only trial K, and say what happened         -limit S   seconds until a trial counts as a hang (30)
//   -keep DIR   where the folders of finds stay (break-finds, beside the folder of the programs)
// They run the tools that lie beside them.  Status 0: no find, 1: finds, 2: the campaign itself failed.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "child.h"
#include "dice.h"

namespace breaking {

struct Settings {
    uint64_t seed = 1, tries = 100;
    long only = -1;
    double limit_s = 30;
    std::string keep, bin;  // bin: folder of the tools
    std::string tool(const std::string& name) const { return bin + "/" + name; }
    bool has(const std::string& name) const;
    bool tells() const { return only >= 0; }
};

struct Verdict {
    std::string outcome;  // a row of the table: "status 0, as read", "status 1" ...
    std::string find;     // what is wrong; empty: nothing
    std::string story;    // commands and what they said; kept with a find
};

// trial(dice, folder): the folder is empty and goes away afterwards, unless there is a find.
using Trial = std::function<Verdict(Dice&, const std::string& folder)>;

Settings parse_settings(int argc, char** argv, uint64_t tries);
int campaign(const char* name, const Settings& settings, const Trial& trial);

// Runs a job; one that seems to hang gets a second chance with four times the time: machines have bad moments.
Result run_patiently(Job job, const Settings& settings);

std::string read_file(const std::string& path);  // exits where it cannot be read
void write_file(const std::string& path, const std::string& bytes);
std::vector<std::string> files_of(const std::string& folder);  // names, sorted; hidden ones, too

}  // namespace breaking
