#pragma once
#include <string>
#include <vector>

#include "app/headless/command_host.h"

namespace app {

struct CheckOptions {
    std::vector<std::string> cases, groups;  // ids and names; both empty: all
    int threads = 0;
    bool json = false, list = false;
};
// What `shadescope check` prints; gives its exit status.
int check(const CheckOptions& options, const CommandHost& host);

}  // namespace app
