#include "pipeline/compare/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pipeline/run/runner.h"

namespace pipeline::foreign {

namespace {

constexpr double kPixels = 320 * 240;   // of the picture that hypotheses are ranked in
constexpr std::size_t kConfirmed = 5;   // in the picture's own size
constexpr double kSameFloor = 0.35;     // tolerances: what rounding to bytes leaves
constexpr double kClearlyBetter = 2;    // times as close as the next
constexpr double kExplains = 18;        // times as close as the right renderer
constexpr double kFits = 0.9;           // tolerances: what fits whatever the right renderer is off
constexpr double kFitsAtMost = 1.5;     // tolerances: what fits, however far off the right renderer is
constexpr double kMissingCost = 100;    // tolerances
constexpr double kTrimmedShare = 0.03;  // of the pixels that are wrong, the farthest: rasterizers differ
constexpr double kNoise = 1;            // tolerances: what two right renderers differ by

// A picture of fewer pixels: blocks of factor × factor as one, their mean.
Values smaller(const Values& of, std::size_t factor, bool names) {
    if (factor == 1 || of.domain != Domain::Pixel) return of;
    Values out{of.domain, of.rows / factor, of.columns / factor, of.channels, {}, {}};
    out.numbers.assign(out.count() * std::size_t(out.channels), 0);
    out.there.assign(out.count(), 1);
    if (!of.slack.empty()) out.slack.assign(out.count(), 0);
    const double share = 1.0 / double(factor * factor);
    for (std::size_t i = 0; i < out.count(); ++i) {
        const std::size_t x = i % out.columns * factor, y = i / out.columns * factor, first = y * of.columns + x;
        for (std::size_t v = 0; v < factor; ++v)
            for (std::size_t u = 0; u < factor; ++u) {
                const std::size_t from = first + v * of.columns + u;
                if (!of.there[from] || (names && of.at(from)[0] != of.at(first)[0])) out.there[i] = 0;
                for (int c = 0; c < of.channels; ++c) out.at(i)[c] += names ? 0 : share * of.at(from)[c];
                if (!of.slack.empty()) out.slack[i] = std::max(out.slack[i], of.slack[from]);
            }
        if (names) out.at(i)[0] = of.at(first)[0];
    }
    return out;
}

Scene smaller(Scene scene, std::size_t factor) {
    scene.settings.width = std::max(1, scene.settings.width / int(factor));
    scene.settings.height = std::max(1, scene.settings.height / int(factor));
    scene.camera.pixelsPerUnit /= double(factor);
    scene.settings.shadowSize = std::min(scene.settings.shadowSize, 512);
    return scene;
}

bool isNames(BufferId id) { return toleranceOf(id)->measure == Measure::Same; }

// Pixels next to another polygon, or at the edge of a shadow: right renderers differ there.
std::vector<std::uint8_t> openPixels(const Frame& frame) {
    std::vector<std::uint8_t> open;
    const auto mark = [&](const Values& values) {
        open.resize(values.count(), 0);
        const std::size_t w = values.columns;
        for (std::size_t i = 0; i < values.count(); ++i) {
            const bool right = i % w + 1 < w && values.numbers[i] != values.numbers[i + 1];
            const bool down = i + w < values.count() && values.numbers[i] != values.numbers[i + w];
            if (right) open[i] = open[i + 1] = 1;
            if (down) open[i] = open[i + w] = 1;
        }
    };
    if (const auto ids = valuesIn(frame, {BufferId::PolygonId})) mark(*ids);
    for (std::size_t k = 0; k < frame.scene().lights.size(); ++k)
        if (frame.scene().lights[k].castsShadow)
            if (const auto s = valuesIn(frame, {BufferId::Shadow, int(k)})) mark(*s);
    return open;
}

// A file's values with the rows in either order; for vertices and polygons they are the same.
struct Evidence {
    const HandedFile* file;
    double tolerance;
    bool differs;                   // from the reference
    const Finding* finding;         // in the picture's own size; null in a smaller one
    const Values* right = nullptr;  // of the reference; null likewise
    double wrong;                   // elements that are, at least a thousandth of all
    // With the rows from the top and from the bottom, each in all readings that the file may have.
    std::array<std::vector<Values>, 2> mine;
};

class Court {
public:
    Court(const Reference& reference, const Conventions& conventions, const std::vector<Finding>& findings,
          std::size_t factor)
        : m_factor(factor),
          m_corner(factor == 1 ? reference.corner : PixelCorner::None),
          m_rowsAreStated(conventions.geometryIsStated) {
        std::size_t bottomUp = 0, pictures = 0;
        for (std::size_t i = 0; i < conventions.files.size(); ++i) {
            const ReadFile& file = conventions.files[i];
            const BufferName& name = file.file->name.buffer;
            const Values& right = reference.values.at(name.text());
            const bool picture = right.domain == Domain::Pixel;
            const double wrong = std::max(double(findings[i].bad()), 0.001 * double(findings[i].compared));
            Evidence one{file.file,
                         reference.tolerances.at(name.text()),
                         !findings[i].agrees,
                         factor == 1 ? &findings[i] : nullptr,
                         factor == 1 ? &right : nullptr,
                         std::max(1.0, picture ? wrong / double(factor * factor) : wrong),
                         {}};
            std::vector<Reading> readings = file.others;
            readings.insert(readings.begin(), file.reading);
            for (const bool up : {false, true})
                for (Reading reading : readings) {
                    if (picture) reading.bottomUp = up;
                    const Values mine =
                        reading == file.reading ? file.mine : read(*file.file, reading, conventions.context, right);
                    // One in which hardly anything is there fits whatever leaves nothing.
                    const auto there = std::ranges::count(mine.there, 1),
                               taken = std::ranges::count(file.mine.there, 1);
                    if (reading.coding != file.reading.coding && 2 * there < taken) continue;
                    one.mine[up].push_back(smaller(mine, factor, isNames(name.id)));
                }
            pictures += picture, bottomUp += picture && file.reading.bottomUp;
            m_wanted.set(index(name.id));
            m_evidence.push_back(std::move(one));
        }
        m_taken = 2 * bottomUp > pictures;
        for (const BufferId id : {BufferId::PolygonId, BufferId::Shadow, BufferId::VerticesView})
            m_wanted.set(index(id));
    }
    BufferId bufferOf(std::size_t file) const { return m_evidence[file].file->name.buffer.id; }
    bool takenRows() const { return m_taken; }  // whether most pictures are read bottom-up

