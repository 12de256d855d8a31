#pragma once
#include <glm/vec2.hpp>

#include "pipeline/scene/scene.h"

// What the program adds to a model that is opened by itself: where it stands, a camera, a light, and the illumination
// model that reads what its materials bring.
namespace pipeline {

// Puts the middle of the objects' common box, which nothing moves yet, into the world's origin, and adds a light and a
// camera that shows all of them from their front; the scene is framed then. What a reader could not know the remarks say;
// one about "KEY=VALUE" says what was chosen, and counts while the setting has that value (plan/scene_remarks.h).
//
// The front of a file with y up faces +z (glTF 2.0, section 3.4), here -y: the camera stands at θ = -45°, else at 45° as in
// lecture 1's example, with φ = 60°. Where less than a quarter of the projected area faces it there, as of an open mesh
// seen from behind, it stands at the first of the other three quarters, then of the four from below, at which most does.
void frameModel(Scene& scene);

// The axis that points up, of all objects of a framed scene: the middle of the file stays where it is. A camera and a
// light that the program has chosen are chosen anew.
void setUp(Scene& scene, UpAxis up);
UpAxis upOf(const Scene& scene);

// The picture's size, pixels. A framed scene's screen distance follows, as long as it is the one that shows all of it.
void setSize(Scene& scene, glm::ivec2 size);

}  // namespace pipeline
