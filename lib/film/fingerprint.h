// SPDX-License-Identifier: BSD-3-Clause
// The fingerprint of a frame or a sum: all that decides its pixels besides seed and frame number, as named parts,
//     scene:0123456789abcdef view:0123456789abcdef options:0123456789abcdef estimator:1
// ptrace writes it (lib/render/fingerprint.h); what is summed or merged must have the same one.
#pragma once
#include <string>
#include "image/picture.h"

namespace film {

// Throws Error (place) that names the parts in which the two differ.  Warns if only one of them has a fingerprint.
// `of` names the other picture in the message.
void require_same_fingerprint(const image::Header& header, const image::Header& other, const std::string& place,
                              const std::string& of);

// Likewise for light weighted otherwise (ACTION=): a fingerprint may be missing.
void require_same_action(const image::Header& header, const image::Header& other, const std::string& place,
                         const std::string& of);

}  // namespace film
