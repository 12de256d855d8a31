#pragma once
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Gives every object a name of its own: two of one name become "sphere" and "sphere 2".
void tellApart(std::vector<Object>& objects);

}  // namespace pipeline
