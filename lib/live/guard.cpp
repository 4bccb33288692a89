// SPDX-License-Identifier: BSD-3-Clause
// See guard.h.
#include "live/guard.h"

#include <sys/random.h>

#include <cerrno>

#include "base/error.h"

namespace live {

std::string new_token() {
    unsigned char bytes[16];
    errno = 0;
    if (getentropy(bytes, sizeof bytes) != 0) base::fail_system("random numbers", "none");
    std::string token;
    for (const unsigned char b : bytes) {
        token += "0123456789abcdef"[b >> 4];
        token += "0123456789abcdef"[b & 15];
    }
    return token;
}

bool same_secret(const std::string& a, const std::string& b) {
    unsigned char differ = a.size() != b.size();
    for (size_t k = 0; k < a.size() && k < b.size(); ++k) differ |= (unsigned char)(a[k] ^ b[k]);
    return differ == 0;
}

bool is_loopback_host(const std::string& host) {
    std::string name = host;
    const size_t bracket = name.find(']'), colon = name.rfind(':');
    if (colon != std::string::npos && (bracket == std::string::npos || colon > bracket)) {
        const std::string port = name.substr(colon + 1);
        if (port.empty() || port.size() > 5 || port.find_first_not_of("0123456789") != std::string::npos) return false;
        name.resize(colon);
    }
    return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

bool is_own_origin(const std::string& origin, const std::string& host) {
    return origin.empty() || origin == "http://" + host;
}

}  // namespace live
