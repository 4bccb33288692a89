// SPDX-License-Identifier: BSD-3-Clause
// Where RADIANCE looks for auxiliary files (.cal .dat .fnt .oct .rtm .xml, pictures): along RAYPATH, unless the name
// starts with "/", "." or "~" (~/ is $HOME).  Scene files are not searched.  A name that no file has is looked for with
// slashes in place of its backslashes as well: exports made on Windows have these.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/work_budget.h"

namespace base {

// Of -second-sky: how many suns and skies a scene may have.
enum class Skies { any, one, of_weather };

struct ReadOptions {
    Skies skies = Skies::any;                // of_weather: none but that
    bool exec = false;                       // -exec: "!command" other than the built-in generators may run
    std::vector<std::string> raypath;        // directories in order; empty = "." only
    std::vector<std::string> scene_folders;  // where the scene files lie: searched after these
    std::vector<std::string> cal_files;      // -f: function files whose definitions every primitive sees
    std::string asked_by;                    // what names the scene files, for open_file(); empty: the command line
    std::shared_ptr<WorkBudget> work = std::make_shared<WorkBudget>();  // what the whole scene may take
};

// The colon-separated directories of $RAYPATH; {"."} when it is not set.
std::vector<std::string> raypath_from_environment();

// Notes the folders of these files, so that a scene is found whole from anywhere (RADIANCE itself does not look there):
// names are looked for there, too, and names with a folder, as ./model/bsdf/x.xml, also in the folders above.
void search_beside(const std::vector<std::string>& files, ReadOptions& options);

// Path of a file by these rules; throws Error (place = who) if there is none that can be read.
std::string find_file(const std::string& name, const ReadOptions& options, const std::string& who);
// As find_file, but "" if there is none.
std::string look_for_file(const std::string& name, const ReadOptions& options);

// Where a command in the file `asker` finds the file it names: in the working directory, as RADIANCE has it, else
// beside the asker.
std::string beside(const std::string& name, const std::string& asker);

}  // namespace base
