#include "lessons/games/wrong_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "lessons/games/look_text.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/inspect/compare.h"
#include "pipeline/inspect/equation_text.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {
namespace {

using pipeline::Defect;
using pipeline::DefectRow;
using pipeline::StageId;

// The same on every machine: the library's distributions are not.
class Dice {
public:
    Dice(std::uint64_t seed, std::size_t number) : m_random(seed + 0x9E3779B97F4A7C15u * number) {}
    template <class T>
    void shuffle(T& values) {
        for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[m_random() % i]);
    }

private:
    std::mt19937_64 m_random;
};

std::vector<Defect> poolOf(const std::vector<int>& boxes) {
    std::vector<Defect> pool;
    for (const DefectRow& row : pipeline::defectTable())
        if (row.inGame && (boxes.empty() || std::ranges::find(boxes, boxOf(row)) != boxes.end()))
            pool.push_back(row.id);
    return pool;
}

// The right one, three of the same box and one of another; of others where there are too few.
std::array<Defect, 5> causesFor(Defect defect, Dice& dice) {
    std::vector<Defect> same, other;
    for (const DefectRow& row : pipeline::defectTable())
        if (row.inGame && row.id != defect) (boxOf(row) == boxOf(defectInfo(defect)) ? same : other).push_back(row.id);
    dice.shuffle(same), dice.shuffle(other);
    std::array<Defect, 5> causes{defect};
    for (std::size_t i = 1; i < causes.size(); ++i) {
        std::vector<Defect>& from = i < causes.size() - 1 && !same.empty() ? same : other;
        causes[i] = from.back();
        from.pop_back();
    }
    dice.shuffle(causes);
    return causes;
}

// The next box that an error may be in, or the one before where there is none.
int boxBeside(int box) {
    for (const int step : {1, -1})
        for (int other = box + step; other >= 0 && other < kBoxes; other += step)
            if (!poolOf({other}).empty()) return other;
    return box;
}

// Who halves the boxes in which an error may be comes to the right one, and looks once more to tell the cause.
int parOf(const std::vector<Defect>& pool) {
    std::array<bool, kBoxes> is{};
    for (const Defect defect : pool) is[std::size_t(boxOf(defectInfo(defect)))] = true;
    int par = 1;
    for (auto boxes = std::ranges::count(is, true); boxes > 1; boxes = (boxes + 1) / 2) ++par;
    return par;
}

std::vector<pipeline::BufferName> buffersOf(const pipeline::Frame& frame, StageId stage) {
    std::vector<pipeline::BufferName> names;
    for (const pipeline::BufferName& name : pipeline::allBuffers(frame.scene().lights.size()))
        if (pipeline::bufferInfo(name.id).stage == stage && frame.buffer(name)) names.push_back(name);
    return names;
}

// What a stage's own run gives, on what it got.
std::string ownRun(const pipeline::FramePtr& wrong, StageId stage) {
    const pipeline::FramePtr own = runAlone(wrong, stage);
    std::size_t elements = 0, differing = 0;
    std::string names;
    for (const pipeline::BufferName& name : buffersOf(*own, stage)) {
        if (!wrong->buffer(name)) continue;
        const pipeline::StageDifference found = stageDifference(*own, *wrong, name);
        elements += found.elements, differing += found.differing;
        names += (names.empty() ? "" : ", ") + name.text();
    }
    if (elements == 0) return "It was left out: there is nothing that it could have got wrong.\n";
    return fmt::format("Its own run on what it got: {} of {} values differ from this frame's ({}).\n", differing,
                       elements, names);
}

std::string lineList(const std::string& what, const std::string& text) { return what + '\n' + text; }

// The fragments of a pixel, each with the depths compared.
std::string fragmentsOf(const pipeline::Frame& frame, glm::ivec2 pixel) {
    std::string text;
    for (const pipeline::FragmentReport& fragment : inspectPixel(frame, pixel).fragments)
        text += fmt::format("  polygon {}: {}, {}\n", fragment.polygon, comparisonText(fragment).whole(),
                            name(fragment.verdict));
    return text;
}

std::string equationOf(const pipeline::Frame& frame, glm::ivec2 pixel, int channel) {
    const pipeline::PixelReport report = inspectPixel(frame, pixel);
    if (!report.covered || report.outline) return "  nothing is drawn there\n";
    const std::vector<pipeline::EquationLine> lines = equation(frame.scene(), report, channel);
    std::string text = "  ";
    for (const char c : equationText(lines, pipeline::EquationFormat::Text))
        text += c == '\n' ? "\n  " : std::string(1, c);
    text.resize(text.size() - 2);  // after the last line feed
    return text;
}

