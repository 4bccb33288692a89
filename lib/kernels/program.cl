// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL program: the device's words, the shared code, the entries.
#include "kernels/compat_opencl.h"
#include "kernels/all.h"
#include "kernels/entry_words.cl"
#ifdef LUX_CHAINS  // the program beside another one's that walks no chains (CHAINS_APART)
#include "kernels/entry_chains.cl"
#else
#include "kernels/entry.cl"
#endif
