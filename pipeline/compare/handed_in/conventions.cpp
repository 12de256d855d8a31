#include "pipeline/compare/handed_in/conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "pipeline/compare/handed_in/picture_sample.h"
#include "pipeline/compare/handed_in/reading_cost.h"

namespace pipeline::foreign {

namespace {

constexpr double kClear = 3;     // times as close
constexpr double kNearer = 1.2;  // the same, where one of two has to be taken for a whole folder
constexpr double kExplains = 2;  // tolerances: what a reading that explains a file is off at most
constexpr double kFloor = 0.02;  // tolerances: below that two readings are equally good
constexpr std::size_t kSampleColumns = 160, kSampleRows = 120;

struct PossibleReading {
    Reading reading;
    double cost;
};

// What is chosen by itself: rows, columns, channels, coding.
enum Axis { Rows, Columns, Channels, Code, kAxes };
int valueOn(Axis axis, const Reading& reading) {
    switch (axis) {
        case Rows: return reading.bottomUp;
        case Columns: return reading.mirrored;
        case Channels: return reading.bgr;
        default: return int(reading.coding);
    }
}
// One file with all that it may mean.
struct Sounding {
    const HandedFile* file;
    std::vector<PossibleReading> candidates;
    bool isPicture = false;
    std::vector<int> otherChannels{}, otherCodings{};  // nearly as close as what is taken
    // The numbers of one reading, that of the least cost when they were read.
    std::shared_ptr<const std::pair<Reading, Values>> nearest{};
    double nearestCost = 0;

    Values numbers(const Reading& reading, const ReadingContext& context, const Values& right) const {
        return nearest && nearest->first == reading ? nearest->second : read(*file, reading, context, right);
    }
    const PossibleReading& best() const { return *std::ranges::min_element(candidates, {}, &PossibleReading::cost); }
    double costWith(Axis axis, int value) const {
        double least = std::numeric_limits<double>::infinity();
        for (const PossibleReading& candidate : candidates)
            if (valueOn(axis, candidate.reading) == value) least = std::min(least, candidate.cost);
        return least;
    }
    void keep(Axis axis, int value) {
        std::erase_if(candidates, [&](const PossibleReading& c) { return valueOn(axis, c.reading) != value; });
    }
    std::vector<int> valuesOn(Axis axis) const {
        std::vector<int> values;
        for (const PossibleReading& c : candidates)
            if (std::ranges::find(values, valueOn(axis, c.reading)) == values.end())
                values.push_back(valueOn(axis, c.reading));
        return values;
    }
};

double ratio(double next, double best) {
    return next == std::numeric_limits<double>::infinity() ? next : (next + kFloor) / (best + kFloor);
}

Convention said(const HandedFile& file, Axis axis, int value, Certainty certainty, double margin, bool own) {
    Convention out{file.name.text(), {}, {}, {}, certainty, margin, own};
    switch (axis) {
        case Rows:
            out.words = value ? "rows bottom-up" : "rows top-down";
            out.key = "rows", out.value = value ? "bottom-up" : "top-down";
            break;
        case Columns:
            out.words = value ? "columns right to left; if that is not meant, the picture is mirrored"
                              : "columns left to right";
            out.key = "columns", out.value = value ? "right-to-left" : "left-to-right";
            break;
        case Channels:
            out.words = value ? "channels BGR" : "channels RGB";
            out.key = "channels", out.value = value ? "bgr" : "rgb";
            break;
        default: {
            const CodingInfo& info = codingInfo(Coding(value));
            out.words = info.words, out.key = info.key, out.value = info.value;
        }
    }
    return out;
}

class Choosing {
public:
    Choosing(std::vector<Sounding> soundings, const StatedConventions& stated, Together together, Conventions& out)
        : m_soundings(std::move(soundings)), m_stated(stated), m_together(together == Together::Yes), m_out(out) {}

