#include "app/cli/arguments/cue_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/arguments/frame_argument.h"
#include "lessons/derived_buffer.h"
#include "lessons/state/shown_words.h"
#include "lessons/state/state_text.h"
#include "pipeline/core/index_words.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/inspect/term_mix.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/settings_table.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::Error;
using pipeline::Errors;
using pipeline::inQuotes;
using pipeline::Place;
using pipeline::Scene;

namespace {

class CueCheck {
public:
    CueCheck(const lessons::WindowState& state, const Scene& scene, const std::filesystem::path& folder)
        : m_state(state), m_scene(scene), m_folder(folder) {}

    Errors errors() {
        if (!m_state.mix.empty()) take("mix", pipeline::parseMix(m_state.mix, m_scene.lights.size()));
        checkCondition();
        if (m_state.place) checkPlace("place", *m_state.place);
        for (std::size_t i = 0; i < m_state.bookmarks.size(); ++i)
            checkPlace(fmt::format("bookmarks.{}", i), m_state.bookmarks[i]);
        for (std::size_t i = 0; i < m_state.sliders.size(); ++i)
            take(fmt::format("sliders.{}", i), findSetting(m_scene, m_state.sliders[i]));
        if (m_state.pixel) checkPixel("pixel", *m_state.pixel);
        for (const auto& [number, pixel] : m_state.pins) checkPixel("pins", pixel);
        if (m_state.selected) checkSelected(*m_state.selected);
        for (std::size_t i = 0; i < m_state.views.size(); ++i) checkView(m_state.views[i], fmt::format("view.{}.", i));
        for (std::size_t i = 0; i < m_state.spaces.size(); ++i)
            checkSpace(m_state.spaces[i], fmt::format("view3d.{}.", i));
        return m_errors;
    }

private:
    void add(const std::string& key, const Errors& errors) {
        for (const Error& error : namedAt(m_state.places.of(key), errors)) m_errors.push_back(error);
    }
    void fail(const std::string& key, std::string found, std::string expected = {}) {
        add(key, {Error{{}, std::move(found), std::move(expected)}});
    }
    template <class T>
    void take(const std::string& key, const pipeline::Result<T>& result) {
        if (!result) add(key, result.errors());
    }

    // One text for both: a view says which of the two is meant.
    void checkCondition() {
        if (m_state.condition.empty()) return;
        const lessons::DerivedRecipe recipe{m_state.condition, {}};
        const auto condition = buffersFor({BufferId::Condition}, recipe, m_scene);
        if (!condition && !buffersFor({BufferId::Expression}, recipe, m_scene)) take("condition", condition);
    }
    void checkPlace(const std::string& key, const Place& place) { take(key, parsePlace(text(place), m_scene)); }

    void checkPixel(const std::string& key, const std::array<int, 2>& pixel) {
        const int width = m_scene.settings.width, height = m_scene.settings.height;
        if (pixel[0] < width && pixel[1] < height) return;
        fail(key, fmt::format("found the pixel {}, {}", pixel[0], pixel[1]),
             fmt::format("x from 0 to {} and y from 0 to {}", width - 1, height - 1));
    }

    void checkSelected(const lessons::Selection& thing) {
        std::size_t polygons = 0, vertices = 0;
        for (const pipeline::Object& object : m_scene.objects)
            polygons += object.mesh->polygonCount(), vertices += object.mesh->positions.size();
        // In the order of Selection::Kind.
        const std::array counts{m_scene.objects.size(), polygons, vertices, m_scene.lights.size()};
        checkNumber("selected", lessons::kSelectedKinds[std::size_t(thing.kind)], thing.index,
                    counts[std::size_t(thing.kind)]);
    }
    void checkNumber(const std::string& key, std::string_view what, std::size_t number, std::size_t count) {
        if (number >= count)
            fail(key, fmt::format("found {} {}", what, number),
                 count == 0 ? "a scene that has one" : pipeline::indexWords(count));
    }

    void checkView(const lessons::BufferShown& view, const std::string& key) {
        if (const auto name = pipeline::findAnyBuffer(view.buffer)) checkLight(key + "buffer", *name);
        for (std::size_t i = 0; i < view.overlays.size(); ++i)
            checkOverlay(fmt::format("{}overlays.{}", key, i), view.overlays[i]);
        if (view.compared) checkOther(key + "against", view.compared->with);
    }
    void checkLight(const std::string& key, const BufferName& name) {
        if (const auto none = noSuchLight(m_scene, name)) add(key, {*none});
    }
    void checkOverlay(const std::string& key, const std::string& overlay) {
        if (std::ranges::find(lessons::kOverlayNames, overlay) != lessons::kOverlayNames.end()) return;
        const auto derived = pipeline::findDerived(overlay);
        if (derived && derived->id == BufferId::ShadowVerdict) return checkLight(key, *derived);
        if (derived && derived->id == BufferId::Condition) return;
        std::vector<std::string> names(lessons::kOverlayNames.begin(), lessons::kOverlayNames.end());
        names.insert(names.end(), {"shadow_verdict.0", "condition"});
        fail(key, fmt::format("no overlay {}; {}", inQuotes(overlay), pipeline::insteadOf(overlay, names)));
    }
    void checkOther(const std::string& key, std::string_view with) {
        const auto rest = [&](std::string_view word) {
            return with.starts_with(word) ? std::optional(with.substr(word.size())) : std::nullopt;
        };
        if (with == "before" || with == "previous stage") return;
        if (const auto setting = rest("setting ")) return take(key, withSetting(m_scene, *setting));
        if (const auto name = rest("buffer "))
            if (const auto buffer = pipeline::findAnyBuffer(*name)) return checkLight(key, *buffer);
        if (const auto name = rest("scene "))
            if (pipeline::builtInScene(*name)) return;
        if (const auto file = rest("file ")) {
            std::error_code ignored;
            if (!std::filesystem::exists(m_folder / *file, ignored))
                fail(key, (m_folder / *file).string() + ": no such file");
            return;
        }
        fail(key, "found " + inQuotes(with),
             "before, previous stage, buffer NAME, setting KEY=VALUE, scene NAME or file FILE");
    }

    void checkSpace(const lessons::SpaceShown& shown, const std::string& key) {
        const auto space = lessons::parseSpace(shown.space);
        if (!space)
            fail(key + "space", "no space " + inQuotes(shown.space), lessons::kSpaceExpected);
        else if (lessons::kSpaceNames[space->space] == "light")
            checkNumber(key + "space", "light", std::size_t(space->light), m_scene.lights.size());
        for (const auto& [name, value] : shown.options) {
            const auto option = std::ranges::find(lessons::kSpaceOptions, name, &lessons::SpaceOption::name);
            std::vector<std::string> names;
            for (const lessons::SpaceOption& one : lessons::kSpaceOptions) names.emplace_back(one.name);
            if (option == lessons::kSpaceOptions.end())
                fail(key + "options." + name,
                     fmt::format("no option {}; {}", inQuotes(name), pipeline::insteadOf(name, names)));
            else if (!(value >= option->min && value <= option->max))
                fail(key + "options." + name, fmt::format("{} is {}", name, value),
                     fmt::format("a number from {} to {}", option->min, option->max));
        }
    }

    const lessons::WindowState& m_state;
    const Scene& m_scene;
    const std::filesystem::path& m_folder;
    Errors m_errors;
};

}  // namespace

Errors checkCue(const lessons::WindowState& state, const Scene& scene, const std::filesystem::path& folder) {
    return CueCheck(state, scene, folder).errors();
}

}  // namespace app
