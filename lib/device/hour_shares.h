// SPDX-License-Identifier: BSD-3-Clause
// The shares of paths in the light of suffix vertices, for many hours (kernels/integrator/hours.h): one code for all
// devices.
#pragma once
#include "kernels/dialect/host.h"
#include "device/hour_paths.h"

namespace device {

// Weighs what the paths of a square get of their suffix vertices: `found` has, for each of so many rounds, path and
// member, the words of path_share_of_suffix().  A suffix vertex counts by one over the sum of the pdfs with which all
// that it meets would have found it.  Appends the paths' shares to `out`, and adds to rad the light of suffix_rad.
void weigh_shares(uint32_t rounds, const kernels::float4* found, const kernels::float4* suffix_rad,
                  kernels::float4* rad, HourPaths& out);

}  // namespace device
