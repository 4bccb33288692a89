// SPDX-License-Identifier: BSD-3-Clause
// Opens the page in the user's browser.  The secret of the address would be in the list of processes, so the browser is
// given a file that only this user can read and that leads there; it goes with the object.
#pragma once
#include <string>

namespace live {

class BrowserPage {
public:
    explicit BrowserPage(const std::string& link);  // warns where there is no browser
    ~BrowserPage();
    BrowserPage(const BrowserPage&) = delete;

private:
    std::string path_;
};

}  // namespace live
