// SPDX-License-Identifier: BSD-3-Clause
// Tables from 380 to 780 nm: 401 values by 1 nm, 81 by 5 nm.  Their files say where they come from.
#pragma once

namespace spectrum {

extern const double action_sc[401], action_mc[401], action_lc[401], action_rh[401], action_mel[401], action_v[401];
extern const double daylight_s0[81], daylight_s1[81], daylight_s2[81];
extern const double light_f2[401], light_f7[401], light_f11[401], light_f12[401];
extern const double light_led_b1[81], light_led_b2[81], light_led_b3[81], light_led_b4[81], light_led_b5[81],
    light_led_bh1[81], light_led_rgb1[81], light_led_v1[81], light_led_v2[81];
extern const double primary_red[81], primary_blue[81];

}  // namespace spectrum
