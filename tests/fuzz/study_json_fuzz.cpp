// Any bytes as a study file: what is read is written so that it reads back equal.
#include <cstdint>

#include "pipeline/export/json/study_json.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto study = pipeline::studyFromJson({reinterpret_cast<const char*>(data), size}, "study.json");
    if (!study) {
        fuzz::checkErrors(study.errors());
        return 0;
    }
    const std::string text = studyFileText(*study);
    const auto again = pipeline::studyFromJson(text, "study.json");
    fuzz::require(again && studyFileText(*again) == text);
    return 0;
}
