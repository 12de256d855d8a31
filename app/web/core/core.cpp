#include "app/web/core/core.h"

#include <cstdlib>

#include "pipeline/export/json/frame_json.h"

namespace web {

namespace {

std::string s_answer;

}  // namespace

LiveCore& core() {
    static LiveCore one;
    return one;
}

std::string_view textAt(const char* start, int size) { return {start, std::size_t(size)}; }

int give(const Json& json) {
    s_answer = json.dump();
    return 1;
}

int giveText(std::string text) {
    s_answer = std::move(text);
    return 1;
}

int refuse(const pipeline::Errors& errors) {
    give(errorsToJson(errors));
    return 0;
}
int refuse(std::string found) { return refuse({pipeline::Error{{}, std::move(found), {}}}); }

const std::string& answer() { return s_answer; }

void take(pipeline::Scene scene) { core().own.scene = std::make_shared<const pipeline::Scene>(std::move(scene)); }

pipeline::BufferSet shownAlways() {
    using pipeline::BufferId;
    return pipeline::setOf(
        {BufferId::Color, BufferId::PolygonId, BufferId::ObjectId, BufferId::VerticesWorld, BufferId::VerticesScreen});
}

void runOwn(bool fresh) {
    ShownScene& own = core().own;
    if (const auto& open = core().lesson; !fresh && !own.frame && open && open->half->sharedScene() == own.scene &&
                                          (core().wanted & ~open->half->wanted()).none()) {
        own.frame = open->half;
        return;
    }
    pipeline::FrameRequest request;
    request.wanted = core().wanted;
    request.threads = 1;
    own.frame = runFrame(own.scene, request, fresh ? pipeline::FramePtr() : own.frame);
    own.steps.reset(), own.atMoment.reset();
}

WEB_CALL(alloc) void* webAlloc(int size) { return std::malloc(std::size_t(size)); }
WEB_CALL(release) void webRelease(void* memory) { std::free(memory); }
WEB_CALL(text) const char* webText() { return s_answer.data(); }
WEB_CALL(size) int webSize() { return int(s_answer.size()); }

}  // namespace web
