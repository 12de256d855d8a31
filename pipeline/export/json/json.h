#pragma once
#include "pipeline/export/json/json_value.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/inspect/scanline.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// One object a stage: stage, action, why, rule, and its parts: part, action, why, saves, rule.
Json toJson(const Plan& plan);
Json toJson(const std::vector<Tally>& tallies);
// Every setting of a scene: key to number, true or false, or the name of a choice.
Json settingsToJson(const Scene& scene);
// The scene's name and files, with their SHA-256 where they can be read.
Json sceneToJson(const Scene& scene);
// What `inspect` prints, as values. The equation for each of r, g and b.
Json toJson(const Frame& frame, const PixelReport& report);
Json toJson(const std::vector<EquationLine>& lines);  // role, text, latex, remark of each

// A section along a row: the runs of each polygon, and per shading method and x the intensity, null where nothing is
// drawn; only of the methods that it holds.
Json toJson(const ScanlineSection& section);

Json toJson(const Vec3d& vector);  // [x, y, z]
// What is strange about a scene: about and text of each remark. Of a frame also what its stages did not do as asked.
Json remarksToJson(const Scene& scene);
Json remarksToJson(const Frame& frame);

}  // namespace pipeline