    void chooseAll() {
        state();
        for (const Axis axis : {Rows, Columns}) chooseTogether(axis);
        chooseHandedness();
        for (Sounding& sounding : m_soundings)
            for (const Axis axis : {Channels, Code}) chooseAlone(sounding, axis);
    }
    std::vector<Sounding>& soundings() { return m_soundings; }

private:
    void state() {
        for (Sounding& sounding : m_soundings) {
            const auto fix = [&](Axis axis, std::optional<bool> value) {
                if (!value || sounding.valuesOn(axis).size() < 2) return;
                sounding.keep(axis, *value);
                m_out.said.push_back(said(*sounding.file, axis, *value, Certainty::Stated, 1, !*value));
            };
            const StatedConventions stated = m_stated.of(*sounding.file);
            fix(Rows, stated.bottomUp);
            fix(Columns, stated.mirrored);
            fix(Channels, stated.bgr);
            for (const auto& [key, coding] : stated.codings) {
                // Else that is only asked where the rows run upwards.
                if (coding == Coding::FromTheFoot && sounding.file->name.buffer.id == BufferId::VerticesScreen)
                    sounding.candidates.assign(2, {{false, false, false, coding}, 0});
                const auto values = sounding.valuesOn(Code);
                const bool has = std::ranges::any_of(
                    values, [&wanted = key](int value) { return codingInfo(Coding(value)).key == wanted; });
                if (!has || sounding.candidates.size() < 2 || std::ranges::find(values, int(coding)) == values.end())
                    continue;
                sounding.keep(Code, int(coding));
                m_out.said.push_back(
                    said(*sounding.file, Code, int(coding), Certainty::Stated, 1, coding == Coding::AsIs));
            }
        }
    }

    // Rows and columns: a file that cannot tell follows the others.
    void chooseTogether(Axis axis) {
        double total[2] = {0, 0};
        std::vector<Sounding*> open;
        for (Sounding& sounding : m_soundings) {
            if (!sounding.isPicture || sounding.valuesOn(axis).size() < 2) continue;
            const double cost[2] = {sounding.costWith(axis, 0), sounding.costWith(axis, 1)};
            const int value = cost[1] < cost[0];
            const double margin = ratio(cost[!value], cost[value]);
            total[0] += cost[0], total[1] += cost[1];
            if (margin < kClear || m_together) {
                open.push_back(&sounding);
                continue;
            }
            sounding.keep(axis, value);
            if (value) m_out.said.push_back(said(*sounding.file, axis, value, Certainty::Clear, margin, false));
        }
        const int value = total[1] < total[0];
        const double margin = ratio(total[!value], total[value]);
        for (Sounding* sounding : open) {
            const bool agreed = margin >= (m_together ? kNearer : kClear);
            const bool alike = sounding->costWith(axis, 0) == sounding->costWith(axis, 1);
            sounding->keep(axis, agreed ? value : 0);
            if (agreed ? value != 0 : (axis == Rows || alike))
                m_out.said.push_back(said(*sounding->file, axis, agreed ? value : 0,
                                          agreed ? Certainty::Agreed : Certainty::CannotTell, margin, !agreed));
        }
    }

    // Of normals in view space z points away, or towards the viewer: in all of a folder's, whether of pixels, vertices or
    // polygons. Where they disagree and come as close, the first stage's decides.
    void chooseHandedness() {
        const auto costs = [](const Sounding& sounding) {
            std::array<double, 2> cost{kFarthestElement, kFarthestElement};
            for (const PossibleReading& one : sounding.candidates)
                if (const auto towards = pointsTowards(one.reading.coding))
                    cost[*towards] = std::min(cost[*towards], one.cost);
            return cost;
        };
        double total[2] = {0, 0};
        std::vector<Sounding*> inView;
        for (Sounding& sounding : m_soundings) {
            if (bufferInfo(sounding.file->name.buffer.id).palette != Palette::Direction) continue;
            if (sounding.candidates.size() < 2 || !pointsTowards(sounding.best().reading.coding)) continue;
            inView.push_back(&sounding);
            for (const int towards : {0, 1}) total[towards] += costs(sounding)[std::size_t(towards)];
        }
        if (inView.empty()) return;
        const bool less = total[1] < total[0];
        const bool taken =
            ratio(total[!less], total[less]) >= kNearer ? less : *pointsTowards(inView[0]->best().reading.coding);
        m_out.towardsViewer = taken;
        for (Sounding* const sounding : inView)
            std::erase_if(sounding->candidates, [&](const PossibleReading& one) {
                return pointsTowards(one.reading.coding) == std::optional(!taken);
            });
    }

