// SPDX-License-Identifier: BSD-3-Clause
// Our own texts of the library files that scenes name, written from the published formulas:
// skies (CIE clear, intermediate, overcast; Perez et al. 1993; ISO 15469), luminaires, smooth meshes, glazings.
// A file of the same name on RAYPATH is taken instead.  Skies blend into the ground by a = (Dz + 1.01)^10 as
// (a sky + ground/a)/(a + 1/a), here with weight = a a.
#include "cal/library.h"

namespace cal {

namespace {

// A1 type, A2 zenith, A3 ground, A4 normalisation, A5-7 sun.
const char skybright[] = R"CAL(
weight = (Dz + 1.01)^20;
skybr = (weight*sky + A3)/(weight + 1);
cosgamma = Dx*A5 + Dy*A6 + Dz*A7;
gamma = Acos(cosgamma);
sky = select(A1, clear, overcast, A2, intermediate);
clear = A2*(.91 + 10*exp(-3*gamma) + .45*cosgamma*cosgamma)*if(Dz - .01, 1 - exp(-.32/Dz), 1)/A4;
overcast = A2*(1 + 2*Dz)/3;
zt = Acos(A7);
eta = Acos(Dz);
intermediate = A2*((1.35*sin(5.631 - 3.59*eta) + 3.12)*sin(4.396 - 2.6*zt) + 6.37 - eta)/2.326
             * exp(-.563*gamma*((2.629 - eta)*(1.562 - zt) + .812))/A4;
)CAL";

// A1 norm, A2 ground, A3-7 Perez' a b c d e, A8-10 sun.
const char perezlum[] = R"CAL(
weight = (Dz + 1.01)^20;
skybright = (weight*sky + A2)/(weight + 1);
cosgamma = Dx*A8 + Dy*A9 + Dz*A10;
gamma = Acos(cosgamma);
sky = A1*(1 + A3*Exp(A4/if(Dz - .01, Dz, .01)))*(1 + A5*Exp(A6*gamma) + A7*cosgamma*cosgamma);
)CAL";

// As perezlum.cal, and A11 clearness, A12-22 daylight locus: chromaticity from the sky's luminance.
const char perezlum_c[] = R"CAL(
weight = (Dz + 1.01)^20;
lum = (weight*sky + A2)/(weight + 1);
cosgamma = Dx*A8 + Dy*A9 + Dz*A10;
gamma = Acos(cosgamma);
sky = A1*(1 + A3*Exp(A4/if(Dz - .01, Dz, .01)))*(1 + A5*Exp(A6*gamma) + A7*cosgamma*cosgamma);
cct = if(1.065 - arg(11), 6191, 1e6/(-180.956 + 78.648*log10(lum)));
it = 1/cct;
locus(a, b, c, d) = d + it*(c + it*(b + it*a));
x = if(cct - 7000, locus(arg(16), arg(17), arg(18), arg(19)), locus(arg(12), arg(13), arg(14), arg(15)));
y = arg(22) + x*(arg(21) + x*arg(20));
X = lum*x/y;
Z = lum*(1 - x - y)/y;
skybright_r = 2.5693*X - 1.1668*lum - .3984*Z;
skybright_g = -1.0221*X + 1.9783*lum + .0438*Z;
skybright_b = -.0747*X - .2519*lum + 1.1772*Z;
)CAL";

// A1 level, A2-6 a b c d e of ISO 15469, A7-9 sun; traditional: A1 zenith.  Black below the horizon.
const char ciesky[] = R"CAL(
cosgamma = Dx*A7 + Dy*A8 + Dz*A9;
gradation = 1 + A2*Exp(A3/Dz);
indicatrix = 1 + A4*(Exp(A5*Acos(cosgamma)) - Exp(A5*PI/2)) + A6*cosgamma*cosgamma;
ciesky = if(Dz, A1*gradation*indicatrix, 0);
traditional = if(Dz, A1*(1 + 2*Dz)/3, 0);
)CAL";

const char source[] = R"CAL(
corr(v) = source_corr(v, 0);
flatcorr(v) = source_corr(v, 1);
boxcorr(v) = source_corr(v, 2);
lboxcorr(v) = source_corr(v, 3);
cylcorr(v) = source_corr(v, 4);
src_theta = source_theta(180);
src_phi = source_phi(360);
src_phi2 = source_phi(180);
src_phi4 = source_phi(90);
srcB_vert = Atan2(-Dx, Dz)/DEGREE;
srcB_horiz = Atan2(Dy, Dz)/DEGREE;
srcB_vert2 = abs(srcB_vert);
srcB_horiz2 = abs(srcB_horiz);
)CAL";

