#include "app/cli/watch.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "app/cli/cli.h"

namespace app {

std::string stateOfFiles(const std::vector<std::string>& paths, const std::string& own) {
    std::string state;
    std::error_code failed;
    const auto add = [&](const std::filesystem::path& file) {
        if (!own.empty() && std::filesystem::equivalent(file, own, failed)) return;
        const auto time = std::filesystem::last_write_time(file, failed);
        state += fmt::format("{} {} {}\n", file.string(), std::filesystem::file_size(file, failed),
                             time.time_since_epoch().count());
    };
    for (const std::string& path : paths) {
        if (!std::filesystem::is_directory(path, failed)) {
            add(path);
            continue;
        }
        for (std::filesystem::directory_iterator at(path, failed), end; !failed && at != end; at.increment(failed))
            if (at->is_regular_file(failed)) add(at->path());
    }
    return state;
}

int watch(const std::function<std::string()>& state, const std::function<void()>& again, const Interrupt& interrupt) {
    using namespace std::chrono_literals;
    std::string seen, before;
    while (!interrupt.asked()) {
        const std::string now = state();
        if (now != seen && now == before) {
            seen = now;
            again();
            std::fflush(stdout);
        }
        before = now;
        std::this_thread::sleep_for(200ms);
    }
    return kInterrupted;
}

}  // namespace app