// "pixel 320, 240", "polygon 2".
std::string placeOf(const pipeline::AnyBuffer& buffer, std::size_t element) {
    switch (buffer.info->domain) {
        case pipeline::Domain::Vertex: return fmt::format("vertex {}", element);
        case pipeline::Domain::Polygon: return fmt::format("polygon {}", element);
        case pipeline::Domain::Pixel:
        case pipeline::Domain::Texel: break;
    }
    return fmt::format("{} {}, {}", buffer.info->domain == pipeline::Domain::Pixel ? "pixel" : "texel",
                       element % buffer.columns(), element / buffer.columns());
}

std::string numbersAt(const pipeline::AnyBuffer& buffer, std::size_t element) {
    if (buffer.info->palette == pipeline::Palette::Verdict)
        return std::string(name(static_cast<pipeline::Verdict>(buffer.flat(element))));
    std::string text;
    const auto channels = std::size_t(buffer.channels());
    for (std::size_t c = 0; c < channels; ++c)
        text += (c == 0 ? "" : ", ") + numberText(buffer.flat(element * channels + c));
    return text;
}

}  // namespace

std::string_view boxLabel(int box) {
    return box == 0 ? std::string_view("The file") : stageInfo(pipeline::kStages[std::size_t(box - 1)]).label;
}
int boxOf(const DefectRow& row) { return row.stage ? 1 + int(index(*row.stage)) : 0; }
std::optional<int> findBox(std::string_view name) {
    if (name == "file") return 0;
    if (name.size() == 1 && name[0] >= '0' && name[0] < '0' + kBoxes) return name[0] - '0';
    const auto stage = pipeline::findStage(name);
    return stage ? std::optional(1 + int(index(*stage))) : std::nullopt;
}