    // Of each file the distance with the rows from the top and from the bottom; infinite where it cannot be compared.
    using Distances = std::vector<std::array<double, 2>>;
    // The first scene is the right one: what the frames of the others have in common with its frame serves again.
    std::optional<Distances> of(const Scene& scene, const Stop& stop) {
        const Scene sized = m_factor == 1 ? scene : smaller(scene, m_factor);
        const FramePtr frame =
            runFrame(referenceScene(sized, m_corner), {m_wanted, StageId::Shading, 0, stop}, m_first);
        if (!frame) return {};
        if (!m_first) m_first = frame;
        const std::vector<std::uint8_t> open = openPixels(*frame);
        Distances out(m_evidence.size(), {HUGE_VAL, HUGE_VAL});
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Evidence& one = m_evidence[i];
            // What a shadow buffer leads to, S, tells more; counts of fragments depend on who is cut where.
            const BufferId id = one.file->name.buffer.id;
            if (id == BufferId::ShadowBuffer || id == BufferId::Overdraw) {
                out[i] = {0, 0};
                continue;
            }
            auto values = valuesIn(*frame, one.file->name.buffer);
            if (!values || !values->isSameSize(one.mine[0][0])) continue;
            if (one.file->name.buffer.id == BufferId::VerticesScreen)
                for (std::size_t v = 0; v < values->count(); ++v)
                    values->at(v)[0] *= double(m_factor), values->at(v)[1] *= double(m_factor);
            for (const bool up : {false, true}) {
                if (m_rowsAreStated && up != m_taken) continue;
                for (const Values& mine : one.mine[up])
                    out[i][up] = std::min(out[i][up], distance(one, mine, *values, open));
            }
        }
        return out;
    }

private:
    double distance(const Evidence& one, const Values& mine, const Values& right,
                    const std::vector<std::uint8_t>& open) const {
        const Measure measure = toleranceOf(one.file->name.buffer.id)->measure;
        const bool picture = right.domain == Domain::Pixel;
        const bool says = !drawnIn(one.file->name, mine).empty();
        // Of a pixel of theirs and one of ours; nothing where nobody says whether there is something.
        const auto between = [&](std::size_t i, std::size_t j) -> std::optional<double> {
            const bool here = mine.there[i] != 0, there = right.there[j] != 0;
            if (!here && !there) return 0;
            if (here != there) return picture && says ? std::optional(kMissingCost) : std::nullopt;
            // Its frames are rounded to the buffer's own steps, however fine the file's.
            const double allowed = std::max(one.tolerance, mine.allowed(i, one.tolerance));
            const double d = differenceBetween(measure, mine, i, right, j);
            return measure == Measure::Same ? d * kMissingCost : std::min(kMissingCost, d / allowed);
        };
        std::vector<double> squares;
        const std::size_t width = right.columns;
        std::size_t undecided = 0;
        for (std::size_t i = 0; i < right.count(); ++i) {
            if (!mine.there[i] && !right.there[i]) continue;
            std::optional<double> d = between(i, i);
            if (!d) {
                ++undecided;
                continue;
            }
            // A border may be a pixel off, but not where this is already known to be no border's doing.
            if (picture && open[i] && *d > 0 && !isKnownWrong(one, right, i)) {
                const std::size_t x = i % width, y = i / width;
                for (std::size_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, right.rows - 1); ++v)
                    for (std::size_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, width - 1); ++u)
                        if (const auto other = between(i, v * width + u)) d = std::min(*d, *other);
            }
            const double beyond = std::max(0.0, *d - kNoise);
            squares.push_back(beyond * beyond);
        }
        if (squares.empty()) return picture && undecided > 0 ? kMissingCost : 0;
        // As many as may be astray in a buffer that agrees, but of few that are wrong only a part.
        double astray = picture ? std::max(2.0, kStrayPixels * double(squares.size())) : 0;
        if (one.differs) astray = std::min(0.2 * one.wrong, astray + kTrimmedShare * one.wrong);
        const auto trimmed = std::min(squares.size() - 1, std::size_t(picture ? astray : 0));
        std::ranges::nth_element(squares, squares.end() - std::ptrdiff_t(trimmed) - 1);
        double sum = 0;
        for (std::size_t i = 0; i + trimmed < squares.size(); ++i) sum += squares[i];
        return std::sqrt(sum / one.wrong);
    }

    // Whether a pixel is wrong and the hypothesis has there what the right renderer has.
    static bool isKnownWrong(const Evidence& one, const Values& right, std::size_t i) {
        if (!one.finding) return false;
        const Class of = one.finding->classes[i];
        if (of != Class::Wrong && of != Class::Missing && of != Class::Extra) return false;
        if (!right.there[i] || !one.right->there[i]) return right.there[i] == one.right->there[i];
        return differenceAt(toleranceOf(one.file->name.buffer.id)->measure, right, *one.right, i) <= one.tolerance;
    }

    std::size_t m_factor;
    PixelCorner m_corner;  // in a smaller picture that is a part of a pixel
    bool m_rowsAreStated, m_taken = false;
    BufferSet m_wanted;
    std::vector<Evidence> m_evidence;
    FramePtr m_first;
};

