// Any bytes as an answer, as a condition and as numbers at every pixel: a finite value or an error with its column.
#include <cmath>
#include <cstdint>

#include "lessons/expression/changed_frames.h"
#include "lessons/expression/condition.h"
#include "pipeline/run/runner.h"
#include "tests/fuzz/small_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto scene = std::make_shared<const pipeline::Scene>(fuzz::smallScene());
    static const pipeline::FramePtr frame = [] {
        pipeline::FrameRequest request;
        request.wanted.set();
        return runFrame(scene, request, nullptr);
    }();
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // A changed frame may be of any size that a scene may have: the text is read, and left at that.
    const bool evaluates = text.find("with") == text.npos && text.find("differing") == text.npos;
    const lessons::Context context{.frame = *frame};
    if (const auto read = lessons::parseExpression(text, {"f", 1, 1}, {*scene}); !read) {
        fuzz::checkErrors(read.errors());
    } else if (evaluates) {
        if (const auto value = lessons::evaluate(*read, context))
            for (const double number : value->numbers) fuzz::require(std::isfinite(number));
    }
    if (const auto read = lessons::parseCondition(text, {"f", 1, 1}, {*scene}); !read) {
        fuzz::checkErrors(read.errors());
    } else if (evaluates) {
        if (const auto mask = lessons::maskOf(*read, context)) fuzz::require(mask->count <= mask->drawn);
    }
    if (const auto read = lessons::parseNumbers(text, {"f", 1, 1}, {*scene}); read && evaluates) {
        const auto numbers = lessons::numbersOf(*read, context);
        if (numbers) fuzz::require(numbers->count() == std::size_t(16 * 12));
    }
    return 0;
}
