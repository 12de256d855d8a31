// Any bytes as a file of materials.
#include <cstdint>

#include "pipeline/formats/obj/mtl_reader.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<pipeline::NamedMaterial> materials;
    pipeline::MtlTallies tallies;
    pipeline::Errors errors;
    pipeline::readMtl({{reinterpret_cast<const char*>(data), size}, "m.mtl"}, materials, tallies, errors);
    if (!errors.empty()) fuzz::checkErrors(errors);
    for (const pipeline::NamedMaterial& named : materials) fuzz::checkMaterial(named.material);
    return 0;
}
