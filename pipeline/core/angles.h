#pragma once

namespace pipeline {

// Sine and cosine of an angle in degrees, any finite size, within 0.8 units in the last place. Exact at every multiple of
// 90, so that a camera at phi = 180 sees a right axis that is not rotated by a rounded pi. The same on every machine.
double sinDegrees(double degrees);
double cosDegrees(double degrees);

}  // namespace pipeline
