// SPDX-License-Identifier: BSD-3-Clause
// Regions: parts of what the eye sees, named once in a small text file (man/vcregion.5) and found again in every view.
// read() makes a view-independent list; rasterize() turns it into one coverage plane per region for a view and size.
// Coverage is the share of the pixel's area in the picture, 0..1, or 0/1 by the pixel's centre (`centre`).
// Directions are in world axes; picture positions are in pixels from the LOWER left corner, y up.
// sensors_of() (sensors.h) lays points on them.
// To add a shape: 1. a keyword in parse.cpp  2. a class in shape.cpp  3. a line in man/vcregion.5.
#pragma once
#include <string>
#include <vector>
#include "base/vec.h"
#include "image/masks.h"
#include "view/view.h"

namespace region {
using base::Vec3;

enum class Kind {
    polygon3d,
    disc3d,
    box3d,
    sphere3d,  // in space, world units
    circle,
    polygon_direction,  // directions from the eye
    rect,
    polygon,  // in the picture
    mask,     // a picture file
    zone,     // of the field of view
    surface,
    modifier  // what the scene shows
};
enum class Frame { pixel, fraction, direction, point, view };  // what the numbers of a shape are

struct Shape {
    Kind kind;
    Frame frame = Frame::pixel;
    std::vector<double> numbers;  // angles already in degrees
    std::string text;             // mask: path; zone, surface, modifier: name or pattern
    std::string channel;          // mask: channel of an OpenEXR file, or empty
    std::string place;            // "office.regions:3"
    int within = -1;              // surface, modifier: only points inside this shape (box3d, sphere3d)
};
// A region is a tree over shapes: op 's' is shape a; '+' union, '-' difference, '&' intersection of a and b; '!' not a.
struct Node {
    char op;
    int a = -1, b = -1;
    int size = 1;  // nodes below and including this one; nodes of named regions count at each use
};
struct Region {
    std::string name, place;
    int root;
};
struct Regions {
    std::string file;
    std::vector<Shape> shapes;
    std::vector<Node> nodes;
    std::vector<Region> regions;  // in file order
};

// Throws base::Error with file:line.  "-" reads stdin; mask files are found relative to the region file.
// A text without a region is an error unless it may be empty.
Regions read(const std::string& path, bool may_be_empty = false);
Regions parse(const std::string& text, const std::string& file, bool may_be_empty = false);

// The pictures that its masks are read from.
std::vector<std::string> mask_files(const Regions& regions);

// Region k by itself, with the shapes that it uses.
Regions only(const Regions& regions, size_t k);

// Surfaces of the scene along a ray: transparent ones in order and the opaque one that ends it.
struct Crossing {
    double t;
    unsigned surface;
};
struct DistantSource {
    unsigned surface;
    Vec3 dir;  // unit, toward it
    double half_rad;
};
class SceneView {
public:
    virtual ~SceneView() = default;
    virtual unsigned surfaces() const = 0;
    virtual std::string surface_name(unsigned s) const = 0;
    virtual std::vector<std::string> modifier_names(unsigned s) const = 0;  // the whole chain, nearest first
    // Corners of a flat surface, counterclockwise as seen from where its normal points; empty: it is none.
    virtual std::vector<Vec3> face(unsigned) const { return {}; }
    // At most `room` crossings with 0 < t < tmax (tmax 0: no limit), sorted; `closed` says that the last is opaque.
    // Thread safe.
    virtual int look(Vec3 origin, Vec3 dir, double tmax, Crossing* out, int room, bool& closed) const = 0;
    virtual std::vector<DistantSource> distant() const { return {}; }  // the widest first, as look() has them
};

// One coverage plane per region.  Throws Error (place = the region's line) for a shape that this view cannot have.
// Without a scene nothing is hidden, and surface or modifier queries are an error.
image::MaskSet rasterize(const Regions& regions, const view::View& view, int nx, int ny, bool centre,
                         const SceneView* scene = nullptr);

// The line of -list: over the pixels that count in the field of view (a direction exists, and in an angular fisheye
// it is not behind the eye, as vcmetrics counts).
struct Extent {
    std::string name;
    double pixels = 0;    // sum of coverage
    double omega_sr = 0;  // sum of coverage * pixel solid angle
    double share = 0;     // of the view's solid angle (of its pixels in a parallel view)
    Vec3 centre;          // unit mean direction, zero if the region is empty
};
std::vector<Extent> measure(const image::MaskSet& set, const view::View& view);
// Only the names and pixels of it, quicker.
std::vector<Extent> count_pixels(const image::MaskSet& set, const view::View& view);

// Throws Error for an empty region; warns of regions of fewer than 32 pixels and their cost.
void check_sizes(const Regions& regions, const std::vector<Extent>& extents, bool warn_of_small = true);

// Does the pattern mean the name?  * stands for any letters, ? for one.
bool matches(const std::string& pattern, const std::string& name);

// Up to three of `names` that a person may have meant by `name`, as ' (did you mean "a" or "b"?)'; empty if none is
// near.
std::string near_matches(const std::string& name, const std::vector<std::string>& names);

}  // namespace region
