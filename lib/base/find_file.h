// SPDX-License-Identifier: BSD-3-Clause
// Which file a name in a scene means: the one in the folder of the file that names it (docs/decisions/0041), else where
// RADIANCE looks: auxiliary files (.cal .dat .fnt .oct .rtm .xml, pictures) along RAYPATH, unless the name starts with
// "/", "." or "~" (~/ is $HOME), scene files in the working directory.  Both there and different: a warning.  A name
// that no file has is looked for with slashes in place of its backslashes as well: exports made on Windows have these.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "base/work_budget.h"

namespace base {

// Of -second-sky: how many suns and skies a scene may have.
enum class Skies { any, one, of_weather };

struct ReadOptions {
    Skies skies = Skies::any;                // of_weather: none but that
    bool exec = false;                       // -exec: "!command" other than the built-in generators may run
    std::vector<std::string> raypath;        // directories in order; empty = "." only
    std::vector<std::string> scene_folders;  // where the scene files lie: searched last
    std::vector<std::string> cal_files;      // -f: function files whose definitions every primitive sees
    std::string asked_by;                    // what names the scene files, for open_file(); empty: the command line
    std::shared_ptr<WorkBudget> work = std::make_shared<WorkBudget>();  // what the whole scene may take
    Overlays overlays;                                                  // texts that stand for files
    std::shared_ptr<FilesRead> read = std::make_shared<FilesRead>();    // filled by whoever reads, also before an Error

    Opener opener(std::string place) const { return {std::move(place), &overlays, read.get()}; }
};

// The directories of $RAYPATH, which colons separate, on Windows semicolons; {"."} when it is not set.
std::vector<std::string> raypath_from_environment();

// Notes the folders of these files, so that a scene is found whole from anywhere (RADIANCE itself does not look there):
// names are looked for there, too, and names with a folder, as ./model/bsdf/x.xml, also in the folders above.
void search_beside(const std::vector<std::string>& files, ReadOptions& options);

// Path of an auxiliary file by these rules; place: "file:line", which names it.  Throws Error if there is none that can
// be read.
std::string find_file(const std::string& name, const ReadOptions& options, const std::string& place);
// As find_file, but "" if there is none.
std::string look_for_file(const std::string& name, const ReadOptions& options, const std::string& place);

// Path of a scene file, or of another one that RADIANCE does not search for; `name` if there is none.
std::string beside(const std::string& name, const std::string& place);

}  // namespace base
