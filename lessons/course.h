#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/compare/handed_in.h"

// What a course asks its students' renderers to draw, and the points for it.

namespace lessons {

// A file in TOML:
//
//   title = "Assignment 3"
//   hints = 2                 # what students' pages give away, as compare --hints
//   most_mb = 64              # of one hand-in
//   [[task]]
//   name = "house"            # the student's folder below the hand-in, where there are several tasks
//   scene = "house.toml"      # in the course's folder, or a scene that comes with the program
//   set = ["shading=phong"]
//   points = {color = 4, "z-buffer" = 2}   # by stage or buffer
struct Course {
    struct Check {
        std::string name;  // as the course calls it
        std::optional<pipeline::StageId> stage;
        pipeline::foreign::HandedName buffer{};  // where it is no stage
        double points = 0;
    };
    struct Task {
        std::string name;    // of letters, digits, - and _
        std::string folder;  // a name; empty: the hand-in's own
        std::shared_ptr<const pipeline::Scene> scene;
        std::vector<Check> checks;
    };
    std::string title;
    int hints = 3;
    std::size_t mostBytes = std::size_t{64} << 20;
    std::vector<Task> tasks;
    std::string key;  // a hash of all this and of the program's version: other marks have another one
};

// FILE:LINE:COLUMN errors; those of a scene name the scene's file.
pipeline::Result<Course> readCourse(const std::filesystem::path& file, const pipeline::Stop& stop = {});

}  // namespace lessons
