#pragma once
#include <span>
#include <string>
#include <string_view>

#include "pipeline/core/stop.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Which axis of a file points up, where the format does not say so.
struct UpGuess {
    UpAxis up = UpAxis::Y;
    std::string why;  // the end of a sentence, as "its comments name Blender"
};

// Of an OBJ or PLY file, by the first of these that tells: what its first comments say, or the program that they name; an
// object named like a floor that is flat along y or z alone; heights over a plane, thin along y or z alone; a file that
// begins at 0 along one of y and z and lies on both sides of 0 along the other two axes; a plate that is thin along z and
// lies around 0 along x and y. Else y, as in nearly all such files. text: begins with that of the file.
UpGuess guessUp(std::string_view text, std::span<const Object> objects, const Stop& stop = {});

}  // namespace pipeline
