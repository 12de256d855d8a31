#include "app/cli/cue_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/frame_argument.h"
#include "app/derived/derived_buffer.h"
#include "pipeline/inspect/term_mix.h"
#include "pipeline/scene/key_places.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::Error;
using pipeline::Errors;
using pipeline::Place;
using pipeline::Scene;

namespace {

class CueCheck {
public:
    CueCheck(const WindowState& state, const Scene& scene) : m_state(state), m_scene(scene) {}

    Errors errors() {
        if (!m_state.mix.empty()) take("mix", pipeline::parseMix(m_state.mix, m_scene.lights.size()));
        checkCondition();
        if (m_state.place) checkPlace("place", *m_state.place);
        for (std::size_t i = 0; i < m_state.views.size(); ++i)
            if (const auto name = pipeline::findAnyBuffer(m_state.views[i].buffer))
                if (const auto none = noSuchLight(m_scene, *name)) add(fmt::format("view.{}.buffer", i), {*none});
        return m_errors;
    }

private:
    void add(const std::string& key, const Errors& errors) {
        for (const Error& error : namedAt(m_state.places.of(key), errors)) m_errors.push_back(error);
    }
    template <class T>
    void take(const std::string& key, const pipeline::Result<T>& result) {
        if (!result) add(key, result.errors());
    }

    // One text for both: a view says which of the two is meant.
    void checkCondition() {
        if (m_state.condition.empty()) return;
        const DerivedRecipe recipe{m_state.condition, {}};
        const auto condition = buffersFor({BufferId::Condition}, recipe, m_scene);
        if (!condition && !buffersFor({BufferId::Expression}, recipe, m_scene)) take("condition", condition);
    }
    void checkPlace(const std::string& key, const Place& place) { take(key, parsePlace(text(place), m_scene)); }

    const WindowState& m_state;
    const Scene& m_scene;
    Errors m_errors;
};

}  // namespace

Errors checkCue(const WindowState& state, const Scene& scene) { return CueCheck(state, scene).errors(); }

}  // namespace app
