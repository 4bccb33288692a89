// SPDX-License-Identifier: BSD-3-Clause
// Points with directions, as rtrace reads them: sensors with their normals, or rays.  A picture of points has a pixel
// for each, row by row; its header names the grids that they belong to (man/luxpipe-stream.5).
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "base/vec.h"

namespace image {

struct Point {
    base::Vec3 p, dir;  // dir: unit
    uint32_t line = 0;  // of the file
};

// Consecutive pixels of a picture.
struct Grid {
    std::string name;  // PointFile.name
    size_t first = 0, count = 0;
    bool sensors = true;  // values are irradiances; else radiances along rays
    std::string hash;     // of the points
};
bool operator==(const Grid& a, const Grid& b);

struct GridFile {
    std::string path;  // for messages
    std::string name, hash;
    std::vector<Point> points;
};
using GridFiles = std::vector<GridFile>;

constexpr size_t most_points = size_t(1) << 24;

// A file of points, and its grid's name: the file's without folder and ending, with _ for blanks; in a sub-folder of a
// folder of grids, the folder comes first: floor1_desk.
struct PointFile {
    std::string path, name;
};

// Files as they are named, and in place of a folder its .pts files (also .PTS) and those of its sub-folders, in the
// order of their names (Honeybee's model/grid).  Throws Error for a folder without one.
std::vector<PointFile> point_files(const std::vector<std::string>& paths, base::FilesRead* looked_at = nullptr);

// x y z dx dy dz a line; # begins a comment.  "-": the standard input.  Throws Error (file:line) for anything else.
GridFile read_points(const PointFile& file, const base::Opener& by = {});

// The grids of all files, in their order.  Throws Error (place: the file) if two have the same name.
std::vector<Grid> grids_of(const GridFiles& files, bool sensors);
size_t count_of(const std::vector<Grid>& grids);

// Sides of a picture for so many points: about square, and less than a row of pixels is left over.
void size_for(size_t points, int& width, int& height);

// The header line and back: GRID=name first count irradiance|radiance hash.  Throws Error (place).
std::string to_text(const Grid& grid);
Grid parse_grid(const std::string& text, const std::string& where);

}  // namespace image
