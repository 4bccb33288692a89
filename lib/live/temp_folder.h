// SPDX-License-Identifier: BSD-3-Clause
// A folder of our own, which goes with the value.
#pragma once
#include <filesystem>
#include <string>

namespace live {

class TempFolder {
public:
    TempFolder();  // throws base::Error (system)
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    std::string name(const std::string& of) const { return path_ / of; }
    std::string write(const std::string& of, const std::string& text) const;  // the path

private:
    std::filesystem::path path_;
};

}  // namespace live