    void chooseAlone(Sounding& sounding, Axis axis) {
        const std::vector<int> values = sounding.valuesOn(axis);
        if (values.size() < 2) return;
        const BufferId id = sounding.file->name.buffer.id;
        // Whether 1 is kept or dropped what is drawn of the polygons has to tell: see settleFlags.
        const bool open = id == BufferId::PolygonsVerdict;
        // Of depths in levels none is the program's own: the closest is taken.
        const bool hasOwn = axis != Code || values[0] == int(Coding::AsIs) || open;
        const double best = sounding.best().cost;
        const auto isClose = [&](int value) { return ratio(sounding.costWith(axis, value), best) < kClear; };
        // Those before it in the list explain less, so that they are the likelier where they explain as well.
        int taken = *std::ranges::find_if(values, isClose);
        if (open) taken = values[0];
        double next = std::numeric_limits<double>::infinity();
        for (const int other : values)
            if (other != taken && !(axis == Code && includes(Coding(other), Coding(taken))))
                next = std::min(next, sounding.costWith(axis, other));
        double margin = ratio(next, sounding.costWith(axis, taken));
        // Of readings that are equally far off nobody can tell.
        if (margin < kClear && hasOwn && best > kExplains) taken = values[0];
        // A gamma that no standard knows is an error, until it is stated; then it is not open.
        const bool isGamma = axis == Code && taken == int(Coding::Gamma22);
        if (isGamma) taken = values[0], margin = 1;
        const bool clear = margin >= kClear && !open;
        const bool own = taken == values[0] && hasOwn;
        // Normals in view space are a convention, or an error: they agree with either.
        if (axis == Code && !own && hasOwn && bufferInfo(id).palette == Palette::Direction)
            sounding.otherCodings.push_back(values[0]);
        // What is encoded is a known error too.
        if (id == BufferId::Color && axis == Code && !own) sounding.otherCodings.push_back(values[0]);
        if (!clear && !open && !isGamma)
            for (const int other : values)
                if (other != taken && isClose(other))
                    (axis == Channels ? sounding.otherChannels : sounding.otherCodings).push_back(other);
        sounding.keep(axis, taken);
        const int told = isGamma ? int(Coding::Gamma22) : taken;
        if (!own || isGamma)
            m_out.said.push_back(
                said(*sounding.file, axis, told, clear ? Certainty::Clear : Certainty::CannotTell, margin, false));
    }
    // Whether all that the one explains the other explains too, with more that it may choose.
    static bool includes(Coding wide, Coding narrow) {
        using enum Coding;
        if (wide == Permuted) return narrow == FromOne || narrow == AsIs;
        if (wide == CutAtZero) return narrow == AsIs;
        if (wide == WindowOfOwnPlanes)
            return narrow == Window || narrow == Ndc || narrow == Reversed || narrow == Inverse;
        if (wide == LinearOfOwnPlanes)
            return narrow == AsIs || narrow == MinusZ || narrow == Linear || narrow == LinearReversed;
        if (wide == Grey) return narrow == Linear;
        return wide == GreyReversed && narrow == LinearReversed;
    }

    std::vector<Sounding> m_soundings;
    const StatedConventions& m_stated;
    bool m_together;
    Conventions& m_out;
};

}  // namespace

namespace {

// What is covered and drawn by them too, where their files say that they draw clearly less; else nothing.
std::optional<std::vector<std::uint8_t>> drawnLess(const std::vector<Sounding>& soundings,
                                                   const ReferenceValues& reference, const ReadingContext& context) {
    for (const Sounding& sounding : soundings) {
        const Values& right = reference.at(sounding.file->name.buffer.text());
        if (right.domain != Domain::Pixel) continue;
        std::vector<std::uint8_t> drawn =
            drawnIn(sounding.file->name, sounding.numbers(sounding.best().reading, context, right));
        if (drawn.empty()) continue;
        std::size_t missing = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            missing += context.covered[i] && !drawn[i];
            drawn[i] = drawn[i] && context.covered[i];
        }
        if (100 * missing > drawn.size()) return drawn;
        return {};
    }
    return {};
}

}  // namespace

