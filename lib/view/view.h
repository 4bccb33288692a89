// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE views: the six projections, pixel <-> direction, pixel solid angle, VIEW= lines.
// Image location (X,Y) in [0,1]^2, X right, Y UP; pixel (i,j) has j counted from the BOTTOM row;
// its centre is ((i+.5)/nx, (j+.5)/ny).  Angles in degrees, lengths in world units.
// Formulas: the view section of RADIANCE's reference manual; measured against vwrays (tests/golden/vwrays.tsv).
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "base/vec.h"

namespace base {
class OptionTable;
}

namespace view {
using base::Vec3;

struct View {
    char type = 'v';  // v perspective, l parallel, a angular fisheye, h hemispherical, s planispheric, c cylindrical
    Vec3 vp{0, 0, 0};
    Vec3 vd{0, 1, 0};  // not necessarily unit: its length is the focal distance
    Vec3 vu{0, 0, 1};
    double vh = 45, vv = 45;
    double vo = 0, va = 0;  // fore and aft clipping distances, 0 = none
    double vs = 0, vl = 0;  // shift and lift, fractions of the picture
};
bool operator==(const View& a, const View& b);
inline bool operator!=(const View& a, const View& b) { return !(a == b); }

// -vp -vd -vu -vt -vh -vv -vo -va -vs -vl, and -vf with what is done with the file's view.
// default_text: where a view comes from without them, in place of v's own values.
void declare_options(base::OptionTable& table, View& v, const std::string& default_text = "");
void declare_file_option(base::OptionTable& table, std::function<void(const View&)> use);
// Applies every view option found in a header or view-file line (unknown words are skipped); true if there was one.
// One that cannot be read is skipped, too, and told in `wrong` (the first one; else empty).
bool parse_line(View& v, const std::string& line, std::string* wrong = nullptr);
// Lines that hold a view in headers and view files: VIEW= and the command lines of rpict, rvu and their kin.
bool is_view_line(const std::string& line);
// Last view of a view file or picture header; throws Error if there is none.  by: as for base::open_file().
View read_view_file(const std::string& path, const base::Opener& by = {});
// The same as rpict's -vf: options in the file override v, others stay.
void apply_view_file(View& v, const std::string& path, const base::Opener& by = {});
// Every view of a file ("-": the standard input), as rpict -S reads them: each line that holds a view changes the view
// before it, the first one `start`.  The name is the line's first word, if that is no option ("VIEW= desk -vta ...", or
// rad's "view= desk -vta ..."); else empty.
struct NamedView {
    std::string name;
    View view;
};
std::vector<NamedView> read_views(const std::string& path, const View& start);
// " -vta -vp 0 0 1.2 ..." as RADIANCE's programs write it after "VIEW=" (leading blank included), with as many
// digits as it takes to read the same view back.
std::string to_options(const View& v);

// Checks angles, up vector, clipping (throws Error with the offending option as place).
void validate(const View& v);
// Height over width of the picture plane.
double aspect(const View& v);
// Fits one side to the view's aspect as rpict does (-pa pixel_aspect; 0 keeps both sides).
void fit_size(const View& v, double pixel_aspect, int& nx, int& ny);

// A validated view with its basis vectors.
class Projector {
public:
    explicit Projector(const View& v);
    // dir unit; tmax 0 = unlimited (aft clipping else)
    struct Ray {
        Vec3 origin, dir;
        double tmax;
    };
    std::optional<Ray> ray(double X, double Y) const;  // none outside the image circle
    std::optional<Vec3> direction(double X, double Y) const;
    // Picture position of a direction (unit, from the view point at infinity); false if the view has no place for it.
    // The place may lie outside the picture, [0,1]^2.
    bool locate_direction(Vec3 dir, double& X, double& Y) const;
    const View& view() const { return view_; }
    Vec3 forward() const { return d_; }  // unit view direction
    Vec3 right() const { return h_; }    // unit, d x up
    Vec3 up() const { return u_; }       // unit, right x d
private:
    View view_;
    Vec3 d_, h_, u_;
    double sx_, sy_;  // scale of the picture plane: h and u coordinate per unit of x and y
    bool unnormalised(double X, double Y, Vec3& D) const;
    bool plane_of(double a, double b, double& X, double& Y) const;
};

// Solid angle (sr) of pixel (i,j), j from the bottom: the spherical quadrilateral of great circles through its four
// corners; 0 if a corner has no direction.
double pixel_solid_angle(const Projector& p, int i, int j, int nx, int ny);

}  // namespace view
