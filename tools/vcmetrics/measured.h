// SPDX-License-Identifier: BSD-3-Clause
// What a run measures: its columns, and the analyzer of what they need.  In a live stream, whose pictures say EDIT=,
// the region file is read again when it has changed, and a region that is out of sight is nan.
#pragma once
#include <ctime>
#include <memory>
#include <string>
#include <vector>
#include "glare/columns.h"
#include "options.h"

class Measured {
public:
    explicit Measured(const Options& options);
    glare::PictureAnalyzer& analyzer() { return *analyzer_; }
    const std::vector<glare::Column>& columns() const { return columns_; }
    // Of which a value can be compared from edit to edit: the column, and the reading of its regions.
    std::vector<std::string> keys() const;

    // Throws Error where a region of -cr is not there, as it may be in a live stream.
    void require_pairs() const;
    // From here on the stream is live.
    void go_live() { live_ = true; }
    // In a live stream, before a picture.  True: the region file has changed, and perhaps the columns.  What is wrong
    // in it is told once, and the regions and columns stay. accept: throws Error where these columns will not do.
    bool read_regions_again(const std::function<void(const std::vector<glare::Column>&)>& accept);

private:
    struct Version {
        bool regular = false;
        long long inode = 0, bytes = 0;
        timespec changed{};
        bool operator==(const Version& v) const;
    };
    Version version_of_file() const;
    std::vector<glare::Column> choose(const std::vector<std::string>& regions, glare::Requirements& requirements) const;
    bool names(const std::string& region) const;
    const Options& options_;
    std::vector<std::string> named_;  // columns of -metrics and -until, regions of -cr
    std::vector<glare::ContrastPair> pairs_;
    bool live_ = false, lenient_ = false;
    Version version_;  // of the region file
    int reading_ = 0;
    std::vector<std::string> regions_;  // their names
    std::vector<glare::Column> columns_;
    std::unique_ptr<glare::PictureAnalyzer> analyzer_;
};
