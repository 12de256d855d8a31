#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/headless/command_host.h"
#include "pipeline/inspect/scanline.h"

namespace app {

// One of pixel, table, where, step, row and contracts is set; texts as the command's options take them.
struct InspectOptions {
    std::string pixel, table, step;
    std::optional<std::string> where;  // which may be empty by mistake
    std::optional<int> row;
    bool contracts = false;
    std::string format = "text";
    int threads = 0;
    bool json = false;
    std::function<std::string(const pipeline::ScanlineSection&)> plot{};  // as SVG; empty: nobody here draws it
};
// What `shadescope inspect` prints of a scene; gives its exit status.
int inspect(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options,
            const CommandHost& host);

}  // namespace app
