#pragma once
#include <QString>
#include <optional>
#include <vector>

#include "lessons/derived_buffer.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/settings_table.h"

namespace app {

// What a buffer view is compared with: its B.
struct OtherSource {
    enum class Kind : unsigned char {
        Buffer,         // another buffer of the same frame
        PreviousStage,  // the main buffer of the stage before the one that leaves the buffer on show
        Before,         // the same buffer before the last change of the scene
        Setting,        // the same buffer of another pipeline: with one setting changed
        Scene,          // the same buffer of another scene that comes with the program
        File,           // a picture
        Mine,           // what somebody else's renderer has left of it
    };
    Kind kind = Kind::Before;
    pipeline::BufferName buffer{pipeline::BufferId::Color};  // Buffer
    pipeline::SettingRef setting{};                          // Setting
    double value = 0;
    QString file{};   // File
    QString scene{};  // Scene: its name
    bool operator==(const OtherSource&) const = default;
};

// "gouraud (shading)", "before the last change", "diffuse.0", "reference.npy".
QString nameOf(const OtherSource& source);

// A scene's value of a setting below a picture, in words: "Phong", "16 bits", "No bias", "Tessellation 32".
QString captionOf(const pipeline::SettingRef& setting, const pipeline::Scene& scene);

// As a file has it, empty for Mine: "before", "previous stage", "buffer z_view", "setting shading=gouraud", "scene z_buffer_flat", "file a.npy"; and again, for a
// scene that has the setting.
std::string keyOf(const OtherSource& source);
pipeline::Result<OtherSource> sourceNamed(std::string_view key, const pipeline::Scene& scene);

// The buffer of B's frame that stands against `shown`; nothing where there is none: before the first
// stage, or for a file.
std::optional<pipeline::BufferName> otherBuffer(const OtherSource& source, const pipeline::BufferName& shown,
                                                const pipeline::Scene& scene);

using ScenePtr = std::shared_ptr<const pipeline::Scene>;
// The scene whose frame B is taken of: `scene` itself for another buffer of the same frame. Null
// where there is none: for a file, before the first change, with a setting that the scene does not
// have. before: the scene before the last change, or null.
ScenePtr otherScene(const OtherSource& source, const ScenePtr& scene, const ScenePtr& before);

// Keeps B's scene while the question is the same, and its shapes beyond that: scenes compare meshes by identity, so a shape
// that is made anew would make another scene, and another frame, of every look at it.
class OtherScene {
public:
    const ScenePtr& of(const OtherSource& source, const ScenePtr& scene, const ScenePtr& before);  // as otherScene

private:
    std::optional<OtherSource> m_source;
    ScenePtr m_scene, m_before, m_other;
};

// One entry of the list that B is picked from.
struct OtherChoice {
    QString group;  // of a submenu; empty: stands by itself
    QString text;
    OtherSource source;
    QString whyNot{};  // empty: can be picked
};
// All but files. Another buffer can be picked where it has the same shape as `shown`; another
// pipeline for every choice and switch that has an effect in the scene. recipe: of derived buffers.
std::vector<OtherChoice> otherChoices(const pipeline::Frame& frame, const pipeline::BufferName& shown, bool hasBefore,
                                      const lessons::DerivedRecipe& recipe);

}  // namespace app
