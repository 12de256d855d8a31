// Any bytes as an exported picture that carries its scene.
#include <cstdint>

#include "pipeline/formats/png_scene.h"
#include "pipeline/scene/settings_table.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    pipeline::looksLikePng(bytes);
    pipeline::shownBuffer(bytes);
    pipeline::carriedState(bytes);
    const auto scene = pipeline::readPngScene({bytes, "p.png"}, [](std::string_view name) {
        return pipeline::Result<pipeline::NamedFile>(pipeline::Error{{}, "no file " + std::string(name)});
    });
    if (!scene)
        fuzz::checkErrors(scene.errors());
    else
        fuzz::require(pipeline::checkScene(*scene).empty());
    return 0;
}