// All known errors of a scene and how far each is from each file, measured once.
class Trial {
public:
    Trial(const Scene& scene, const Reference& reference, const Conventions& conventions,
          const std::vector<Finding>& findings)
        : m_scene(scene),
          m_reference(reference),
          m_errors(knownErrors(scene)),
          m_factor(factorOf(scene)),
          m_small(reference, conventions, findings, m_factor),
          m_full(reference, conventions, findings, 1) {}

    std::size_t count() const { return m_errors.size(); }
    // False where it was stopped.
    bool measure(const Stop& stop, const HypothesisProgress& progress) {
        auto right = m_full.of(m_scene, stop);
        if (!right || !m_small.of(m_scene, stop)) return false;
        m_right = std::move(*right);
        for (const KnownError& error : m_errors) {
            if (progress) progress(m_distances.size(), m_errors.size());
            auto distances = m_small.of(error.plant(m_scene), stop);
            if (!distances) return false;
            m_distances.push_back(left(error, std::move(*distances)));
        }
        return true;
    }

    // What explains these files.
    Suspects judge(const std::vector<std::size_t>& files, const Stop& stop) {
        Suspects out;
        out.tried = m_errors.size();
        out.right = worst(m_right, files, m_full.takenRows());
        std::vector<std::pair<Candidate, std::size_t>> ranked;
        for (std::size_t i = 0; i < m_errors.size(); ++i) ranked.push_back({candidate(i, m_distances[i], files), i});
        const auto byDistance = [](const auto& one) { return one.first.distance; };
        std::ranges::stable_sort(ranked, {}, byDistance);
        // The best way of each error stands for it.
        std::vector<std::pair<Candidate, std::size_t>> best;
        for (auto& one : ranked)
            if (best.size() < kConfirmed &&
                std::ranges::none_of(best, [&](const auto& b) { return b.first.error.id == one.first.error.id; }))
                best.push_back(std::move(one));
        for (auto& [one, i] : best) {
            if (m_factor > 1) {
                if (!m_confirmed.contains(i)) {
                    auto distances = m_full.of(m_errors[i].plant(m_scene), stop);
                    if (!distances) return out.stopped = true, out;
                    m_confirmed[i] = left(m_errors[i], std::move(*distances));
                }
                one = candidate(i, m_confirmed[i], files);
            }
            one.explained = out.right > 0 ? 1 - (one.distance * one.distance) / (out.right * out.right) : 0;
        }
        // Of those that fit equally well the rows of the program's own convention are the likelier.
        std::ranges::stable_sort(best, [&](const auto& a, const auto& b) {
            const double nearer = std::max(a.first.distance, kSameFloor),
                         other = std::max(b.first.distance, kSameFloor);
            const bool upA = a.first.otherRows != m_full.takenRows(), upB = b.first.otherRows != m_full.takenRows();
            // Then those that fit more of the files.
            const std::size_t missesA = misses(a.second, a.first), missesB = misses(b.second, b.first);
            return std::tuple(nearer, upA, missesA, a.first.distance) <
                   std::tuple(other, upB, missesB, b.first.distance);
        });
        if (best.empty()) return out;
        const double nearest = best[0].first.distance, least = std::max(nearest, kSameFloor);
        const double fits = std::clamp(out.right / kExplains, kFits, kFitsAtMost);
        const bool does = nearest <= fits && nearest < out.right / 2;
        for (auto& [one, i] : best) {
            if (does && one.distance < kClearlyBetter * least && one.distance < out.right / 2)
                out.candidates.push_back(std::move(one));
            else if (!out.next)
                out.next = std::move(one);
        }
        if (out.candidates.size() > 1) out.experiment = experimentBetween(out.candidates, m_scene, m_reference, stop);
        return out;
    }

private:
    static std::size_t factorOf(const Scene& scene) {
        const double pixels = double(scene.settings.width) * scene.settings.height;
        return std::max<std::size_t>(1, std::size_t(std::sqrt(pixels / kPixels) + 0.01));
    }
    // With the right renderer's where the error leaves a buffer right.
    Court::Distances left(const KnownError& error, Court::Distances distances) const {
        for (std::size_t i = 0; i < distances.size(); ++i)
            if (std::ranges::find(error.leaves, m_full.bufferOf(i)) != error.leaves.end()) distances[i] = m_right[i];
        return distances;
    }
    std::size_t misses(std::size_t i, const Candidate& one) const {
        const auto confirmed = m_confirmed.find(i);
        const Court::Distances& distances = confirmed != m_confirmed.end() ? confirmed->second : m_distances[i];
        const bool up = one.otherRows != m_full.takenRows();
        return std::size_t(std::ranges::count_if(distances, [&](const auto& d) { return d[up] > kFits; }));
    }
    static double worst(const Court::Distances& distances, const std::vector<std::size_t>& files, bool up) {
        double out = 0;
        for (const std::size_t i : files) out = std::max(out, distances[i][up]);
        return out;
    }
    Candidate candidate(std::size_t i, const Court::Distances& distances, const std::vector<std::size_t>& files) const {
        Candidate one{m_errors[i]};
        const bool taken = m_full.takenRows();
        const double as = worst(distances, files, taken), turned = worst(distances, files, !taken);
        one.otherRows = turned < as / kClearlyBetter;
        one.distance = one.otherRows ? turned : as;
        return one;
    }

