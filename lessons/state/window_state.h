#pragma once
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/state/selection.h"
#include "lessons/state/shown_channel.h"
#include "pipeline/core/real.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stage.h"
#include "pipeline/steps/moment.h"

namespace lessons {

// How one buffer is looked at.
struct BufferShown {
    std::string buffer = "color";  // its name: "n_dot_l.0"
    ShownChannel channel = ShownChannel::All;
    std::optional<std::array<double, 2>> range = {};  // of the palette; nothing: fits every frame
    std::vector<std::string> overlays{"strange"};     // their names
    bool logCounts = true;                            // the axis of the histogram
    bool flipped = false;                             // row 0 at the foot
    // Whose statistics are shown: first and last column and row, x, y, x, y.
    std::optional<std::array<int, 4>> region = {};
    // Nothing: as much as fits. Screen pixels a picture pixel, and the point of the picture in the middle of a view of
    // this size; a larger view shows the same part larger.
    struct Zoom {
        double factor = 1;
        std::array<double, 2> center{}, view{};
        bool operator==(const Zoom&) const = default;
    };
    std::optional<Zoom> zoom = {};
    // What it is compared with, its B, and which of the two is seen.
    struct Compared {
        std::string with =
            "before";  // "before", "previous stage", "buffer z_view", "setting shading=gouraud", "file a.npy"
        std::string mode = "wipe";                        // "a", "b", "blink", "wipe", "difference"
        double wipe = 0.5;                                // the part of the width that A has
        std::string metric = "E";                         // of the difference: its name
        std::optional<std::array<double, 2>> range = {};  // of the difference's palette; nothing: fits every frame
        bool operator==(const Compared&) const = default;
    };
    std::optional<Compared> compared = {};
    bool operator==(const BufferShown&) const = default;
};

// How the 3D view is looked at. World space, world units; fov in degrees.
struct SpaceShown {
    std::string space = "world";  // its name
    struct Camera {
        pipeline::Vec3d target{0.0}, right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};  // orthonormal
        double distance = 1, fov = 30;
        bool orthographic = false;
        bool operator==(const Camera&) const = default;
    };
    std::optional<Camera> camera = {};           // nothing: the first one, which the view chooses
    std::map<std::string, double> options = {};  // those that are not as they begin; a switch is 0 or 1
    bool operator==(const SpaceShown&) const = default;
};

// Where the values of a state stand in the file that it was read from: "set.1", "view.0.buffer". States that show the
// same are equal wherever they come from.
class StatePlaces {
public:
    void add(std::string key, pipeline::SourceLocation where) { m_places.insert_or_assign(std::move(key), where); }
    // Of a value, or of what it stands in; nowhere of a state that was not read.
    pipeline::SourceLocation of(std::string_view key) const;
    bool operator==(const StatePlaces&) const { return true; }

private:
    std::map<std::string, pipeline::SourceLocation, std::less<>> m_places;
};

inline constexpr std::size_t kMostSliders = 2;

// What the window shows, whatever its theme, size and docks: enough to see the same again. A session, a cue and a
// picture's text are one of these; files have it in TOML.
struct WindowState {
    // A scene file, from the folder of the file that names it, or the name of a built-in scene; empty: the scene that
    // comes with the state, as in a picture.
    std::string scene = {};
    std::vector<std::string> set = {};  // what has been changed in it since: "camera.theta=50"
    std::string sceneText = {};         // the whole scene as TOML, where settings cannot say what has changed
    pipeline::StageId stage = pipeline::StageId::Shading;
    std::optional<pipeline::Place> place = {};  // inside the frame; nothing: at its end
    pipeline::StepLevel step = pipeline::StepLevel::Polygon;
    bool algorithm = false;                        // of the stage, beside the step
    std::optional<std::array<int, 2>> pixel = {};  // x, y; row 0 on top
    int channel = 2;                               // of the equation: 0 r, 1 g, 2 b
    std::string condition = {};                    // the text of the buffers `condition` and `expression`
    std::vector<std::string> sliders = {};        // settings with a slider in the clean view: at most kMostSliders keys
    std::string mix = {};                         // of the terms, as parseMix reads it; empty: every term as it is
    std::map<int, std::array<int, 2>> pins = {};  // the pinned pixels by their numbers, 1 to 9
    std::optional<Selection> selected = {};
    std::string arrangement = "one";  // of the views: as arrangementOf reads it
    std::optional<bool> linked = {};  // buffer views zoom and move together; nothing: as linksViews has it
    std::vector<BufferShown> views{BufferShown()};  // in the order of the arrangement; at least one
    std::vector<SpaceShown> spaces{SpaceShown()};   // likewise
    std::vector<pipeline::Place> bookmarks = {};
    StatePlaces places = {};
    bool operator==(const WindowState&) const = default;
};

// The state as TOML; readState gives it back, every number the same.
std::string toToml(const WindowState& state);

// Errors name `file` with line and column.
pipeline::Result<WindowState> readState(std::string_view text, const std::string& file);

}  // namespace lessons
