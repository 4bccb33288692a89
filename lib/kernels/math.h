// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions in float, the same bits on every device (built-in ones differ, and PoCL's are slow).
// Accuracy is tested against double: a few ulp over the ranges shading uses.
#ifndef LUX_MATH_H
#define LUX_MATH_H
// k_exp k_log k_pow k_sincos k_sin k_cos k_tan k_asin k_acos k_atan k_atan2 k_log10
#endif
