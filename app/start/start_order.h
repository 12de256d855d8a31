#pragma once
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "lessons/state/window_state.h"
#include "pipeline/buffers/buffer_table.h"

namespace app {

// The first pictures of a lecture. Together they open as one view of as many aligned buffer views, each alone as its scene.
struct StartView {
    QString name, title;
    lessons::WindowState state;
    struct Part {
        QString label;
        std::string scene;  // built in
        pipeline::BufferName buffer{pipeline::BufferId::Color};
    };
    std::vector<Part> parts;
};

// A part of a lecture, its scenes in the order of the slides, by their names.
struct StartGroup {
    QString title;
    std::vector<std::string> scenes;
};

struct StartLecture {
    QString title, about;
    StartView first;
    std::vector<StartGroup> groups;
    QString talk;  // its list of cues, a file
};

// Every built-in scene is one of the first pictures, or in one group.
std::vector<StartLecture> startOrder();
// The index of the lecture that a lesson belongs to, by its header ("Lecture 2, Visibility"); nothing where it names none.
std::optional<std::size_t> lectureOf(const std::string& header);

}  // namespace app
