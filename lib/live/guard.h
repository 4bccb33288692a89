// SPDX-License-Identifier: BSD-3-Clause
// Who may ask (docs/security.md): other users of the machine and pages of other sites may reach the port, too.
#pragma once
#include <string>

namespace live {

// 128 random bits in hex.
std::string new_token();

// The same text, told in a time that does not depend on where they differ.
bool same_secret(const std::string& a, const std::string& b);

// A name of this machine's loopback, with any port (ssh -L): "localhost:8080", "127.0.0.1", "[::1]:9".
bool is_loopback_host(const std::string& host);

// The Origin header of a request that the page itself sends to this host; absent (empty) for plain navigation.
bool is_own_origin(const std::string& origin, const std::string& host);

}  // namespace live