    const Scene& m_scene;
    const Reference& m_reference;
    std::vector<KnownError> m_errors;
    std::size_t m_factor;
    Court m_small, m_full;
    std::vector<Court::Distances> m_distances;  // of each error, in the small picture
    Court::Distances m_right;
    std::map<std::size_t, Court::Distances> m_confirmed;
};

// Which files have to fit where a stage is known to be wrong first: what comes before, and its own that differs. What
// follows depends on more of their program.
std::vector<std::vector<std::size_t>> focusOn(const std::vector<Finding>& findings, StageId wrong,
                                              const std::vector<std::size_t>& wrongHere) {
    std::vector<std::vector<std::size_t>> out;
    for (const std::size_t i : wrongHere) {
        if (findings[i].stage != wrong) continue;
        std::vector<std::size_t> files;
        for (std::size_t before = 0; before < i; ++before)
            if (findings[before].stage < wrong || findings[before].agrees) files.push_back(before);
        files.push_back(i);
        out.push_back(std::move(files));
        if (wrong == StageId::Shading) break;  // its terms follow from each other
    }
    return out;
}

}  // namespace

Suspects findSuspects(const Scene& scene, const Reference& reference, const Conventions& conventions,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress) {
    Trial trial(scene, reference, conventions, findings);
    Suspects stopped;
    stopped.stopped = true;
    if (!trial.measure(stop, progress)) return stopped;
    std::vector<std::size_t> all(findings.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    Suspects out = trial.judge(all, stop);
    if (!out.candidates.empty() || out.stopped || !first.stage) return out;
    for (const std::vector<std::size_t>& files : focusOn(findings, *first.stage, first.wrongHere)) {
        Suspects focused = trial.judge(files, stop);
        if (!focused.candidates.empty() || focused.stopped) return focused;
    }
    // The picture alone: files may be written before the error is made, or after.
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (findings[i].name.buffer.id != BufferId::Color || findings[i].agrees) continue;
        Suspects focused = trial.judge({i}, stop);
        if (focused.stopped) return focused;
        std::erase_if(focused.candidates, [&](const Candidate& c) { return c.error.stage != first.stage; });
        if (focused.candidates.size() == 1) return focused.experiment.reset(), focused;
    }
    return out;
}

}  // namespace pipeline::foreign
