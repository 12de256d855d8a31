#include "app/start/start_order.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/look/text.h"
#include "pipeline/formats/built_in_scenes.h"

namespace app {
namespace {

QString startText(const char* words) { return QCoreApplication::translate("StartPage", words); }

lessons::WindowState besideEachOther(std::string scene, std::vector<lessons::BufferShown> views) {
    lessons::WindowState state;
    state.scene = std::move(scene);
    state.arrangement.clear();
    for (std::size_t i = 0; i < views.size(); ++i) state.arrangement += i == 0 ? "buffer" : " | buffer";
    state.views = std::move(views);
    state.linked = true;
    return state;
}

StartView fourPictures() {
    const std::vector<StartView::Part> parts{{startText("Outlines"), "no_hidden_surface_removal"},
                                             {startText("Back faces culled"), "back_face_culling"},
                                             {startText("Z-buffer, flat"), "z_buffer_flat"},
                                             {startText("Z-buffer, Phong"), "z_buffer_phong"}};
    std::vector<lessons::BufferShown> views;
    for (const StartView::Part& part : parts) {
        lessons::BufferShown shown;
        // The last one too, which is the scene itself: views that are compared stand at the same height.
        shown.compared = lessons::BufferShown::Compared{.with = "scene " + part.scene, .mode = "b"};
        views.push_back(shown);
    }
    return {"four-pictures", startText("Lecture 1's four pictures"), besideEachOther("z_buffer_phong", views), parts};
}

StartView threeTerms() {
    using B = pipeline::BufferId;
    const std::vector<StartView::Part> parts{{startText("Ambient"), "z_buffer_phong", {B::Ambient}},
                                             {startText("Diffuse"), "z_buffer_phong", {B::Diffuse, 0}},
                                             {startText("Specular"), "z_buffer_phong", {B::Specular, 0}},
                                             {startText("Sum"), "z_buffer_phong"}};
    std::vector<lessons::BufferShown> views;
    for (const StartView::Part& part : parts) {
        lessons::BufferShown shown;
        shown.buffer = part.buffer.text();
        // One range for all: a term that is small looks small.
        if (part.buffer.id != B::Color) shown.range = {{0, 255}};
        views.push_back(shown);
    }
    return {"three-terms", startText("Lecture 2's three terms and sum"), besideEachOther("z_buffer_phong", views),
            parts};
}

}  // namespace

std::vector<StartLecture> startOrder() {
    const auto talk = [](const char* file) {
        return toQString((pipeline::resourceFolder() / "manual" / file).string());
    };
    std::vector<StartLecture> lectures{
        {startText("Lecture 1"),
         startText("Illumination, reflection, shading"),
         fourPictures(),
         {{startText("Light, reflection, scene files"), {"ambient", "lambert", "highlight_exponents", "pyramid"}},
          {startText("Interpolated shading"),
           {"vertex_normals", "interpolation", "rgb_triangle", "flat_gouraud_phong", "z_buffer_gouraud", "gl_cube"}},
          {startText("Shadows"),
           {"two_pyramids", "box_over_plane", "point_light_shadow", "soft_shadow", "shadow_bias"}}},
         talk("lecture1.cues")},
        {startText("Lecture 2"),
         startText("Visibility, local illumination"),
         threeTerms(),
         {{startText("Visibility"),
           {"cyclic_overlap", "intersecting_polygons", "concave_polygon", "near_plane", "z_fighting", "translucent",
            "translucent_cycle"}},
          {startText("Local illumination"), {"reflection_law", "phong_blinn", "coloured_lights", "teapot"}}},
         talk("lecture2.cues")}};
    const auto isPlaced = [&](const std::string& scene) {
        return std::ranges::any_of(lectures, [&](const StartLecture& lecture) {
            return std::ranges::find(lecture.first.parts, scene, &StartView::Part::scene) !=
                       lecture.first.parts.end() ||
                   std::ranges::any_of(lecture.groups, [&](const StartGroup& group) {
                       return std::ranges::find(group.scenes, scene) != group.scenes.end();
                   });
        });
    };
    // What the lectures do not name comes last.
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        if (!isPlaced(scene.name)) lectures.back().groups.back().scenes.push_back(scene.name);
    return lectures;
}

std::optional<std::size_t> lectureOf(const std::string& header) {
    if (header.starts_with("Lecture 1")) return 0;
    if (header.starts_with("Lecture 2")) return 1;
    return std::nullopt;
}

}  // namespace app
