#pragma once
#include <memory>

#include "app/headless/command_host.h"
#include "app/headless/wanted_frame.h"

namespace app {

struct PlanOptions {
    FrameArgument frame;
    bool json = false, counts = false;
};
// What `shadescope plan` prints of a scene; gives its exit status.
int plan(const std::shared_ptr<const pipeline::Scene>& scene, const PlanOptions& options, const CommandHost& host);

}  // namespace app
