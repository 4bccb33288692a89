// SPDX-License-Identifier: BSD-3-Clause
// See smooth_triangle.h.  tmesh.cal's arguments: the axis along which the triangle is projected, then for each
// component of the normal the coefficients of u, v and 1, (u, v) the two coordinates after the axis.
#include "generators/smooth_triangle.h"
#include <cmath>
#include "generators/generators.h"

namespace generators {

void write_smooth_triangle(std::string& out, const std::string& material, const std::string& name,
                           const std::array<base::Vec3, 3>& v, const std::array<base::Vec3, 3>& normal) {
    const base::Vec3 e1 = v[1] - v[0], e2 = v[2] - v[0], n = cross(e1, e2);
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (std::fabs(n[k]) > std::fabs(n[axis])) axis = k;
    const bool flat = n[axis] == 0;  // no area, no texture
    if (!flat) {
        const int iu = (axis + 1) % 3, iv = (axis + 2) % 3;
        out += "\n" + quoted(material) + " texfunc Phong\n4 dx dy dz tmesh.cal\n0\n10\t" + std::to_string(axis) + "\n";
        for (int k = 0; k < 3; k++) {  // Cramer's rule; the determinant is the normal's component along the axis
            const double d1 = normal[1][k] - normal[0][k], d2 = normal[2][k] - normal[0][k];
            const double a = (d1 * e2[iv] - d2 * e1[iv]) / n[axis], b = (d2 * e1[iu] - d1 * e2[iu]) / n[axis];
            out +=
                "\t" + number(a) + "\t" + number(b) + "\t" + number(normal[0][k] - a * v[0][iu] - b * v[0][iv]) + "\n";
        }
    }
    write_polygon(out, flat ? material : "Phong", name, {v[0], v[1], v[2]});
}

}  // namespace generators
