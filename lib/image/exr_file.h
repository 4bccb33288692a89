// SPDX-License-Identifier: BSD-3-Clause
// OpenEXR files as named channels plus the text of a RADIANCE header: what pictures and masks share.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "image/exr.h"
#include "image/primaries.h"

namespace image {

// Reads the display window; what the data window does not cover is 0.  Throws Error for anything broken.
class ExrInput {
public:
    explicit ExrInput(const std::string& path, const base::Opener& by = {});  // as for base::open_file()
    ~ExrInput();
    int width() const { return width_; }
    int height() const { return height_; }
    std::vector<std::string> channels() const;
    bool has(const std::string& channel) const;
    // Channels interleaved, rows from the top.  Memory grows with what could be decoded.
    std::vector<float> read(const std::vector<std::string>& channels) const;
    std::vector<uint32_t> read_whole(const std::vector<std::string>& channels) const;  // channels of whole numbers
    std::optional<std::string> text(const std::string& attribute) const;               // string attribute
    std::map<std::string, std::string> texts() const;                                  // all of them
    Header header() const;           // from "radianceHeader", else the view in VIEW, other texts as history
    double white_luminance() const;  // cd/m2 of R = G = B = 1; 179 if the file does not say
    Primaries primaries() const;     // stated, or RADIANCE's in our files, else those of Rec. 709

private:
    struct File;
    template <class T>
    std::vector<T> read_as(const std::vector<std::string>& channels) const;
    std::string path_;
    std::unique_ptr<File> file_;
    int width_ = 0, height_ = 0;
};

struct ExrChannel {
    std::string name;
    const void* first;   // of the top left pixel: a float, or where whole is set a uint32_t
    int stride;          // of them from pixel to pixel
    bool whole = false;  // whole numbers, never made half
    bool half = false;   // made half in any file
};
// The bytes of a file of this name.
std::string exr_bytes_of(const std::string& path, int width, int height, const std::vector<ExrChannel>& channels,
                         const Header& header, const std::map<std::string, std::string>& texts,
                         const ExrOptions& options);
// Whole or not at all.
void write_exr_channels(const std::string& path, int width, int height, const std::vector<ExrChannel>& channels,
                        const Header& header, const std::map<std::string, std::string>& texts,
                        const ExrOptions& options);

}  // namespace image
