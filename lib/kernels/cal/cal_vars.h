// SPDX-License-Identifier: BSD-3-Clause
// Variables and limits of a compiled .cal program (cal_vm.h).
#ifndef LUX_CAL_VARS_H
#define LUX_CAL_VARS_H

#define CAL_OUTPUTS 10

// clang-format off
// Indices of the variables a program may read (all set by the caller).
enum {
    CAL_DX, CAL_DY, CAL_DZ,          // ray direction, unit
    CAL_NX, CAL_NY, CAL_NZ,          // unperturbed normal as oriented
    CAL_PX, CAL_PY, CAL_PZ,          // point
    CAL_T, CAL_TS,                   // path length from the eye; of this ray and its shadow ancestors
    CAL_RDOT,                        // -D.N
    CAL_LU, CAL_LV,                  // mesh coordinates
    CAL_NXP, CAL_NYP, CAL_NZP, CAL_RDOTP,  // perturbed normal, function materials
    CAL_CRP, CAL_CGP, CAL_CBP,       // material colour with patterns
    CAL_DXA, CAL_DYA, CAL_DZA,       // prisms: direction to the source aimed at
    CAL_LX, CAL_LY, CAL_LZ,          // $101 $102 $103: light direction given to a BRDF function
    CAL_OMEGA,                       // $104: its solid angle
    CAL_ARG0, CAL_ARG1, CAL_ARG2, CAL_ARG3, CAL_ARG4, CAL_ARG5, CAL_ARG6, CAL_ARG7,  // $105.. : free arguments
    CAL_VARS
};
// clang-format on
#endif
