// A question of kind write: the page's worker has run the lines, the core judges their results and draws with them.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/web/core/core.h"
#include "lessons/pages/live_text.h"
#include "pipeline/defects/own_words.h"
#include "pipeline/run/frame_data.h"

namespace web {

namespace {

const lessons::WriteQuestion* asked() {
    const auto& open = core().lesson;
    const bool isThere = open && open->lesson.pages[open->page].question;
    return isThere ? std::get_if<lessons::WriteQuestion>(&questionOf(*open).kind) : nullptr;
}
const pipeline::OwnContract& contract() { return asked()->contract; }
Writing& writing() { return *core().writing; }

// The calls whose results are asked for, as doubles one after the other.
void addCalls(Json& json, const std::vector<pipeline::OwnElement>& calls) {
    std::vector<double>& numbers = writing().numbers;
    numbers.clear();
    for (const pipeline::OwnElement& call : calls) numbers.insert(numbers.end(), call.in.begin(), call.in.end());
    update(json, {{"calls", calls.size()},
                  {"pointer", std::size_t(numbers.data())},
                  {"count", numbers.size()},
                  {"dtype", "float64"}});
}

// Whether somebody has asked in this scene before; calls that follow need it.
bool isOpen() { return asked() && core().writing && writing().page == core().lesson->page; }

// A result for each call; one that has NaN in it is no number.
pipeline::OwnResults resultsIn(const char* bytes, std::size_t calls) {
    const std::size_t size = contract().size();
    pipeline::OwnResults results(calls);
    for (std::size_t i = 0; i < calls; ++i) {
        pipeline::OwnValue value;
        std::memcpy(value.at.data(), bytes + i * size * sizeof(double), size * sizeof(double));
        if (std::ranges::none_of(value.at, [](double x) { return std::isnan(x); })) results[i] = value;
    }
    return results;
}

bool isWrong(std::size_t i) {
    return differenceOf(contract(), writing().results[i], writing().elements[i].right) > contract().tolerance;
}

}  // namespace

// Opens a scene, 0 the page's own, then the trials: every call of the function there. The first answer to it is
// write_results of these calls.
WEB_CALL(write_scene) int webWriteScene(int number) {
    if (!asked() || number < 0 || std::size_t(number) > asked()->trials.size()) return refuse("no such scene");
    const OpenLesson& open = *core().lesson;
    std::optional<Writing>& known = core().writing;
    if (!known || known->page != open.page || known->number != std::size_t(number)) {
        const pipeline::Scene& scene = number == 0 ? open.lesson.pages[open.page].first.state.scene
                                                   : asked()->trials[std::size_t(number) - 1].scene;
        known.emplace(
            Writing{open.page, std::size_t(number), pipeline::ownScene(scene), {}, {}, {}, {}, {}, {}, {}, {}});
        pipeline::OwnFrame own =
            ownFrame(known->scene, contract().id, std::make_shared<const pipeline::OwnRecord>(), {});
        known->elements = std::move(own.unknown), known->right = own.frame;
    }
    known->record = std::make_shared<pipeline::OwnRecord>();
    known->asked = known->elements, known->results.clear(), known->mine.reset();
    Json json{{"name", number == 0 ? std::string() : asked()->trials[std::size_t(number) - 1].name}};
    addCalls(json, known->asked);
    return give(json);
}

// The results of the calls that were asked for, as doubles. Judges the first ones; gives calls that only these results
// lead to.
WEB_CALL(write_results) int webWriteResults(const char* bytes, int size) {
    if (!isOpen() || std::size_t(size) != writing().asked.size() * contract().size() * sizeof(double))
        return refuse("found results of other calls");
    Writing& of = writing();
    const pipeline::OwnResults results = resultsIn(bytes, of.asked.size());
    for (std::size_t i = 0; i < results.size(); ++i) of.record->add(of.asked[i], results[i]);
    if (of.results.empty()) of.results = results, of.verdict = judgeOwn(contract(), of.elements, results);
    of.asked.clear();
    if (contract().picture) {
        pipeline::OwnFrame own = ownFrame(of.scene, contract().id, of.record, {});
        of.mine = own.frame, of.asked = std::move(own.unknown);
    }
    Json json{{"all", of.verdict.all}, {"wrong", of.verdict.wrong}, {"first", of.verdict.first.value_or(0)}};
    addCalls(json, of.asked);
    return give(json);
}

// What the last run was, with its text: the answer, while the question is open.
WEB_CALL(write_judge) int webWriteJudge(const char* text, int size) {
    if (!isOpen() || writing().results.empty()) return refuse("nothing has run");
    OpenLesson& open = *core().lesson;
    const Writing& of = writing();
    const lessons::Written given{
        std::string(textAt(text, size)),
        of.number == 0 || of.verdict.isRight() ? std::string() : asked()->trials[of.number - 1].name, of.verdict};
    lessons::Attempt attempt(questionOf(open), open.progress[open.page]);
    const auto verdict = attempt.isSettled() ? lessons::judge(questionOf(open), given, contextOf(open))
                                             : attempt.check(given, contextOf(open));
    if (!verdict) return refuse(verdict.errors());
    open.progress[open.page] = attempt.progress();
    return give(verdictJson(*verdict));
}

// One call of the scene that was judged: where it is, its arguments, both results; and its numbers, to run it again.
WEB_CALL(write_element) int webWriteElement(int number) {
    if (!isOpen() || number < 0 || std::size_t(number) >= writing().results.size()) return refuse("no such call");
    const std::size_t i = std::size_t(number);
    const Writing& of = writing();
    Json json{{"number", i},
              {"place", placeText(of.elements[i], i, of.scene.settings.width)},
              {"arguments", argumentTexts(contract(), of.elements[i])},
              {"expected", resultText(contract(), of.elements[i].right)},
              {"got", resultText(contract(), of.results[i])},
              {"wrong", isWrong(i)}};
    addCalls(json, {of.elements[i]});
    return give(json);
}

// The next call after this one whose result differs, round and round; -1 where all agree.
WEB_CALL(write_next) int webWriteNext(int number) {
    if (!isOpen() || writing().results.empty()) return refuse("nothing has run");
    const std::size_t all = writing().results.size();
    for (std::size_t k = 1; k <= all; ++k)
        if (const std::size_t i = (std::size_t(number) + k) % all; isWrong(i)) return give(i);
    return give(-1);
}

// The call that belongs to a pixel, or to the polygon that is seen there; -1 where none does.
WEB_CALL(write_at) int webWriteAt(int x, int y) {
    if (!isOpen() || writing().results.empty()) return refuse("nothing has run");
    const Writing& of = writing();
    const auto& data = *pipeline::dataOf<double>(*of.right);
    const pipeline::Buffer2D<std::uint32_t>& seen = *data.zBuffer->triangle;
    if (x < 0 || y < 0 || x >= seen.size.x || y >= seen.size.y) return give(-1);
    const std::size_t pixel = std::size_t(x) + std::size_t(y) * std::size_t(seen.size.x);
    const std::uint32_t triangle = seen.pixels[pixel];
    for (std::size_t i = 0; i < of.elements.size(); ++i) {
        const pipeline::OwnElement& one = of.elements[i];
        if (one.kind == pipeline::OwnPlace::Pixel && one.place == pixel) return give(i);
        if (one.kind == pipeline::OwnPlace::Polygon && triangle != pipeline::kNoTriangle &&
            one.place == data.transform->topology->polygonOf(triangle))
            return give(i);
    }
    return give(-1);
}

// The picture, right (0) or with the lines (1): bytes of red, green and blue, row by row.
WEB_CALL(write_picture) int webWritePicture(int which) {
    if (!isOpen()) return refuse("nothing has run");
    const pipeline::FramePtr& frame = which == 0 ? writing().right : writing().mine;
    if (!frame) return refuse("the pipeline does not go on with these results");
    const pipeline::Buffer2D<pipeline::Color8>& color = pipeline::dataOf<double>(*frame)->shading->color;
    return give({{"pointer", std::size_t(color.pixels.data())},
                 {"count", 3 * color.pixels.size()},
                 {"dtype", "uint8"},
                 {"width", color.size.x},
                 {"height", color.size.y}});
}

}  // namespace web
