#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/compare/handed_in/handed_in.h"
#include "pipeline/compare/trial.h"

// What a course asks its students' renderers to draw, or their programs to compute, and the points for it.

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
//
// A task with `stage` runs a program of the student's:
//
//   seconds = 10              # of one run
//   confine = "bwrap …"       # before every command
//   [[task]]
//   stage = "CalcNormal"      # a function of the manual, or a whole stage
//   scenes = ["pyramid"]
//   hidden = ["hollow.toml"]  # for grading alone
//   build = "make"            # once; may be missing
//   run = "python3 CalcNormal.py"
//   points = 12               # of a function; of a stage by buffer, as above
struct Course {
    struct Check {
        std::string name;  // as the course calls it
        std::optional<pipeline::StageId> stage;
        pipeline::foreign::HandedName buffer{};  // where it is no stage
        double points = 0;
    };
    // One of function and stage is not null.
    struct Trial {
        std::string name;  // of the scene: its file's, without the ending
        bool isHidden = false;
        std::shared_ptr<const pipeline::Scene> scene;
        std::shared_ptr<const pipeline::foreign::FunctionTrial> function;
        std::shared_ptr<const pipeline::foreign::StageTrial> stage;
    };
    struct Program {
        std::optional<pipeline::OwnFunction> function;
        pipeline::StageId stage{};  // of the function, or the whole
        std::string build, run;
        std::vector<Trial> trials;
    };
    struct Task {
        std::string name;                              // of letters, digits, - and _
        std::string folder;                            // a name; empty: the hand-in's own
        std::shared_ptr<const pipeline::Scene> scene;  // that the files show; null where a program runs
        std::optional<Program> program;
        std::vector<Check> checks;  // points of a program's: for all its trials together
    };
    std::string title;
    int hints = 3;
    std::size_t mostBytes = std::size_t{64} << 20;
    int seconds = 10;
    std::string confine;
    std::vector<Task> tasks;
    bool runsPrograms() const;
    std::string key;  // a hash of all this and of the program's version: other marks have another one
};

// FILE:LINE:COLUMN errors; those of a scene name the scene's file.
pipeline::Result<Course> readCourse(const std::filesystem::path& file, const pipeline::Stop& stop = {});

}  // namespace lessons
