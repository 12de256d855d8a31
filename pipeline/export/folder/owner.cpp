#include "pipeline/export/folder/owner.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>

namespace pipeline {

namespace {

constexpr std::string_view kStart = ".shadescope.part-";

// Letters and digits alone, so that the parts of a name can be told from each other.
std::string hostName() {
    std::array<char, 65> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
    std::string host = name.data();
    const auto isPlain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    };
    std::ranges::replace_if(
        host, [&](char c) { return !isPlain(c); }, '_');
    return host;
}

// Field 22 of /proc/PID/stat (proc(5)); the second may hold spaces and parentheses. Nothing where it cannot be read.
std::optional<std::string> startOf(long pid) {
    std::ifstream in(fmt::format("/proc/{}/stat", pid));
    std::string text(std::istreambuf_iterator<char>(in), {});
    const auto second = text.rfind(')');
    if (second == text.npos) return std::nullopt;
    std::string_view rest = std::string_view(text).substr(second + 1);
    constexpr int kFieldsBefore = 20;  // 3 to 21, and the space before them
    for (int i = 0; i < kFieldsBefore; ++i) {
        const auto space = rest.find(' ');
        if (space == rest.npos) return std::nullopt;
        rest.remove_prefix(space + 1);
    }
    return std::string(rest.substr(0, rest.find(' ')));
}

}  // namespace

std::string hiddenName(int number) {
    return fmt::format("{}{}-{}-{}-{}", kStart, hostName(), ::getpid(), startOf(::getpid()).value_or("0"), number);
}

bool isLeftover(std::string_view name) {
    if (!name.starts_with(kStart)) return false;
    std::array<std::string_view, 4> parts;  // host, process, start, number
    name.remove_prefix(kStart.size());
    for (std::string_view& part : parts) {
        part = name.substr(0, name.find('-'));
        name.remove_prefix(std::min(name.size(), part.size() + 1));
    }
    if (parts[3].empty()) return false;
    pid_t pid = 0;
    const auto [end, error] = std::from_chars(parts[1].data(), parts[1].data() + parts[1].size(), pid);
    if (!name.empty() || error != std::errc() || end != parts[1].data() + parts[1].size() || pid <= 0) return false;
    if (parts[0] != hostName()) return false;
    if (::kill(pid, 0) != 0 && errno == ESRCH) return true;
    // There is such a process: a later one, which has taken the number over, has started at another time.
    const auto start = startOf(pid);
    return start && parts[2] != "0" && *start != parts[2];
}

}  // namespace pipeline
