// Any bytes as a model of the format SHADESCOPE_EXTENSION; in a text format what follows a zero
// byte is every file that the model names.
#include <cstdint>

#include "pipeline/formats/model_reader.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view extension = SHADESCOPE_EXTENSION;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const fuzz::Input input(bytes);
    const std::string_view text = extension == ".obj" ? input.text : bytes;
    const auto model = pipeline::readModel({text, "m"}, extension, input.loader());
    if (!model) {
        fuzz::checkErrors(model.errors());
        return 0;
    }
    fuzz::require(!model->objects.empty());
    for (const pipeline::Object& object : model->objects) {
        fuzz::require(object.mesh->polygonCount() > 0);
        fuzz::checkMesh(*object.mesh);
        fuzz::checkMaterial(object.material);
    }
    return 0;
}
