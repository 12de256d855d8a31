// Any bytes as a model of the format SHADESCOPE_EXTENSION; in a text format what follows a zero
// byte is every file that the model names.
#include <algorithm>
#include <cstdint>
#include <sstream>

#include "pipeline/formats/model_reader.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view extension = SHADESCOPE_EXTENSION;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const fuzz::Input input(bytes);
    const std::string_view text = extension == ".obj" ? input.text : bytes;
    const auto model = pipeline::readModel({text, "m"}, extension, input.loader());
    // A file that is read piece by piece says the same. What tells an STL file's form stands in its beginning.
    const std::size_t start = std::min<std::size_t>(text.size(), 600);
    const auto tail = std::make_shared<pipeline::FileTail>(
        std::make_unique<std::istringstream>(std::string(text.substr(start))), text.size() - start, 7);
    const auto inPieces = pipeline::readModel({text.substr(0, start), "m", {}, tail}, extension, input.loader());
    fuzz::require(bool(model) == bool(inPieces));
    if (!model) fuzz::require(model.errors() == inPieces.errors());
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
