#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/stage.h"
#include "pipeline/defects/defect.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// The table of planted defects. A hypothesis about somebody's renderer is a frame of the scene with the setting `defect`:
// plant(), then runFrame(). Window, commands, lessons and tests read this table.

// Given: what a stage is given is wrong. Left: what it has left. Within: one result of a function at a point.
enum class DefectKind : std::uint8_t { Given, Left, Within };

struct DefectRow {
    Defect id;
    std::string_view name;  // for people, a few words: "y counted from the bottom"
    // Where the line stands that is to be mended; none: in the file that is read.
    std::optional<StageId> stage;
    DefectKind kind;
    std::string_view symptom;        // how the picture looks, one sentence
    std::string_view givesAway;      // what to look at, one sentence
    std::string_view wrong;          // the formula as it is then, in the lecture's notation
    std::string_view fix;            // and as it should be
    std::string_view scene;          // of resources/scenes, in which it shows
    std::string_view settings = {};  // of that scene, "key=value" with spaces between; may be empty
    // The first buffer that differs there, in the order of the stages: one of `stage`, where there is one.
    BufferId first;
    std::string_view lesson = {},
                     heading = {};  // the lesson about it, and the page's heading; empty where there is none yet
    std::string_view source;
    // Other common ways of making it, 1 and on for Settings::defectWay; all else here is about way 0, which the game
    // plants.
    std::span<const std::string_view> otherWays = {};
    bool inGame = true;   // false: for the comparison of renderers alone
    bool hidden = false;  // colour hardly shows it there, `first` does

    std::string_view idText() const { return idOf(id); }
    int wayCount() const { return 1 + int(otherWays.size()); }
};

// Without None, in the order of Defect.
std::span<const DefectRow> defectTable();
// Of one other than None.
const DefectRow& defectInfo(Defect defect);
std::optional<Defect> findDefect(std::string_view id);  // "y-down"

// The scene with a defect planted. way: an index into the row's ways; beyond them, the last.
Scene plant(Scene scene, Defect defect, int way = 0);

// The same beside the defect that is planted already, for somebody who makes two errors. The scene as it is where it has two,
// where both are the same, or where both change the text of one stage.
Scene plantToo(Scene scene, Defect defect, int way = 0);

// Where a renderer samples its pixels, if not at their centres: at their first corner in its own order of rows. That is a
// convention, and drawn as a planted one: the setting `defect` of the scene changes, and takes the one planted before along.
enum class PixelCorner : std::uint8_t { None, UpperLeft, LowerLeft };
Scene sampledAt(Scene scene, PixelCorner corner);
// By how much that moves the picture, pixels.
glm::dvec2 sampleShiftOf(const Scene& scene);

}  // namespace pipeline
