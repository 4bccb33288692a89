// SPDX-License-Identifier: BSD-3-Clause
// Windows' C runtime has another last bit than glibc for 6 to 8 of 100 arguments of these, mingw-w64's functions of 64
// bits of mantissa for 1 in 1,000.  The linker takes these: they stand before the system's.
#include <cmath>

extern "C" {

double acos(double x) { return double(acosl(x)); }
double asin(double x) { return double(asinl(x)); }
double atan(double x) { return double(atanl(x)); }

}  // extern "C"