// A1 axis left out (0 x, 1 y, 2 z), then three planes over the two other coordinates.
const char tmesh[] = R"CAL(
bu = select(A1 + 1, Py, Pz, Px);
bv = select(A1 + 1, Pz, Px, Py);
v1 = bu*A2 + bv*A3 + A4;
v2 = bu*A5 + bv*A6 + A7;
v3 = bu*A8 + bv*A9 + A10;
len = sqrt(v1*v1 + v2*v2 + v3*v3);
dx = v1/len - Nx;
dy = v2/len - Ny;
dz = v3/len - Nz;
u = frac(v1);
v = frac(v2);
)CAL";

// A1 axis as in tmesh.cal; displacement = a bilinear form of the two other coordinates.
const char surf[] = R"CAL(
su = select(A1 + 1, Py, Pz, Px);
sv = select(A1 + 1, Pz, Px, Py);
form(a, b, c, d) = (a*su + c)*sv + b*su + d;
surf_dx = form(A2, A5, A8, arg(11));
surf_dy = form(A3, A6, A9, arg(12));
surf_dz = form(A4, A7, A10, arg(13));
)CAL";

const char rev[] = R"CAL(
radius = sqrt(Px*Px + Py*Py);
slope = radius*A3 + A4;
rev_dx = slope*Px/radius;
rev_dy = slope*Py/radius;
rev_dz = Pz*A1 + A2;
)CAL";

const char illum[] = R"CAL(
turn(a) : if(a, a, a + 2*PI);
axis(i) = D(1)*arg(i) + D(2)*arg(i + 1) + D(3)*arg(i + 2);
il_alt = Dz;
il_azi = turn(Atan2(Dy, Dx));
il_alth = axis(7)*axis(7);
il_azih = turn(Atan2(-axis(4), -axis(1)));
)CAL";

const char glaze1[] = R"CAL(
F = exp(-5.85*abs(Rdot)) - exp(-5.85);
more(r) = r + F*(1 - r);
less(t) = t*(1 - F);
clear_side = A10*Rdot;
sr_clear_r = more(if(clear_side, arg(11), arg(14)));
sr_clear_g = more(if(clear_side, arg(12), arg(15)));
sr_clear_b = more(if(clear_side, arg(13), arg(16)));
st_clear_r = less(arg(17));
st_clear_g = less(arg(18));
st_clear_b = less(arg(19));
frit = if(clear_side, 1, 1 - arg(11))*more(.076);
sr_frit_r = frit; sr_frit_g = frit; sr_frit_b = frit;
frit_t = (1 - arg(11))*less(.883);
st_frit_r = frit_t; st_frit_g = frit_t; st_frit_b = frit_t;
)CAL";

const char glaze2[] = R"CAL(
F = exp(-5.85*abs(Rdot)) - exp(-5.85);
fr(r) = r + F*(1 - r);
ft(t) = t*(1 - F);
rclr = fr(.076);
tclr = ft(.883);
cr(rf, t, rb) = rf + t*t*rb;
)CAL";

// Triple glazing: A10-12 reflectance in front, A13-15 behind, A16-18 transmittance.
const char glass3[] = R"CAL(
F = exp(-2.5*abs(RdotP)) - exp(-2.5);
side(a, b) = if(Rdot, a, b);
sr(s) = s + (1 - s)*F;
s_r = side(A10, arg(13)); s_g = side(arg(11), arg(14)); s_b = side(arg(12), arg(15));
sr_red = sr(s_r); sr_grn = sr(s_g); sr_blu = sr(s_b);
st_red = s_r + CrP*arg(16) - sr_red;
st_grn = s_g + CgP*arg(17) - sr_grn;
st_blu = s_b + CbP*arg(18) - sr_blu;
)CAL";

const struct {
    const char* name;
    const char* text;
} files[] = {
    {"skybright.cal", skybright}, {"perezlum.cal", perezlum}, {"perezlum_c.cal", perezlum_c},
    {"ciesky.cal", ciesky},       {"source.cal", source},     {"tmesh.cal", tmesh},
    {"surf.cal", surf},           {"rev.cal", rev},           {"illum.cal", illum},
    {"glaze1.cal", glaze1},       {"glaze2.cal", glaze2},     {"glass3.cal", glass3},
};

}  // namespace

const char* builtin_file(const std::string& name) {
    for (const auto& f : files)
        if (name == f.name) return f.text;
    return nullptr;
}

}  // namespace cal
