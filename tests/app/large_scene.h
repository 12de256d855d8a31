#pragma once
#include "tests/support/scenes.h"

namespace test {

// A sphere of 63,600 triangles, more than the window's thread looks at in one go.
inline Scene manyPolygons() {
    Scene scene = pyramid();
    scene.objects[0].mesh = sphere(150, 160, 200);
    return scene;
}

}  // namespace test