Conventions findConventions(const HandedIn& in, const ReferenceValues& reference, const ReadingContext& given,
                            const std::map<std::string, double>& tolerances, const StatedConventions& stated,
                            Together together) {
    Conventions out;
    out.context = given;
    for (const HandedFile& file : in.files)
        if (const auto background = backgroundOf(file, given)) {
            const auto& [r, g, b] = *background;
            out.said.push_back({file.name.text(), fmt::format("background {} {} {}", r, g, b), {}, {}});
            out.context.background = background;
        }
    const ReadingContext& context = out.context;
    std::vector<Sounding> soundings;
    const auto cost = [&](Sounding& sounding, const Reading& reading, const ReadingContext& where) {
        const HandedFile& file = *sounding.file;
        const std::string name = file.name.buffer.text();
        const Values& right = reference.at(name);
        Values mine = read(file, reading, context, right);
        const double found = readingCost(file, mine, right, where, tolerances.at(name));
        if (!sounding.nearest || found < sounding.nearestCost)
            sounding.nearest = std::make_shared<const std::pair<Reading, Values>>(reading, std::move(mine)),
            sounding.nearestCost = found;
        return found;
    };
    // Of a large picture a sample tells which readings are worth being compared whole.
    const PictureSample sample(context.width, context.height, kSampleColumns, kSampleRows);
    const ReadingContext some = sample.of(context);
    for (const HandedFile& file : in.files) {
        const std::string name = file.name.buffer.text();
        const Values& right = reference.at(name);
        Sounding sounding{&file, {}, right.domain == Domain::Pixel};
        const bool isSampled = sounding.isPicture && some.covered.size() < context.covered.size();
        const HandedFile few{file.name, file.path, isSampled ? sample.of(file.numbers) : NumberFile()};
        const Values fewRight = isSampled ? sample.of(right) : Values();
        for (const Reading& reading : readingsOf(file, context))
            sounding.candidates.push_back({reading, isSampled ? readingCost(few, read(few, reading, some, fewRight),
                                                                            fewRight, some, tolerances.at(name))
                                                              : cost(sounding, reading, context)});
        const double best = sounding.best().cost;
        for (PossibleReading& one : sounding.candidates)
            if (isSampled && ratio(one.cost, best) <= kClear) one.cost = cost(sounding, one.reading, context);
        soundings.push_back(std::move(sounding));
    }
    const std::vector<Convention> before = out.said;
    std::optional<Choosing> choosing;
    choosing.emplace(soundings, stated, together, out).chooseAll();
    if (const auto drawn = drawnLess(choosing->soundings(), reference, context)) {
        // Where they draw nothing, their numbers of it stand for nothing either.
        ReadingContext less = context;
        less.covered = *drawn;
        for (Sounding& sounding : soundings) {
            const bool says = !drawnIn(sounding.file->name, reference.at(sounding.file->name.buffer.text())).empty();
            if (sounding.isPicture && !says)
                for (PossibleReading& one : sounding.candidates) one.cost = cost(sounding, one.reading, less);
        }
        out.said = before;
        choosing.emplace(std::move(soundings), stated, together, out).chooseAll();
    }
    soundings.clear();  // with the numbers of readings that are not taken
    for (Sounding& sounding : choosing->soundings()) {
        const Reading reading = sounding.best().reading;
        std::vector<Reading> others;
        const auto with = [&](Reading other, int channels) {
            other.bgr = channels != 0;
            if (other != reading) others.push_back(other);
        };
        std::vector<int> channels = sounding.otherChannels;
        channels.push_back(reading.bgr);
        for (const int bgr : channels) {
            with(reading, bgr);
            for (const int coding : sounding.otherCodings) {
                Reading other = reading;
                other.coding = Coding(coding);
                with(other, bgr);
            }
        }
        const Values& right = reference.at(sounding.file->name.buffer.text());
        out.files.push_back({sounding.file, reading, sounding.numbers(reading, context, right), std::move(others)});
        sounding.nearest.reset();
    }
    return out;
}

}  // namespace pipeline::foreign
