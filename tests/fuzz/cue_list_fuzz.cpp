// Any bytes as a list of cues, and so as the states in it: what is read is written so that it reads back equal.
#include <cstdint>

#include "lessons/state/cue_list.h"
#include "lessons/state/cue_text.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto list = lessons::readCues(text, "talk.cues");
    if (!list) {
        fuzz::checkErrors(list.errors());
        return 0;
    }
    for (const std::string& written : {toToml(*list), cueText(*list, text, *list)}) {
        const auto again = lessons::readCues(written, "talk.cues");
        fuzz::require(again && *again == *list);
    }
    return 0;
}
