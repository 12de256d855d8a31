// Any bytes as a scene of lecture 1, or as an object that it names: whatever they are, there is a
// scene that keeps its promises, or there are errors that point into the text.
#include <cstdint>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input({reinterpret_cast<const char*>(data), size});
    pipeline::looksLikeLectureScene(input.text);
    pipeline::looksLikeLectureObject(input.text);
    for (const auto read : {pipeline::readLectureScene, pipeline::readLectureObject}) {
        const pipeline::Result<pipeline::Scene> scene = read({input.text, "scene"}, input.loader());
        if (!scene) {
            fuzz::checkErrors(scene.errors());
            continue;
        }
        for (const pipeline::Object& part : scene->objects) fuzz::checkMesh(*part.mesh);
    }
    return 0;
}
