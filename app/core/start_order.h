#pragma once
#include <QString>
#include <string>
#include <vector>

#include "lessons/state/window_state.h"
#include "pipeline/buffers/buffer_table.h"

namespace app {

// Several pictures that open as one view of as many aligned buffer views.
struct StartView {
    QString name, title, text;
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
    std::vector<StartView> views;
    std::vector<StartGroup> groups;
};

// The lectures, and then what belongs to none: every built-in scene is in one group.
std::vector<StartLecture> startOrder();
// The index of the lecture that a lesson belongs to, by its header ("Lecture 2, Visibility"); the last one where no lecture
// is named.
std::size_t lectureOf(const std::string& header);

}  // namespace app
