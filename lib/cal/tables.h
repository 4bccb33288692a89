// SPDX-License-Identifier: BSD-3-Clause
// Data files, pictures, fonts and text as records of the device (layout: kernels/cal/cal_data.h).  A file is read once
// per Code, however many patterns use it.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "cal/library.h"

namespace cal {

// A RADIANCE data file: N, then per dimension "begin end n" or "0 0 n p0 .. pn-1", then the values.
struct DataFile {
    struct Dimension {
        double begin = 0, end = 0;
        std::vector<float> positions;  // explicit ones; empty = even steps
        uint32_t count = 0;
        double at(uint32_t i) const {
            return positions.empty() ? begin + (end - begin) * i / (count - 1) : positions[i];
        }
    };
    std::vector<Dimension> dimensions;
    std::vector<float> values;  // last dimension fastest
};
DataFile read_data(const std::string& path, const base::Opener& by);

// Tables in `code`; `dimensions` is checked against the file.  Throw Error(place).
uint32_t data_table(Library::State& library, const std::string& file, size_t dimensions, const std::string& place,
                    Code& code);
uint32_t picture_table(Library::State& library, const std::string& file, const std::string& place, Code& code);
// A hyperspectral picture as tables of three bands each; nothing if the file is an ordinary picture.
struct SpectralTables {
    std::vector<uint32_t> tables;
    int bands = 0;
    double from = 0, to = 0;  // nm
};
std::optional<SpectralTables> spectral_tables(Library::State& library, const std::string& file,
                                              const std::string& place, Code& code);
uint32_t add_data(const DataFile& data, uint32_t channels, Code& code);

// Glyphs 0..255 of a font file: vertices x y x y ... in 0..255, y up.
struct Font {
    struct Glyph {
        bool defined = false;
        std::vector<int> vertices;
        int left = 128, right = 128;
    };
    std::vector<Glyph> glyphs;
    int mean_width = 0;  // M: mean of right - left over glyphs with extent
};
Font read_font(const std::string& path, const base::Opener& by);

// Starts of the characters of a line, and its width last: text.size() + 1 advances summed up (spacing: 255 g
// truncated).
std::vector<int> text_advances(const Font& font, const std::string& line, int spacing);
uint32_t text_table(const Font& font, const std::vector<std::string>& lines, int spacing, Code& code);

}  // namespace cal
