#include <fmt/format.h>

#include "app/web/core/core.h"
#include "app/web/core/scene_text.h"
#include "lessons/pages/live_text.h"
#include "lessons/questions/hidden.h"
#include "lessons/questions/results.h"
#include "lessons/state/view_tree.h"
#include "pipeline/core/text.h"
#include "pipeline/defects/own_words.h"
#include "pipeline/export/html/html_text.h"

// The lesson's pages and their questions, judged by the engine of the program.

namespace web {

using lessons::Attempt;
using lessons::Page;
using pipeline::Errors;

namespace {

OpenLesson& opened() { return *core().lesson; }
const Page& page() { return opened().lesson.pages[opened().page]; }
Attempt attempt() { return Attempt(*page().question, opened().progress[opened().page]); }
bool isSettled() { return page().question && attempt().isSettled(); }

std::string html(const pipeline::Result<std::string>& said, Errors& errors) {
    if (said) return lessons::liveHtml(*said);
    errors.insert(errors.end(), said.errors().begin(), said.errors().end());
    return {};
}
std::string html(const lessons::Prose& prose, const lessons::Context& context, Errors& errors) {
    return html(filled(prose, context), errors);
}

void addSettings(const lessons::Node& node, std::vector<std::string>& keys) {
    if (node.setting && std::ranges::find(keys, node.setting->key()) == keys.end()) keys.push_back(node.setting->key());
    for (const lessons::Node& operand : node.operands) addSettings(operand, keys);
}

// The settings that the page is about: those that its question frees, else those that its text names.
std::vector<std::string> settingsInPlay() {
    std::vector<std::string> keys;
    const auto& question = page().question;
    if (question)
        if (const auto* until = std::get_if<lessons::UntilQuestion>(&question->kind)) return until->free;
    for (const lessons::Half* half : {&page().first, page().then ? &*page().then : nullptr})
        if (half)
            for (const lessons::Prose::Hole& hole : half->text.holes) addSettings(hole.expression.root, keys);
    return keys;
}

// What the page needs to run lines: the function, its contract in words, and the last text that was run.
Json writeJson(const lessons::WriteQuestion& write, const lessons::Attempt& attempt) {
    const pipeline::OwnContract& contract = write.contract;
    Json json{{"function", contract.name}, {"shape", shapeText(contract)}, {"stage", int(contract.stage)},
              {"result", contract.result}, {"picture", contract.picture},  {"trials", write.trials.size()},
              {"start", write.start},      {"takes", Json::array()}};
    for (const pipeline::OwnParameter& one : contract.taken())
        json["takes"].push_back({one.name, one.meaning, isList(one.kind)});
    if (!attempt.progress().tries.empty()) json["last"] = attempt.progress().tries.back().given;
    return json;
}

Json questionJson(Errors& errors) {
    const lessons::Question& question = *page().question;
    const lessons::Context context = contextOf(opened());
    const Attempt attempt = web::attempt();
    static constexpr std::array<const char*, 5> kStates{"open", "known", "not yet", "right", "shown"};
    Json json{{"kind", kindName(question)},
              {"text", html(question.text, context, errors)},
              {"state", kStates[std::size_t(attempt.state())]},
              {"settled", attempt.isSettled()},
              {"worth", attempt.worth()},
              {"full", attempt.full()},
              {"points", attempt.points()},
              {"free", attempt.isFree()},
              {"tries_left", attempt.triesLeft() ? Json(*attempt.triesLeft()) : Json()},
              {"hint_count", attempt.hintCount()},
              {"hints", Json::array()},
              {"options", Json::array()}};
    for (std::size_t i = 0; i < attempt.hintsSeen(); ++i)
        json["hints"].push_back(html(attempt.hint(i, context), errors));
    std::size_t number = 0;
    for (const lessons::Prose* row : rowsOf(question))
        json["options"].push_back({{"text", html(*row, context, errors)}, {"off", attempt.isOff(number++)}});
    if (const auto* order = std::get_if<lessons::OrderQuestion>(&question.kind))
        json["ends"] = {order->first, order->last};
    if (const auto* typed = std::get_if<lessons::NumberQuestion>(&question.kind)) json["unit"] = typed->unit;
    if (const auto* click = std::get_if<lessons::ClickQuestion>(&question.kind)) json["click"] = name(click->kind);
    const auto* write = std::get_if<lessons::WriteQuestion>(&question.kind);
    if (write) json["write"] = writeJson(*write, attempt);
    if (const auto* until = std::get_if<lessons::UntilQuestion>(&question.kind)) {
        if (const auto gauge = gaugeOf(*until, context); gauge && *gauge) json["gauge"] = (*gauge)->said;
        // For Show me; a page tells no answer before.
        if (attempt.isSettled())
            for (const lessons::UntilQuestion::Setting& setting : until->answer) {
                std::string value = setting.word;
                if (setting.number)
                    if (const auto number = evaluate(*setting.number, {.frame = *opened().first}); number)
                        value = fmt::format("{}", number->numbers[0]);
                json["answer"].push_back(setting.key + '=' + value);
            }
    }
    if (!attempt.isSettled()) return json;
    const auto solution = attempt.solution({.frame = *opened().first, .changed = &opened().changed});
    if (!solution) {
        errors.insert(errors.end(), solution.errors().begin(), solution.errors().end());
        return json;
    }
    json["solution"] = {{"answer", write ? "<pre><code>" + pipeline::escapedHtml(write->answer) + "</code></pre>"
                                         : lessons::liveHtml(solution->answer)},
                        {"steps", Json::array()}};
    for (const std::string& line : solution->steps) json["solution"]["steps"].push_back(lessons::liveHtml(line));
    return json;
}

Json hiddenJson() {
    const lessons::Hidden hidden = lessons::hiddenOn(page(), isSettled());
    Json json{{"buffers", Json::array()}, {"parts", Json::array()}, {"count", hidden.count()}};
    for (const pipeline::BufferName& name : hidden.buffers) json["buffers"].push_back(name.text());
    for (const lessons::Part part : hidden.parts) json["parts"].push_back(lessons::kPartNames[std::size_t(part)]);
    return json;
}

// How the half looks at its buffers: of each view what it shows, and what that is compared with.
Json viewsJson(const lessons::WindowState& window) {
    constexpr std::string_view kSetting = "setting ";
    Json views = Json::array();
    for (const lessons::BufferShown& view : window.views) {
        Json json{{"buffer", view.buffer},
                  {"channel", index(view.channel)},
                  {"range", view.range ? Json(*view.range) : Json()},
                  {"overlays", view.overlays},
                  {"zoom", view.zoom ? Json{view.zoom->factor, view.zoom->center[0], view.zoom->center[1]} : Json()},
                  {"against", ""}};
        if (view.compared && view.compared->with.starts_with(kSetting))
            update(json, {{"against", view.compared->with.substr(kSetting.size())},
                          {"mode", view.compared->mode},
                          {"wipe", view.compared->wipe},
                          {"metric", view.compared->metric}});
        views.push_back(std::move(json));
    }
    return views;
}

// The 3D view beside the buffers; empty where the half has none.
std::string spaceOf(const lessons::WindowState& window) {
    const auto tree = lessons::arrangementOf(window.arrangement);
    const bool has = tree && contains(*tree, {lessons::ViewLeaf::Kind::Space, 0});
    return has && !window.spaces.empty() ? window.spaces.front().space : std::string();
}

std::string selectedWords(const lessons::WindowState& window) {
    static constexpr std::array<const char*, 4> kKinds{"object", "polygon", "vertex", "light"};
    if (!window.selected) return {};
    return fmt::format("{} {}", kKinds[std::size_t(window.selected->kind)], window.selected->index);
}

Json heldJson(const lessons::Held& held) {
    return {{"figure", held.figure ? Json(lessons::kFigureNames[std::size_t(*held.figure)]) : Json()},
            {"hard", held.hardPixels},
            {"strip", held.strip},
            {"spot", held.spot ? Json{{"row", held.spot->row}, {"name", held.spot->name}} : Json()},
            {"play", held.play ? Json{{"text", held.play->text}, {"done", held.play->done}} : Json()}};
}

// What is in the hand stays there through the answer, unless the second half sets it itself.
std::string stillHeld() {
    if (!page().then || !isSettled()) return {};
    pipeline::Assignments kept;
    for (const pipeline::Hold& hold : page().first.held.holds)
        for (const auto& value : valuesOf(*core().own.scene, hold))
            if (std::ranges::find(page().then->sets, value.first) == page().then->sets.end()) kept.push_back(value);
    return pipeline::toText(kept);
}

int givePage() {
    OpenLesson& open = opened();
    // As in the window and on paper: whatever the reader changes, the text says what the author meant.
    const lessons::Context context{.frame = open.then ? *open.half : *open.first, .changed = &open.changed};
    const lessons::Half& half = open.then ? *page().then : page().first;
    const lessons::WindowState& window = half.state.window;
    Errors errors;
    Json pins = Json::object();
    for (const auto& [number, pixel] : window.pins) pins[std::to_string(number)] = pixel;
    const bool keepsFigure = page().first.held.figure || (page().then && page().then->held.figure);
    Json json{{"number", open.page},
              {"count", open.lesson.pages.size()},
              {"name", pageName(open.lesson, open.page)},
              {"answered", std::ranges::any_of(open.progress, [](const auto& one) { return !one.tries.empty(); })},
              {"heading", page().heading},
              {"text", html(half.text, context, errors)},
              {"then", open.then},
              {"has_then", page().then.has_value()},
              {"stage", pipeline::stageInfo(window.stage).name},
              {"place", window.place ? Json(pipeline::text(*window.place)) : Json()},
              {"level", int(window.step)},
              {"pixel", window.pixel ? Json(*window.pixel) : Json()},
              {"channel", window.channel},
              {"condition", window.condition},
              {"mix", window.mix},
              {"buffers", viewsJson(window)},
              {"pins", pins},
              {"selected", selectedWords(window)},
              {"space", spaceOf(window)},
              {"held", heldJson(half.held)},
              {"keeps_figure", keepsFigure},
              {"in_play", settingsInPlay()},
              {"hidden", hiddenJson()},
              {"question", page().question ? questionJson(errors) : Json()}};
    return errors.empty() ? give(json) : refuse(errors);
}

std::optional<double> numberAt(const Json& json, const char* key) {
    return json[key].is(Json::kNumber) ? std::optional(json[key].get<double>()) : std::nullopt;
}

lessons::Given givenIn(const Json& json) {
    if (json["typed"].is(Json::kString)) return lessons::Typed{json["typed"].text()};
    const auto indicesIn = [](const Json& list) {
        std::vector<std::size_t> indices;
        for (const Json& one : list)
            if (one.is(Json::kUnsigned)) indices.push_back(one.get<std::size_t>());
        return indices;
    };
    if (json["chosen"].is(Json::kArray)) return lessons::Chosen{indicesIn(json["chosen"])};
    if (json["order"].is(Json::kArray)) return lessons::Ordered{indicesIn(json["order"])};
    if (json.find("pick")) {
        const Json& from = json["pick"];
        return lessons::Pick{numberAt(from, "x"),      numberAt(from, "y"),      numberAt(from, "polygon"),
                             numberAt(from, "vertex"), numberAt(from, "object"), numberAt(from, "light")};
    }
    return lessons::Reached{};
}

// A browser's storage may hold anything: members of another type keep their defaults.
lessons::Progress progressIn(const Json& json) {
    const auto hintsIn = [](const Json& of) {
        return of["hints"].is(Json::kUnsigned) ? of["hints"].get<std::size_t>() : 0;
    };
    lessons::Progress progress;
    const auto outcome = std::ranges::find(lessons::kOutcomeNames, json["outcome"].text());
    if (outcome == lessons::kOutcomeNames.end()) return progress;
    progress.outcome = lessons::Progress::Outcome(outcome - lessons::kOutcomeNames.begin());
    progress.hints = hintsIn(json);
    if (json["tries"].is(Json::kArray))
        for (const Json& one : json["tries"])
            progress.tries.push_back({one["given"].text(), one["right"] == true, one["mistake"].text(), hintsIn(one),
                                      numberAt(one, "seconds").value_or(0)});
    return progress;
}

// A scene of the lesson among the files of the page.
pipeline::Result<pipeline::Scene> sceneOfPage(std::string_view name) {
    const auto found = core().files.find(std::string(name) + ".toml");
    if (found == core().files.end()) return pipeline::Error{{}, "no scene " + pipeline::inQuotes(name), {}};
    return sceneFromText(found->first, found->second);
}

Json parsed(const char* text, int size) { return Json::read(textAt(text, size)).value_or(Json()); }

}  // namespace

const lessons::Question& questionOf(const OpenLesson& open) { return *open.lesson.pages[open.page].question; }

lessons::Context contextOf(OpenLesson& open) {
    const bool byReader = std::holds_alternative<lessons::UntilQuestion>(questionOf(open).kind);
    return {.frame = byReader ? *core().own.frame : *open.first, .changed = &open.changed};
}

Json verdictJson(const lessons::Verdict& verdict) {
    static constexpr std::array<const char*, 4> kMarks{"right", "known", "not yet", "again"};
    return {
        {"mark", kMarks[std::size_t(verdict.mark)]}, {"name", verdict.name}, {"said", lessons::liveHtml(verdict.said)}};
}

pipeline::BufferSet readByPage(const OpenLesson& open) {
    const auto& question = open.lesson.pages[open.page].question;
    const auto* until = question ? std::get_if<lessons::UntilQuestion>(&question->kind) : nullptr;
    const lessons::Page& page = open.lesson.pages[open.page];
    const pipeline::BufferSet held = buffersOf((open.then ? *page.then : page.first).held);
    if (!until || open.then) return held;
    pipeline::BufferSet judged = held | until->holds.buffers;
    for (const lessons::Mistake& mistake : until->mistakes) judged |= mistake.value.buffers;
    return judged;
}

// lesson: lesson.md, whose scenes are files of the page by the names that it has for them, with ".toml". html: of each of
// its texts in the order of liveTexts(), a JSON array.
WEB_CALL(lesson) int webLesson(const char* text, int size, const char* html, int htmlSize) {
    auto lesson = lessons::parseOwnPages(textAt(text, size), "lesson.md", sceneOfPage);
    if (!lesson) return refuse(lesson.errors());
    core() = LiveCore{.files = std::move(core().files)};
    OpenLesson& open = core().lesson.emplace(OpenLesson{std::move(lesson).value(), {}});
    open.progress.resize(open.lesson.pages.size());
    const Json texts = parsed(html, htmlSize);
    const std::vector<lessons::Prose*> prose = lessons::liveTexts(open.lesson);
    if (!texts.is(Json::kArray) || texts.elements().size() != prose.size())
        return refuse("the texts of this page are not its lesson's");
    for (std::size_t i = 0; i < prose.size(); ++i)
        if (!texts[i].is(Json::kString) || !lessons::dress(*prose[i], texts[i].text()))
            return refuse("the texts of this page are not its lesson's");
    double points = 0;
    for (const Page& page : open.lesson.pages) points += page.question ? page.question->points : 0;
    return give({{"title", open.lesson.title}, {"points", points}, {"pages", open.lesson.pages.size()}});
}

// Opens a page, from 0; then: its second half, which the reader has reached. frame() has to follow.
WEB_CALL(page) int webPage(int number, int then) {
    OpenLesson& open = opened();
    if (number < 0 || std::size_t(number) >= open.lesson.pages.size()) return refuse("no such page");
    const bool goesOn = then != 0 && std::size_t(number) == open.page && !open.then && core().own.scene;
    const std::string kept = goesOn ? stillHeld() : std::string();
    open.page = std::size_t(number);
    open.then = then != 0 && page().then && isSettled();
    const auto run = [&](const lessons::Half& half, pipeline::FrameRequest request) {
        request.threads = 1;
        request.wanted |= shownAlways();
        return runFrame(std::make_shared<const pipeline::Scene>(half.state.scene), request, core().own.frame);
    };
    open.first = run(page().first, lessons::requestFor(page()));
    open.half = open.then ? run(*page().then, lessons::requestForThen(page())) : open.first;
    core().own = {open.half->sharedScene(), open.half, nullptr, {}, nullptr, {}, nullptr};
    if (!kept.empty())
        if (auto scene = pipeline::withSettings(*core().own.scene, kept); scene && checkScene(*scene).empty())
            take(std::move(scene).value());
    core().other.reset();
    const lessons::WindowState& window = (open.then ? *page().then : page().first).state.window;
    const auto mix = pipeline::parseMix(window.mix, open.half->scene().lights.size());
    core().recipe = {window.condition, mix ? *mix : pipeline::TermMix()};
    const int given = givePage();
    core().own.frame.reset();  // the reader's own begins anew: it says what ran
    return given;
}

// The page again, with what its question has become.
WEB_CALL(read) int webRead() { return givePage(); }

// {"typed": "0.5"}, {"chosen": [1]}, {"order": [1, 0]}, {"pick": {"x": 3, "y": 4, "polygon": 2}}, or {} for the reader's own frame.
WEB_CALL(check) int webCheck(const char* text, int size) {
    if (!page().question || isSettled()) return refuse("nothing is asked");
    const Json json = parsed(text, size);
    Attempt attempt = web::attempt();
    const auto verdict = attempt.check(givenIn(json), contextOf(opened()));
    if (!verdict) return refuse(verdict.errors());
    opened().progress[opened().page] = attempt.progress();
    return give(verdictJson(*verdict));
}

WEB_CALL(hint) int webHint() {
    if (!page().question || isSettled()) return refuse("nothing is asked");
    Attempt attempt = web::attempt();
    if (attempt.hintsSeen() == attempt.hintCount()) return refuse("no more hints");
    const auto hint = attempt.nextHint(contextOf(opened()));
    if (!hint) return refuse(hint.errors());
    opened().progress[opened().page] = attempt.progress();
    return give(lessons::liveHtml(*hint));
}

// What was answered so far, as a hand-in that the program grades. name: of the lesson.
WEB_CALL(answers) int webAnswers(const char* name, int size) {
    lessons::Results results;
    lessons::Lesson named;
    named.name = textAt(name, size);
    const OpenLesson& open = opened();
    for (std::size_t i = 0; i < open.lesson.pages.size(); ++i)
        if (open.progress[i] != lessons::Progress()) results.put(named, open.lesson.pages[i], open.progress[i]);
    return give(toText(results));
}

// What answers() gave before the page was loaded again, for pages that are still there.
WEB_CALL(remember) int webRemember(const char* name, int size, const char* text, int textSize) {
    OpenLesson& open = opened();
    const Json json = parsed(text, textSize);
    const Json& pages = json["lessons"][textAt(name, size)];
    Json points = Json::array(), mistakes = Json::array();
    for (std::size_t i = 0; i < open.lesson.pages.size(); ++i) {
        const Page& page = open.lesson.pages[i];
        if (!page.question) continue;
        open.progress[i] = progressIn(pages[page.heading]);
        const Attempt attempt(*page.question, open.progress[i]);
        if (attempt.isSettled()) points.push_back({i, attempt.points()});
        for (const lessons::Try& one : attempt.progress().tries)
            if (!one.mistake.empty()) mistakes.push_back({lessons::mistakeName(one.mistake), pageName(open.lesson, i)});
    }
    return give({{"points", points}, {"mistakes", mistakes}});
}

// Gives up.
WEB_CALL(show) int webShow() {
    if (!page().question || isSettled()) return refuse("nothing is asked");
    Attempt attempt = web::attempt();
    attempt.showMe();
    opened().progress[opened().page] = attempt.progress();
    return give(true);
}

}  // namespace web
