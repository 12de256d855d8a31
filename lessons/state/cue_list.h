#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/state/window_state.h"
#include "pipeline/core/stop.h"

namespace lessons {

// What a cue asks the audience. The cue after it is the answer, whose caption says it in one sentence.
struct CueQuestion {
    std::string text = {};
    std::vector<std::string> choices = {};  // 2 to 4, called A to D
    std::size_t right = 0;                  // of them
    bool operator==(const CueQuestion&) const = default;
};

// One thing to show in a talk, as the window shows it, with what to say.
struct Cue {
    std::string name;
    std::string caption = {};  // what the audience reads below the picture; empty: the name
    std::string note = {};     // for the lecturer alone; lines
    WindowState state = {};
    std::optional<CueQuestion> ask = {};
    bool operator==(const Cue&) const = default;
};

struct CueList {
    std::string title = {};
    int minutes = 45;  // how long the talk is, 1 to 600
    std::vector<Cue> cues = {};
    bool operator==(const CueList&) const = default;
};

inline constexpr char kCueEnding[] = ".cues";

// A cue list as TOML: [[cue]] with name, caption, note, and the keys of a state. Scenes are named from the file's folder.
std::string toToml(const CueList& list);
pipeline::Result<CueList> readCues(std::string_view text, const std::string& file, const pipeline::Stop& stop = {});
pipeline::Result<std::string> readCueText(const std::filesystem::path& file);  // the file as it is
pipeline::Result<CueList> readCueFile(const std::filesystem::path& file, const pipeline::Stop& stop = {});

// The cue whose question is on show at a cue: it asks, or answers the one before it. Nothing at others.
std::optional<std::size_t> asking(const CueList& list, std::size_t cue);

// By its name, or by its number from 1 where no cue has that name. Errors name the nearest.
pipeline::Result<std::size_t> findCue(const CueList& list, std::string_view name);

// The file of a list: the path as given if there is such a file, else the program's own list of that name, with or
// without its ending ("lecture1"). The path as given if there is neither.
std::filesystem::path cueFileAt(const std::filesystem::path& path);

// "FILE:NAME", the file the shortest beginning that cueFileAt finds, or where it finds none the shortest.
struct CueName {
    std::filesystem::path file;
    std::string name;
};
pipeline::Result<CueName> parseCueName(std::string_view text);

// A name that no other cue of the list has: "Shading", "Shading 2".
std::string freeName(const CueList& list, const std::string& wanted);

}  // namespace lessons
