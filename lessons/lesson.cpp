#include "lessons/lesson.h"

#include <algorithm>

#include "lessons/derived_buffer.h"
#include "pipeline/run/runner.h"

namespace lessons {

namespace {

pipeline::FrameRequest requestFor(const Half& half) {
    pipeline::FrameRequest request;
    const pipeline::Scene& scene = half.state.scene;
    const auto mix = pipeline::parseMix(half.state.window.mix, scene.lights.size());
    const DerivedRecipe recipe{half.state.window.condition, mix ? *mix : pipeline::TermMix()};
    for (const pipeline::BufferName& buffer : shownBuffers(half.state)) {
        if (!pipeline::isDerived(buffer.id))
            request.wanted.set(index(buffer.id));
        else if (const auto needed = buffersFor(buffer, recipe, scene))
            request.wanted |= *needed;
    }
    request.wanted |= buffersOf(half.text) | buffersOf(half.paper) | buffersOf(half.held);
    return request;
}

}  // namespace

std::size_t returningPages(const Lesson& lesson) {
    return std::size_t(std::ranges::count_if(lesson.pages, [](const Page& page) { return page.from.has_value(); }));
}

std::string pageName(const Lesson& lesson, std::size_t index) {
    if (const auto& from = lesson.pages[index].from) return from->lesson + '/' + std::to_string(from->page);
    return std::to_string(index + 1 - returningPages(lesson));
}

const std::filesystem::path& folderOf(const Lesson& lesson, const Page& page) {
    return page.from ? page.from->folder : lesson.folder;
}

std::vector<pipeline::BufferName> shownBuffers(const PageState& state) {
    std::vector<pipeline::BufferName> buffers;
    for (const BufferShown& view : state.window.views)
        if (const auto buffer = pipeline::findAnyBuffer(view.buffer)) buffers.push_back(*buffer);
    return buffers;
}

std::optional<glm::ivec2> pickedPixel(const PageState& state) {
    const auto& pixel = state.window.pixel;
    return pixel ? std::optional(glm::ivec2((*pixel)[0], (*pixel)[1])) : std::nullopt;
}

pipeline::FrameRequest requestFor(const Page& page) {
    pipeline::FrameRequest request = requestFor(page.first);
    if (!page.question) return request;
    for (const Expression* expression : expressionsOf(*page.question)) request.wanted |= expression->buffers;
    for (const Prose* text : textsOf(*page.question)) request.wanted |= buffersOf(*text);
    return request;
}

pipeline::FrameRequest requestForThen(const Page& page) { return requestFor(*page.then); }

bool runPages(const Lesson& lesson, const pipeline::Stop& stop, const PageVisit& visit) {
    pipeline::FramePtr frame;  // what the next half has in common with it need not run again
    const auto run = [&](const Half& half, pipeline::FrameRequest request) {
        request.stop = stop;
        return frame = runFrame(std::make_shared<const pipeline::Scene>(half.state.scene), request, frame);
    };
    for (std::size_t number = 0; number < lesson.pages.size(); ++number) {
        const Page& page = lesson.pages[number];
        PageFrames frames{run(page.first, requestFor(page)), {}};
        if (frames.first && page.then) frames.then = run(*page.then, requestForThen(page));
        if (frames.first && (frames.then || !page.then)) visit(page, number, frames);
        if (stop.stop_requested()) return false;
    }
    return true;
}

}  // namespace lessons