pipeline::Result<pipeline::Scene> sceneOf(const DefectRow& row) {
    for (const pipeline::BuiltInScene& of : pipeline::builtInScenes()) {
        if (of.name != row.scene) continue;
        pipeline::Result<pipeline::Scene> scene = pipeline::readScene(of.file);
        for (std::string_view rest = row.settings; scene && !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            scene = withSetting(std::move(scene).value(), rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return scene;
    }
    return pipeline::Error{{}, fmt::format("there is no scene {}", row.scene)};
}

std::size_t riddleCount(const std::vector<int>& boxes) { return poolOf(boxes).size(); }

pipeline::Result<Riddle> makeRiddle(std::uint64_t seed, std::size_t number, const std::vector<int>& boxes) {
    std::vector<Defect> pool = poolOf(boxes);
    if (pool.empty()) return pipeline::Error{{}, "no defect of the game is of these stages"};
    Riddle riddle;
    riddle.par = parOf(pool);
    Dice(seed, 0).shuffle(pool);  // the same order for all numbers: none comes twice before all have come
    riddle.defect = pool[number % pool.size()];
    Dice dice(seed, number + 1);
    riddle.causes = causesFor(riddle.defect, dice);
    auto scene = sceneOf(defectInfo(riddle.defect));
    if (!scene) return scene.errors();
    riddle.right = std::make_shared<const pipeline::Scene>(std::move(scene).value());
    return riddle;
}

Riddle ownRiddle(std::shared_ptr<const pipeline::Scene> right, Defect defect, std::uint64_t seed) {
    Dice dice(seed, 0);
    if (right->settings.defect != Defect::None) {
        auto mended = std::make_shared<pipeline::Scene>(*right);
        mended->settings.defect = Defect::None;
        right = std::move(mended);
    }
    return {defect, std::move(right), causesFor(defect, dice), parOf(poolOf({}))};
}

std::unique_ptr<WrongPicture> WrongPicture::begin(Riddle riddle, const pipeline::Stop& stop) {
    std::unique_ptr<WrongPicture> game(new WrongPicture);
    game->m_riddle = std::move(riddle);
    pipeline::FrameRequest request;
    request.wanted.set();
    request.stop = stop;
    pipeline::Scene right = *game->m_riddle.right;
    right.settings.leaveOut = false;  // both hold the same buffers
    const pipeline::Scene wrong = plant(right, game->m_riddle.defect);
    game->m_right = runFrame(std::make_shared<const pipeline::Scene>(std::move(right)), request, {});
    if (game->m_right) game->m_wrong = runFrame(std::make_shared<const pipeline::Scene>(wrong), request, {});
    return game->m_wrong ? std::move(game) : nullptr;
}

void WrongPicture::countLook(std::string what) {
    if (std::ranges::find(m_looks, what) == m_looks.end() && m_phase != Phase::Over) m_looks.push_back(std::move(what));
}

std::string WrongPicture::look(const pipeline::BufferName& buffer) {
    if (buffer.id != pipeline::BufferId::Color && m_wrong->buffer(buffer)) countLook(buffer.text());
    return lookText(*m_wrong, buffer);
}

std::string WrongPicture::look(glm::ivec2 pixel) {
    countLook(fmt::format("{}, {}", pixel.x, pixel.y));
    return lookText(*m_wrong, pixel);
}

WrongPicture::Answer WrongPicture::mark(int box) {
    const int blamed = boxOf(row());
    if (box == blamed) {
        m_phase = Phase::Cause;
        return {true, fmt::format("Yes: {} is the first that is wrong.\n", box == 0 ? "the file" : boxLabel(box))};
    }
    if (!m_cleared[std::size_t(box)]) ++m_wrongStages;
    m_cleared[std::size_t(box)] = true;
    // What comes before the error is right; what comes after it is wrong as a consequence.
    const char* where = box < blamed ? "The error comes later: what this leaves is right, and the picture is wrong.\n"
                                     : "The error comes earlier: this got something wrong already.\n";
    if (box == 0) return {false, std::string("The file says what it should.\n") + where};
    return {false, "This stage did what it should with what it got.\n" +
                       ownRun(m_wrong, pipeline::kStages[std::size_t(box - 1)]) + where};
}

WrongPicture::Answer WrongPicture::name(std::size_t cause) {
    const DefectRow& named = defectInfo(m_riddle.causes[cause]);
    if (named.id == m_riddle.defect) {
        m_phase = Phase::Over;
        return {true, {}};
    }
    if (!m_excluded[cause]) ++m_wrongCauses;
    m_excluded[cause] = true;
    return {false, fmt::format("Not that: with it you would see this. {}\n", named.symptom)};
}

std::string WrongPicture::hint() {
    const auto shown =
        stageDifference(*m_right, *m_wrong, {row().first, pipeline::bufferInfo(row().first).perLight ? 0 : -1});
    switch (m_hints++) {
        case 0: return fmt::format("What can be seen: {}\n", row().symptom);
        case 1: {
            const int box = boxOf(row()), beside = boxBeside(box);
            return fmt::format("It is one of two: {} or {}.\n", boxLabel(std::min(box, beside)),
                               boxLabel(std::max(box, beside)));
        }
        case 2:
            return fmt::format("Look at {}, {}.\n", shown.buffer.text(),
                               placeOf(*m_wrong->buffer(shown.buffer), shown.worst.value_or(0)));
        default: --m_hints; return {};
    }
}

int WrongPicture::points() const {
    const int beyond = std::max(0, int(m_looks.size()) - m_riddle.par);
    return std::max(10, 100 - 5 * beyond - 20 * m_wrongStages - 10 * m_hints - 20 * m_wrongCauses);
}

std::string WrongPicture::reveal() const {
    std::string text = fmt::format("{}: {}.\n{}\n", boxLabel(boxOf(row())), row().name, row().symptom);
    // The lights' buffers differ of some light, not always the first.
    for (const pipeline::BufferName& name : pipeline::allBuffers(m_right->scene().lights.size())) {
        if (name.id != row().first) continue;
        const auto difference = stageDifference(*m_right, *m_wrong, name);
        if (!difference.worst) continue;
        text += fmt::format(
            "\n{} differs in {} of {} places. At {}: {}, right is {}.\n", name.text(), difference.differing,
            difference.elements, placeOf(*m_wrong->buffer(name), *difference.worst),
            numbersAt(*m_wrong->buffer(name), *difference.worst), numbersAt(*m_right->buffer(name), *difference.worst));
        break;
    }
    if (const auto pixel = worstPixel(*m_right, *m_wrong)) {
        const auto a = *m_right->buffer({pipeline::BufferId::Color}), b = *m_wrong->buffer({pipeline::BufferId::Color});
        int channel = 0;
        const auto differenceOf = [&](int c) {
            return std::abs(a.value(std::size_t(pixel->x), std::size_t(pixel->y), c) -
                            b.value(std::size_t(pixel->x), std::size_t(pixel->y), c));
        };
        for (int c = 1; c < 3; ++c)
            if (differenceOf(c) > differenceOf(channel)) channel = c;
        if (row().stage == StageId::ZBuffer)
            text += fmt::format("\nPixel {}, {}, fragments, wrong:\n{}right:\n{}", pixel->x, pixel->y,
                                fragmentsOf(*m_wrong, *pixel), fragmentsOf(*m_right, *pixel));
        text += lineList(fmt::format("\nPixel {}, {}, {}, wrong:", pixel->x, pixel->y,
                                     std::array{"red", "green", "blue"}[std::size_t(channel)]),
                         equationOf(*m_wrong, *pixel, channel));
        text += lineList("right:", equationOf(*m_right, *pixel, channel));
    }
    text += fmt::format("\nWrong: {}\nRight: {}\n", row().wrong, row().fix);
    if (!row().lesson.empty()) text += fmt::format("Lesson {}: {}\n", row().lesson, row().heading);
    return text;
}

std::optional<glm::ivec2> worstPixel(const pipeline::Frame& a, const pipeline::Frame& b) {
    const auto difference = stageDifference(a, b, {pipeline::BufferId::Color});
    if (!difference.worst) return std::nullopt;
    const int width = a.scene().settings.width;
    return glm::ivec2(int(*difference.worst) % width, int(*difference.worst) / width);
}

}  // namespace lessons
