#include <algorithm>
#include <array>
#include <span>

#include "app/web/core/core.h"
#include "lessons/held_figure.h"
#include "pipeline/inspect/picture_vectors.h"
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
    Json json{{"kind", name(hold.kind)},
              {"name", hold.name},
              {"keys", hold.keys},
              {"place", place ? Json{place->at.x, place->at.y} : Json()},
              {"behind", place && place->isBehind},
              {"words", wordsOf(scene, hold)},
              {"values", pipeline::toText(valuesOf(scene, hold))},
              {"own", pipeline::toText(valuesOf(half().state.scene, hold))},
              {"object", movesObject(hold) ? Json(hold.index) : Json()},
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

Json pair(glm::dvec2 point) { return {point.x, point.y}; }
Json listOf(std::span<const glm::dvec2> points) {
    Json list = Json::array();
    for (const glm::dvec2 point : points) list.push_back(pair(point));
    return list;
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

// The figure below the picture, as shapes and terms. Of its place: the width, and where the picture's columns are in it,
// pixels. A pixel below 0: none is picked.
WEB_CALL(figure) int webFigure(double width, double left, double perColumn, int x, int y, int channel) {
    constexpr std::array<std::string_view, 5> kKinds{"line", "box", "curve", "dot", "words"};
    const OpenLesson& open = *core().lesson;
    ShownScene& own = core().own;
    const bool isOpen =
        open.lesson.pages[open.page].question && open.progress[open.page].outcome == lessons::Progress::Outcome::Open;
    const lessons::HeldFigure figure =
        lessons::figureOf({.half = half(),
                           .scene = *own.scene,
                           .frame = own.now(),
                           .pixel = x < 0 ? std::nullopt : std::optional(glm::ivec2(x, y)),
                           .channel = std::clamp(channel, 0, 2),
                           .tells = !isOpen,
                           .buffer = [&](const pipeline::BufferName& name) { return bufferNamed(own, name.text()); }},
                          {width, left, perColumn});
    Json shapes = Json::array(), terms = Json::array();
    for (const lessons::FigureShape& shape : figure.shapes)
        shapes.push_back({{"kind", kKinds[std::size_t(shape.kind)]},
                          {"role", shape.role},
                          {"points", listOf(shape.points)},
                          {"text", shape.text},
                          {"anchor", shape.anchor}});
    for (const lessons::FigureTerm& term : figure.terms)
        terms.push_back({{"symbol", term.symbol},
                         {"text", lessons::termText(term.value, figure.most)},
                         {"share", figure.most > 0 ? term.value / figure.most : 0}});
    return give({{"spoken", figure.spoken},
                 {"shapes", shapes},
                 {"terms", terms},
                 {"sum", {{"symbol", figure.sumSymbol}, {"text", lessons::termText(figure.sum, figure.most)}}},
                 {"track", figure.track ? listOf(*figure.track) : Json()}});
}

// N, the first L, and H or null, at a pixel as lines in the picture, with the arc between N and L and the horizon; null where
// nothing is lit. Pixels.
WEB_CALL(vectors) int webVectors(int x, int y) {
    const auto vectors = vectorsInPicture(*core().own.frame, {x, y});
    if (!vectors) return give(Json());
    return give({{"at", pair(vectors->at)},
                 {"N", pair(vectors->N)},
                 {"L", pair(vectors->L)},
                 {"H", vectors->H ? pair(*vectors->H) : Json()},
                 {"n_dot_l", vectors->nDotL},
                 {"arc", listOf(vectors->arc)},
                 {"horizon", listOf(vectors->horizon)}});
}

}  // namespace web
