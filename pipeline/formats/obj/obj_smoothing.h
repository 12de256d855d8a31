#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/formats/obj/obj_file.h"

namespace pipeline {

// Gives the corners of the groups without normals of their own those that smoothing groups make: at each position the
// sum of the unit normals of the faces around it that have the same smoothing group, across objects too, at length 1; at
// corners without one, and where that sum vanishes, the normal of the face. Appends them to file.normals.
// Once stopped, what it leaves is of no use.
void smoothNormals(ObjFile& file, StopCheck& check);

}  // namespace pipeline
