#pragma once
#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "app/headless/exit_status.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace app {

// What a command finds around it. The program gives it a terminal, the core of the page texts that the page or Node
// prints: so both say the same.
struct CommandHost {
    std::function<void(std::string_view)> out;       // what was asked for
    std::function<void(std::string_view)> messages;  // all else
    // One line an error, among the messages.
    std::function<void(const pipeline::Errors&)> tellErrors;
    // Whether such a frame fits into memory. If not, the reason was told and the status was set.
    std::function<bool(const pipeline::Scene&, const pipeline::FrameRequest&, int& status)> fits;
    pipeline::Stop stop{};

    template <class... Args>
    void say(fmt::format_string<Args...> text, Args&&... args) const {
        out(fmt::format(text, std::forward<Args>(args)...));
    }
    template <class... Args>
    void tell(fmt::format_string<Args...> text, Args&&... args) const {
        messages(fmt::format(text, std::forward<Args>(args)...));
    }
    int refuse(const pipeline::Errors& errors, int status) const {
        tellErrors(errors);
        return status;
    }
    int cancelled() const {
        tell("Cancelled.\n");
        return kInterrupted;
    }
};

}  // namespace app
