// SPDX-License-Identifier: BSD-3-Clause
// See model_folder.h.
#include "base/model_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "base/split.h"

namespace base {
namespace {

namespace fs = std::filesystem;

// The files in this folder that end so, in the order of their names.
std::vector<std::string> files_in(const std::string& folder, const std::string& ending) {
    std::vector<std::string> found;
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent))
        if (ends_with(entry.path().filename().string(), ending) && !entry.is_directory())
            found.push_back(entry.path().generic_string());
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> honeybee_files(const std::string& folder) {
    std::vector<std::string> all;
    const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
    for (const char* part : {"/scene", "/aperture"}) {  // materials, and the surfaces that use them
        add(files_in(folder + part, ".mat"));
        add(files_in(folder + part, ".rad"));
    }
    for (const char* part : {"/aperture_group", "/aperture_group/interior", "/scene_dynamic", "/scene_dynamic/indoor"})
        add(files_in(folder + part, "..default..0.rad"));
    for (const std::string& file : files_in(folder + "/ies", ".rad"))
        if (!ends_with(file, "__.rad")) all.push_back(file);  // __name__.rad: what the others read
    return all;
}

}  // namespace

std::vector<std::string> open_folders(const std::vector<std::string>& files, ReadOptions& options) {
    std::vector<std::string> all;
    for (const std::string& file : files) {
        std::error_code absent;
        if (!fs::is_directory(file, absent)) {
            all.push_back(file);
            continue;
        }
        const std::vector<std::string> parts = honeybee_files(file);
        if (parts.empty()) {
            const std::string inner = (fs::path(file) / "model").generic_string();
            const std::string hint = honeybee_files(inner).empty() ? "" : "; " + inner + " is one";
            fail(file, "is a folder, but no model of Honeybee: it has no scene/*.rad and no aperture/*.rad" + hint);
        }
        all.insert(all.end(), parts.begin(), parts.end());
        search_beside({file + "/../"}, options);
    }
    search_beside(all, options);
    return all;
}

}  // namespace base
