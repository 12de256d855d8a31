#include <fmt/format.h>

#include "app/web/core/core.h"
#include "pipeline/core/angles.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/code_figure.h"
#include "pipeline/scene/view.h"

// What a hand can move on the page, and what follows it.

namespace web {

using pipeline::Hold;
using pipeline::HoldPlace;
using pipeline::Vec3d;

namespace {

const lessons::Half& half() {
    const OpenLesson& open = *core().lesson;
    const lessons::Page& page = open.lesson.pages[open.page];
    return open.then ? *page.then : page.first;
}

Json holdJson(const Hold& hold) {
    const pipeline::Scene& scene = *core().own.scene;
    const auto place = placeOf(scene, hold);
    const bool isOfObject = hold.kind == Hold::Kind::Turn || hold.kind == Hold::Kind::Along;
    Json json{{"kind", name(hold.kind)},
              {"name", hold.name},
              {"keys", hold.keys},
              {"place", place ? Json{place->at.x, place->at.y} : Json()},
              {"behind", place && place->isBehind},
              {"words", wordsOf(scene, hold)},
              {"values", pipeline::toText(valuesOf(scene, hold))},
              {"own", pipeline::toText(valuesOf(half().state.scene, hold))},
              {"object", isOfObject ? Json(hold.index) : Json()},
              {"vertex", hold.vertex},
              {"low", hold.low},
              {"high", hold.high},
              {"number", valuesOf(scene, hold).front().second}};
    // The point that a line leads to: what a lamp goes around, its foot, where a vertex was.
    if (hold.kind == Hold::Kind::Vertex && valuesOf(scene, hold) != valuesOf(half().state.scene, hold))
        if (const auto before = placeOf(half().state.scene, hold)) json["around"] = {before->at.x, before->at.y};
    if (hold.kind == Hold::Kind::LampAtInfinity)
        if (const auto middle = projected(makeView(scene), hold.point)) json["around"] = {middle->x, middle->y};
    if (hold.kind == Hold::Kind::LampTop) {
        Hold foot = hold;
        foot.kind = Hold::Kind::LampFoot;
        if (const auto below = placeOf(scene, foot)) json["around"] = {below->at.x, below->at.y};
    }
    return json;
}

const Hold* holdAt(int number) {
    const std::vector<Hold>& holds = half().held.holds;
    return number >= 0 && std::size_t(number) < holds.size() ? &holds[std::size_t(number)] : nullptr;
}

}  // namespace

// What can be held now, with places and words, and what the half shows beside them; whether the play is at its end.
WEB_CALL(holds) int webHolds() {
    const lessons::Held& held = half().held;
    Json list = Json::array();
    for (const Hold& hold : held.holds) list.push_back(holdJson(hold));
    Json json{{"holds", list}, {"shows", ""}, {"played", false}, {"files", Json::array()}};
    for (const lessons::HeldFile& file : filesOf(held, *core().own.scene)) {
        Json lines = Json::array();
        for (const pipeline::LectureLine& line : file.lines)
            lines.push_back({{"number", line.number},
                             {"text", line.text},
                             {"meaning", line.meaning},
                             {"vertex", line.vertex ? Json(*line.vertex) : Json()}});
        json["files"].push_back({{"title", file.title}, {"lines", lines}});
    }
    if (!core().own.frame) return give(json);
    const lessons::Context context{.frame = *core().own.frame};
    if (!held.shows.empty()) {
        const auto said = filled(held.shows, context);
        json["shows"] = said ? *said : std::string();  // a value that is not finite has no words
    }
    if (held.play)
        if (const auto ended = evaluate(held.play->until, context)) json["played"] = ended->numbers[0] == 1;
    return give(json);
}

// The values that a drag gives, as set() takes them. start: those where it began, which was at `from`.
WEB_CALL(hold)
int webHold(int number, double fromX, double fromY, double toX, double toY, int coarse, const char* start, int size) {
    const Hold* hold = holdAt(number);
    if (!hold) return refuse("nothing is held");
    const auto began = pipeline::withSettings(*core().own.scene, textAt(start, size));
    if (!began) return refuse(began.errors());
    return give(pipeline::toText(valuesAt(*began, *hold, {fromX, fromY}, {toX, toY}, coarse != 0)));
}

// The same of an arrow key: x to the right, y downwards.
WEB_CALL(nudge) int webNudge(int number, int x, int y, int coarse) {
    const Hold* hold = holdAt(number);
    if (!hold) return refuse("nothing is held");
    return give(pipeline::toText(nudged(*core().own.scene, *hold, {x, y}, coarse != 0)));
}

WEB_CALL(codes) int webCodes() {
    const pipeline::CodeFigure figure = pipeline::codeFigure(*core().own.scene);
    return give({{"near", figure.near},
                 {"far", figure.far},
                 {"nearest", figure.nearest},
                 {"farthest", figure.farthest},
                 {"marks", figure.marks},
                 {"codes", figure.codes}});
}

// N and the first L at a pixel as lines in the picture, with the arc between them and the horizon; null where nothing is
// lit. Pixels.
WEB_CALL(vectors) int webVectors(int x, int y) {
    const pipeline::Frame& frame = *core().own.frame;
    const pipeline::Scene& scene = frame.scene();
    if (x < 0 || y < 0 || x >= scene.settings.width || y >= scene.settings.height) return refuse("no such pixel");
    const pipeline::PixelReport report = inspectPixel(frame, {x, y});
    if (report.evaluations.empty() || report.evaluations[0].lights.empty()) return give(Json());
    const auto& evaluation = report.evaluations[0];
    const pipeline::View view = makeView(scene);
    const Vec3d at = evaluation.position, N = evaluation.N, L = evaluation.lights[0].L;
    const double depth = view.perspective ? toView(view, at).z : 1;
    const double reach = 0.2 * view.size.y / view.scale.y * depth;  // a fifth of the picture's height
    const auto inPicture = [&](const Vec3d& direction) {
        const auto point = projected(view, at + reach * direction);
        return point ? Json{point->x, point->y} : Json{x + 0.5, y + 0.5};
    };
    Json arc = Json::array(), horizon = Json::array();
    for (int i = 0; i <= 16; ++i) {
        const Vec3d between = (1 - i / 16.0) * N + i / 16.0 * L;
        const double length = glm::length(between);
        if (length > 0) arc.push_back(inPicture(0.45 / length * between));
    }
    const Vec3d side = glm::normalize(glm::cross(std::abs(N.z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0), N));
    for (int i = 0; i <= 32; ++i)
        horizon.push_back(inPicture(
            0.6 * (pipeline::cosDegrees(11.25 * i) * side + pipeline::sinDegrees(11.25 * i) * glm::cross(N, side))));
    return give(
        {{"N", inPicture(N)}, {"L", inPicture(L)}, {"n_dot_l", glm::dot(N, L)}, {"arc", arc}, {"horizon", horizon}});
}

}  // namespace web
