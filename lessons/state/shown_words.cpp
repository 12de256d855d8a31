#include "lessons/state/shown_words.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace lessons {

std::optional<SpaceWords> parseSpace(std::string_view words) {
    constexpr std::string_view kLight = "light ";
    if (!words.starts_with(kLight)) {
        const auto found = std::ranges::find(kSpaceNames, words);
        if (found == kSpaceNames.end() || words == "light") return {};
        return SpaceWords{std::size_t(found - kSpaceNames.begin())};
    }
    SpaceWords light{std::size_t(std::ranges::find(kSpaceNames, "light") - kSpaceNames.begin())};
    words.remove_prefix(kLight.size());
    if (const auto space = words.find(' '); space != words.npos) {
        const auto face = std::ranges::find(kFaceNames, words.substr(space + 1));
        if (face == kFaceNames.end()) return {};
        light.face = int(face - kFaceNames.begin());
        words = words.substr(0, space);
    }
    const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), light.light);
    const bool whole = error == std::errc() && end == words.data() + words.size() && light.light >= 0;
    return whole ? std::optional(light) : std::nullopt;
}

}  // namespace lessons
