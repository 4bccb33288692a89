// SPDX-License-Identifier: BSD-3-Clause
// See browser.h.
#include "live/browser.h"

#include <unistd.h>

#include <cstdlib>

#include "base/child.h"
#include "base/descriptor.h"
#include "base/error.h"

namespace live {

BrowserPage::BrowserPage(const std::string& link) {
    const char* folder = std::getenv("TMPDIR");
    path_ = std::string(folder ? folder : "/tmp") + "/luxpipe-XXXXXX.html";
    const int fd = mkstemps(path_.data(), 5);  // readable by its owner alone
    const std::string text = "<meta http-equiv=\"refresh\" content=\"0;url=" + link + "\">\n";
    const bool written = fd >= 0 && base::write_all(fd, text.data(), text.size());
    if (fd >= 0) close(fd);
    pid_t pid = -1;
    if (!written || base::start_child({"xdg-open", path_}, {-1, 2, 2}, pid) != 0)
        base::warn("-open", "the browser cannot be started by xdg-open");
}

BrowserPage::~BrowserPage() { unlink(path_.c_str()); }

}  // namespace live
