// SPDX-License-Identifier: BSD-3-Clause
// Register machine for compiled .cal programs (lib/cal writes them).  Included after compat, vec.h, math.h,
// intersect.h. A program is a run of words in s->u from its entry to OP_END; jumps only go forward, so it always ends.
// An instruction: bits 0-6 operation, 7 "b is the next word, a float", 8-15 destination, 16-23 a, 24-31 b.
// Variables are in world coordinates: the program itself applies its primitive's transform.
// To add an operation: 1. a number here, 2. a case in cal_run, 3. cal/graph.cpp fold(), 4. cal/build.cpp.
#ifndef LUX_CAL_VM_H
#define LUX_CAL_VM_H
#include "kernels/cal/cal_vars.h"
#include "cal_noise.h"
#include "cal_data.h"

#define CAL_REGISTERS 96

// clang-format off
#define OP_END 0u
#define OP_OUT 1u        // out[d] = b
#define OP_MOV 2u        // d = b
#define OP_VAR 3u        // d = vars[a]
#define OP_ADD 4u
#define OP_SUB 5u
#define OP_RSUB 6u       // d = b - a
#define OP_MUL 7u
#define OP_DIV 8u        // 0 and an error when dividing by zero
#define OP_RDIV 9u       // d = b / a
#define OP_MIN 10u
#define OP_MAX 11u
#define OP_POW 12u
#define OP_RPOW 13u      // d = b ^ a
#define OP_NEG 14u
#define OP_SQRT 15u
#define OP_EXP 16u
#define OP_LOG 17u
#define OP_LOG10 18u
#define OP_SIN 19u
#define OP_COS 20u
#define OP_TAN 21u
#define OP_ASIN 22u
#define OP_ACOS 23u
#define OP_ATAN 24u
#define OP_ATAN2 25u
#define OP_FLOOR 26u
#define OP_CEIL 27u
#define OP_ERF 28u
#define OP_ERFC 29u
#define OP_RAND 30u
#define OP_SEL 31u       // next word: c; d = c > 0 ? a : b  (no immediate)
#define OP_JUMP_UNLESS 32u  // next word: distance; taken unless a > 0
#define OP_JUMP 33u      // next word: distance
#define OP_NOISE 34u     // a: first of 3 registers, b: 0 value, 1 2 3 slopes
#define OP_FNOISE 35u    // a: first of 3 registers
#define OP_DATA 36u      // a: first coordinate register, d: first of as many as channels; next word: table
#define OP_TEXT 37u      // a: x, b: row; next word: table
#define OP_CLEAR 38u     // forget errors
#define OP_FAIL 39u      // d = 0 and an error
#define OP_KEEP 40u      // d = error state
#define OP_RESTORE 41u   // error state = a
// clang-format on

// Runs a program; out gets its results.  Returns nonzero if the evaluation ended with an error (spec: scene
// language 5: the last library call or operator to fail), and the caller then ignores the pattern.
// Slack: acos and asin of 1 + 1e-5 and sqrt of -1e-6 are rounding, not errors.
FN int cal_run(TABLES(const SceneTables) s, uint entry, PRIVATE(const float) vars, PRIVATE(float) out) {
    float r[CAL_REGISTERS];
    int error = 0;
    uint pc = entry;

    for (;;) {
        uint word = s->u[pc++];
        uint op = word & 127u, d = (word >> 8) & 255u;
        float a = r[(word >> 16) & 255u], b, v = 0.0f;  // fields are below CAL_REGISTERS whatever they mean
        if (word & 128u) b = as_float_(s->u[pc++]);
        else b = r[word >> 24];
        // clang-format off
        switch (op) {
        case OP_END: return error;
        case OP_OUT: out[d] = b; continue;
        case OP_MOV: v = b; break;
        case OP_VAR: v = vars[(word >> 16) & 255u]; break;
        case OP_ADD: v = a + b; break;
        case OP_SUB: v = a - b; break;
        case OP_RSUB: v = b - a; break;
        case OP_MUL: v = a * b; break;
        case OP_DIV: if (b == 0.0f) error = 1; else v = a / b; break;
        case OP_RDIV: if (a == 0.0f) error = 1; else v = b / a; break;
        case OP_MIN: v = b < a ? b : a; break;
        case OP_MAX: v = b > a ? b : a; break;
        case OP_RPOW: v = a; a = b; b = v;  // fall through to the power
        /* fallthrough */
        case OP_POW:
            v = 0.0f;
            if ((a < 0.0f && floor_(b) != b) || (a == 0.0f && b < 0.0f)) { error = 1; break; }
            v = k_pow(a, b);
            if (!(fabs_(v) < 3.4e38f)) { error = 1; v = 0.0f; }
            break;
        case OP_NEG: v = -a; break;
        case OP_SQRT: if (a > 0.0f) v = sqrt_(a); else if (a < -1e-6f) error = 1; break;
        case OP_EXP: if (a > 88.7f) error = 1; else v = k_exp(a); break;
        case OP_LOG: if (a > 0.0f) v = k_log(a); else error = 1; break;
        case OP_LOG10: if (a > 0.0f) v = k_log10(a); else error = 1; break;
        case OP_SIN: v = k_sin(a); break;
        case OP_COS: v = k_cos(a); break;
        case OP_TAN: v = k_tan(a); break;
        case OP_ASIN: if (fabs_(a) > 1.00001f) error = 1; else v = k_asin(a); break;
        case OP_ACOS: if (fabs_(a) > 1.00001f) error = 1; else v = k_acos(a); break;
        case OP_ATAN: v = k_atan(a); break;
        case OP_ATAN2: v = k_atan2(a, b); break;
        case OP_FLOOR: v = floor_(a); break;
        case OP_CEIL: v = -floor_(-a); break;
        case OP_ERF: v = k_erf(a); break;
        case OP_ERFC: v = k_erfc(a); break;
        case OP_RAND: v = (float)cal_rand((cal_real)a); break;
        case OP_SEL: v = r[s->u[pc++]] > 0.0f ? a : b; break;
        case OP_JUMP_UNLESS: pc += (a > 0.0f ? 0u : s->u[pc]) + 1u; continue;
        case OP_JUMP: pc += s->u[pc] + 1u; continue;
        case OP_NOISE: {
            uint k = (word >> 16) & 255u;
            v = (float)cal_noise3_slope((cal_real)r[k], (cal_real)r[k + 1u], (cal_real)r[k + 2u], (int)(word >> 24));
            break;
        }
        case OP_FNOISE: {
            uint k = (word >> 16) & 255u;
            v = (float)cal_fnoise3((cal_real)r[k], (cal_real)r[k + 1u], (cal_real)r[k + 2u]);
            break;
        }
        case OP_DATA: cal_data(s, s->u[pc], r + ((word >> 16) & 255u), r + d); pc++; continue;
        case OP_TEXT: v = cal_text(s, s->u[pc], r[(word >> 16) & 255u], r[word >> 24]); pc++; break;
        case OP_CLEAR: error = 0; continue;
        case OP_KEEP: v = (float)error; break;
        case OP_RESTORE: error = r[(word >> 16) & 255u] != 0.0f; continue;
        default: error = 1; break;  // OP_FAIL
        }
        // clang-format on
        r[d] = v;
    }
}
#endif
