#pragma once
#include <span>
#include <string>
#include <string_view>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Which axis of a file points up, where the format does not say so.
struct UpGuess {
    UpAxis up = UpAxis::Z;
    std::string why{};  // the end of a sentence, as "it is tallest along y"; empty where nothing tells
};

// Of an OBJ file, by the first of these that tells: the program that its first comments name, an object named like a
// floor that is flat along y or z alone, a file that begins at 0 along one of y and z and lies on both sides of 0 along
// the other, a file that is taller along y or z than along both other axes by half. Else z.
UpGuess guessUp(std::string_view text, std::span<const Object> objects);

}  // namespace pipeline
