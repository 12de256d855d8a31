#pragma once
#include <string>
#include <vector>

#include "pipeline/study/study.h"

// Studies with known numbers, made without running one.
namespace test {

using namespace pipeline;

// A point that took `milliseconds`, in 21 samples of one process whose median it is, and which has
// this RMSE of the intensity as its model error. The samples lie evenly within ±spread of the
// median (relative).
StudyPoint studyPoint(std::size_t number, std::vector<std::string> values, double milliseconds, double error,
                      double spread = 0.01);

// Sphere, 512 × 512, shading by tessellation: errors and times as were once measured with another
// program; Gouraud at its finest failed. Its polygons' edges halve where the tessellation doubles.
//   tessellation   4              16             64             128
//   flat       0.59  4.2e-2   0.79  1.1e-2   3.26  2.7e-3   10.6  1.3e-3
//   gouraud    0.72  2.4e-2   0.86  2.1e-3   3.00  1.6e-4   –
//   phong      2.70  4.4e-3   2.94  3.4e-4   4.35  3.5e-5   8.50  9.3e-6
StudyReport sphereStudy();

}  // namespace test
