#pragma once
#include <string>
#include <vector>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/text/tally.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Materials of an MTL file (Wavefront, Object Files, 1995, appendix B1):
//   Kd diffuse, Ka ambient, Ks specular, Ns exponent, Ke emission, d opacity, Tr 1 - d. The rest is left out.
struct NamedMaterial {
    std::string name;  // may be empty
    Material material;
};

// What files of materials have and the reader leaves out or treats otherwise.
struct MtlTallies {
    CaseTally wrongNumbers, beforeFirst, otherColors, halos, pictures, blackPictures, opacityTr;
    void say(std::vector<Remark>& remarks) const;
};

// Appends the file's materials; a wrong coefficient keeps its default. Errors: where reading was given up.
//
// Programs disagree on Tr: some write the opacity. It is read so where the file gives d and an equal Tr, and where d is
// not given at all, some Tr is 1 and none 0: a file that draws nothing is not what its author saw.
void readMtl(const SourceText& source, std::vector<NamedMaterial>& materials, MtlTallies& tallies, Errors& errors);

}  // namespace pipeline
