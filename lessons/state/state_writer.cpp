#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lessons/state/state_text.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace lessons {

using pipeline::tomlNumber;
using pipeline::tomlString;

namespace {

std::string list(std::span<const double> numbers) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(tomlNumber(number));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}
std::string list(const std::vector<std::string>& strings) {
    std::vector<std::string> texts;
    for (const std::string& string : strings) texts.push_back(tomlString(string));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}
std::string list(pipeline::Vec3d v) { return list(std::array{v.x, v.y, v.z}); }

class Lines {
public:
    void line(std::string_view key, const std::string& value) { m_text += fmt::format("{} = {}\n", key, value); }
    void head(const std::string& head) { m_text += '\n' + head + '\n'; }
    std::string take() { return std::move(m_text); }

private:
    std::string m_text;
};

void write(Lines& out, const BufferShown& view) {
    out.line("buffer", tomlString(view.buffer));
    if (view.channel != ShownChannel::All)
        out.line("channel", tomlString(kShownChannels[std::size_t(index(view.channel))]));
    if (view.range) out.line("range", list(*view.range));
    if (view.overlays != BufferShown().overlays) out.line("overlays", list(view.overlays));
    if (!view.logCounts) out.line("counts", tomlString("linear"));
    if (view.flipped) out.line("flipped", "true");
    if (const auto& r = view.region) out.line("region", fmt::format("[{}]", fmt::join(*r, ", ")));
    if (const auto& compared = view.compared) {
        const BufferShown::Compared usual;
        out.line("against", tomlString(compared->with));
        out.line("compare", tomlString(compared->mode));
        if (compared->wipe != usual.wipe) out.line("wipe", tomlNumber(compared->wipe));
        if (compared->metric != usual.metric) out.line("metric", tomlString(compared->metric));
        if (compared->range) out.line("difference", list(*compared->range));
    }
    if (!view.zoom) return;
    out.line("zoom", tomlNumber(view.zoom->factor));
    out.line("center", list(view.zoom->center));
    out.line("size", list(view.zoom->view));
}

void write(Lines& out, const SpaceShown& space) {
    out.line("space", tomlString(space.space));
    if (const auto& camera = space.camera) {
        out.line("target", list(camera->target));
        out.line("right", list(camera->right));
        out.line("up", list(camera->up));
        out.line("forward", list(camera->forward));
        out.line("distance", tomlNumber(camera->distance));
        out.line("fov", tomlNumber(camera->fov));
        if (camera->orthographic) out.line("orthographic", "true");
    }
    for (const auto& [name, value] : space.options) out.line("options." + name, tomlNumber(value));
}

}  // namespace

std::string stateText(const WindowState& state, const std::string& prefix) {
    Lines out;
    if (!state.scene.empty()) out.line("scene", tomlString(state.scene));
    if (!state.set.empty()) out.line("set", list(state.set));
    if (!state.sceneText.empty()) out.line("scene_text", pipeline::tomlText(state.sceneText));
    out.line("stage", tomlString(stageInfo(state.stage).name));
    if (state.place) out.line("place", tomlString(text(*state.place)));
    out.line("step", tomlString(name(state.step)));
    if (state.algorithm) out.line("algorithm", "true");
    if (state.pixel) out.line("pixel", fmt::format("[{}, {}]", (*state.pixel)[0], (*state.pixel)[1]));
    if (!state.pins.empty()) {
        std::vector<std::string> pins;
        for (const auto& [number, xy] : state.pins) pins.push_back(fmt::format("[{}, {}, {}]", number, xy[0], xy[1]));
        out.line("pins", fmt::format("[{}]", fmt::join(pins, ", ")));
    }
    if (const auto& thing = state.selected)
        out.line("selected", tomlString(fmt::format("{} {}", kSelectedKinds[std::size_t(thing->kind)], thing->index)));
    out.line("equation", tomlString(kEquationChannels[std::size_t(state.channel)]));
    if (!state.condition.empty()) out.line("condition", tomlString(state.condition));
    if (!state.sliders.empty()) out.line("sliders", list(state.sliders));
    if (!state.mix.empty()) out.line("mix", tomlString(state.mix));
    out.line("arrangement", tomlString(state.arrangement));
    if (state.linked) out.line("linked", *state.linked ? "true" : "false");
    if (!state.bookmarks.empty()) {
        std::vector<std::string> places;
        for (const pipeline::Place& place : state.bookmarks) places.push_back(text(place));
        out.line("bookmarks", list(places));
    }
    for (const BufferShown& view : state.views) {
        out.head("[[" + prefix + "view]]");
        write(out, view);
    }
    for (const SpaceShown& space : state.spaces) {
        out.head(state.spaces.size() == 1 ? "[" + prefix + "view3d]" : "[[" + prefix + "view3d]]");
        write(out, space);
    }
    return out.take();
}

std::string toToml(const WindowState& state) { return stateText(state, ""); }

}  // namespace lessons
