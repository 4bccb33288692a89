// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's information header <-> image::Header.  Used by the RADIANCE and OpenEXR readers and writers.
#pragma once
#include <array>
#include <optional>
#include <string>
#include "image/picture.h"
#include "image/primaries.h"

namespace image {

// Storage of the pixels of one picture: the lines of a header that are not in image::Header.
struct Encoding {
    Format format = Format::rgbe;    // pictures without FORMAT= are RGBE
    int channels = 3;                // NCOMP=, float pictures: 1 (grey) or 3
    std::optional<bool> big_endian;  // BigEndian=; absent: the host's order
    int rows = 0, columns = 0;       // NROWS=, NCOLS=: then no resolution line follows
    std::array<double, 3> colorcorr{1, 1, 1};
    bool moments_follow = false;  // LAYERS=moments: a picture of this one's moments comes behind it
    bool moments = false;         // LAYER=moments: this is one
    bool spectra = false;         // FORMAT=Radiance_spectra: NCOMP bands (spectral.h)
    std::optional<std::array<double, 4>>
        splits;                          // WAVELENGTH_SPLITS=, nm: the bands lie between the first and the last
    std::optional<Primaries> primaries;  // PRIMARIES=; eight zeros state none
};

// One line of the header (no line end) into its field; lines not understood become history.
void parse_header_line(const std::string& line, Header& header, Encoding& encoding, const std::string& where);

// The header as lines: #?RADIANCE, history, SOFTWARE=, VIEW=, ..., without FORMAT= and the empty line.
// No line is longer than RADIANCE's limit of 2048 characters.
std::vector<std::string> header_lines(const Header& header);

// A command line or other text as a line of history, cut to RADIANCE's limit; in brackets if it would mean more.
void add_history(Header& header, const std::string& text);

// "CAPDATE= 2026:11:22 03:10:54", local time, as RADIANCE's programs date pictures, unless the history has one.
// $SOURCE_DATE_EPOCH (seconds) stands for now where the same bytes are wanted again, and is written in UTC.
void add_date(Header& header);

// The inputs' headers as history of a picture made from several: every line indented by one tab.
void add_input_history(Header& header, const std::string& name, const Header& input);

// A name of a view or a sky becomes part of file names: throws Error (place) for one that would be a path.
const std::string& plain_name(const std::string& name, const std::string& where);
const std::string& state_name(const std::string& name, const std::string& where);  // a slash may follow a group

// "desk_sky_0900", "desk_mel": what the picture shows, if its stream shows several things; else empty.
std::string label(const Header& header);

// "0:9,12:20" for messages.
std::string to_text(const Ranges& ranges);

}  // namespace image
