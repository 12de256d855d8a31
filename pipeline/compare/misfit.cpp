#include "pipeline/compare/misfit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/compare/handed_in/reading_cost.h"

namespace pipeline::foreign {

namespace {

constexpr std::size_t kSampleColumns = 72, kSampleRows = 54;
constexpr double kAsGood =
    0.005;  // of the sample: readings that are as good as the best; the simplest of them is taken
constexpr std::size_t kLarge = 320 * 240;  // pixels: the values of buffers of more are read twice instead of kept
constexpr double kWorthAsking =
    0.02;  // of the sample: orders of rows and columns so close to the best are compared whole

bool isNames(BufferId id) { return toleranceOf(id)->measure == Measure::Same; }

// Blocks of factor × factor pixels as one, their mean; of names the first.
NumberFile smaller(const NumberFile& of, std::size_t factor, bool names) {
    NumberFile out = of;
    const std::size_t channels = of.channels(), columns = of.columns() / factor, rows = of.rows() / factor;
    out.shape[0] = rows, out.shape[1] = columns;
    out.values.assign(rows * columns * channels, 0);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        const std::size_t c = i % channels, x = i / channels % columns * factor, y = i / channels / columns * factor;
        double sum = 0;
        const std::size_t side = names ? 1 : factor;
        for (std::size_t v = 0; v < side; ++v)
            for (std::size_t u = 0; u < side; ++u) sum += of.values[((y + v) * of.columns() + x + u) * channels + c];
        out.values[i] = sum / double(side * side);
    }
    return out;
}

// Whether a coding leaves at least half of the numbers out that are not the commonest: then it fits whatever draws nothing.
bool isEmptyReading(const HandedFile& file, const Values& mine) {
    if (file.name.buffer.id != BufferId::ZView) return false;
    std::map<double, std::size_t> counts;
    for (const double v : file.numbers.values)
        if (std::isfinite(v)) ++counts[v];
    if (counts.empty()) return false;
    const auto commonest = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    std::size_t others = file.numbers.values.size() - commonest->second;
    std::size_t read = 0;
    for (const std::uint8_t there : mine.there) read += there;
    return 2 * read < others;
}

}  // namespace

FolderEvidence::FolderEvidence(const Conventions& conventions, const StatedConventions& stated, const Reference& right,
                               std::size_t factor)
    : m_factor(factor), m_context(conventions.context) {
    const std::size_t width = m_context.width / factor, height = m_context.height / factor;
    m_context.width = width, m_context.height = height, m_context.unrounded.clear();
    m_context.view = scaled(m_context.view, 1 / double(factor), 1 / double(factor));
    if (factor > 1) m_context.covered.assign(width * height, 0);  // nobody reads them there
    m_sample = PictureSample(width, height, kSampleColumns, kSampleRows);
    m_sampleContext = m_sample.of(m_context);
    m_drawn = 0;
    for (const std::uint8_t covered : right.context.covered) m_drawn += covered;
    m_drawn = std::max(1.0, m_drawn / double(factor * factor));
    bool isStated[2] = {stated.bottomUp.has_value(), stated.mirrored.has_value()};
    for (const bool mirrored : {false, true})
        for (const bool bottomUp : {false, true})
            if (!(isStated[0] && *stated.bottomUp != bottomUp) && !(isStated[1] && *stated.mirrored != mirrored))
                m_geometries.push_back({bottomUp, mirrored});
    for (const ReadFile& read : conventions.files) {
        const HandedFile& whole = *read.file;
        Testimony one;
        const BufferName& name = whole.name.buffer;
        const Values& values = right.values.at(name.text());
        one.isPicture = values.domain == Domain::Pixel;
        // What a shadow buffer leads to, S, tells more; counts of fragments depend on who is cut where.
        one.counts = name.id != BufferId::ShadowBuffer && name.id != BufferId::Overdraw;
        one.tolerance = right.tolerances.at(name.text()), one.elements = values.count();
        one.readings = allowedReadings(whole, conventions.context, stated);
        if (one.isPicture && factor > 1)
            one.file = std::make_shared<const HandedFile>(
                HandedFile{whole.name, whole.path, smaller(whole.numbers, factor, isNames(name.id))});
        else
            one.file = std::shared_ptr<const HandedFile>(std::shared_ptr<const void>(), &whole);
        if (one.isPicture) {
            one.sample = {whole.name, whole.path, m_sample.of(one.file->numbers)};
            const Values some =
                PictureSample(values.columns, values.rows, m_sample.columns.size(), m_sample.rows.size()).of(values);
            std::erase_if(one.readings, [&](const Reading& reading) {
                return one.readings.size() > 1 &&
                       isEmptyReading(one.sample, foreign::read(one.sample, reading, m_sampleContext, some));
            });
            if (one.readings.empty()) one.readings = {read.reading};
        }
        m_files.push_back(std::move(one));
    }
}

BufferSet FolderEvidence::compared() const {
    BufferSet out;
    for (const Testimony& one : m_files) out.set(index(one.file->name.buffer.id));
    return out;
}

double FolderEvidence::sampledWrong(const Testimony& one, const Reading& reading, const Values& right,
                                    const std::vector<std::uint8_t>& covered) const {
    const Values mine = read(one.sample, reading, m_sampleContext, right);
    const Measure measure = toleranceOf(one.file->name.buffer.id)->measure;
    const std::vector<std::uint8_t> drawn = drawnIn(one.file->name, mine);
    std::size_t wrong = 0, either = 0;
    for (std::size_t i = 0; i < mine.count(); ++i) {
        const bool here = drawn.empty() ? mine.there[i] && covered[i] : drawn[i] != 0, there = covered[i] != 0;
        if (!here && !there) continue;
        ++either;
        if (here != there)
            wrong += !drawn.empty();
        else
            wrong += !(differenceAt(measure, mine, right, i) <= mine.allowed(i, one.tolerance));
    }
    return either ? double(wrong) / double(either) : 0;
}

Reading FolderEvidence::bestOnSample(const Testimony& one, const Geometry& geometry, const Values& right,
                                     const std::vector<std::uint8_t>& covered, double& least) const {
    std::vector<std::pair<Reading, double>> tried;
    for (Reading reading : one.readings) {
        if (reading.bottomUp != geometry.bottomUp || reading.mirrored != geometry.mirrored) continue;
        tried.push_back({reading, sampledWrong(one, reading, right, covered)});
    }
    if (tried.empty()) {  // stated of this file alone
        least = 1;
        return one.readings.front();
    }
    least = 1;
    for (const auto& [reading, wrong] : tried) least = std::min(least, wrong);
    return std::ranges::find_if(tried, [&](const auto& t) { return t.second <= least + kAsGood; })->first;
}

double FolderEvidence::wrongIn(const Testimony& one, const Reading& reading, const Reference& hypothesis) const {
    const std::string name = one.file->name.buffer.text();
    if (!one.counts) return 0;
    const Values* const values = hypothesis.values.find(name);
    if (!values || (!one.isPicture && values->count() != one.elements)) return m_drawn;
    Values enlarged;
    if (m_factor > 1 && one.file->name.buffer.id == BufferId::VerticesScreen) {
        enlarged = *values;
        for (std::size_t v = 0; v < enlarged.count(); ++v)
            enlarged.at(v)[0] *= double(m_factor), enlarged.at(v)[1] *= double(m_factor);
    }
    const Values& right = enlarged.numbers.empty() ? *values : enlarged;
    ReadingContext encoded;
    const bool isEncoded = one.file->name.buffer.id == BufferId::Color && reading.coding != Coding::AsIs;
    if (isEncoded) {
        encoded = m_context;
        encoded.unrounded = hypothesis.context.unrounded, encoded.iMax = hypothesis.context.iMax;
    }
    const ReadingContext& context = isEncoded ? encoded : m_context;
    ReadFile file{one.file.get(), reading, read(*one.file, reading, context, right)};
    const Finding finding = compareValues(file, right, hypothesis);
    if (one.isPicture) return forgetLarge(one, hypothesis), double(finding.bad());
    return finding.compared ? m_drawn * double(finding.bad()) / double(finding.compared) : 0;
}

void FolderEvidence::forgetLarge(const Testimony& one, const Reference& hypothesis) const {
    const BufferName& buffer = one.file->name.buffer;
    if (m_context.width * m_context.height > kLarge && buffer.id != BufferId::PolygonId)  // it is asked pixel by pixel
        hypothesis.values.forget(buffer.text());
}

Misfit FolderEvidence::misfit(const Reference& hypothesis) const {
    struct Tried {
        Misfit misfit;
        double least = 0;
    };
    const std::vector<std::uint8_t> covered = m_sample.of(hypothesis.context.covered, m_context.width);
    std::vector<Tried> tried(m_geometries.size());
    for (std::size_t g = 0; g < tried.size(); ++g) tried[g].misfit.geometry = m_geometries[g];
    for (const Testimony& one : m_files) {
        const Values* const values =
            one.isPicture && one.counts ? hypothesis.values.find(one.file->name.buffer.text()) : nullptr;
        const bool isThere = values != nullptr;
        const Values some = isThere ? m_sample.of(*values) : Values();
        if (isThere) forgetLarge(one, hypothesis);
        for (Tried& t : tried) {
            double least = 0;
            t.misfit.readings.push_back(isThere ? bestOnSample(one, t.misfit.geometry, some, covered, least)
                                                : one.readings.front());
            t.least += least;
        }
    }
    const double least = std::ranges::min_element(tried, {}, &Tried::least)->least;
    std::vector<std::size_t> all(m_files.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::optional<Misfit> best;
    for (Tried& t : tried) {
        if (t.least > least + kWorthAsking) continue;
        Misfit& one = t.misfit;
        for (std::size_t i = 0; i < m_files.size(); ++i) {
            const Testimony& file = m_files[i];
            one.wrong.push_back(HUGE_VAL);
            if (file.isPicture) {
                one.wrong[i] = wrongIn(file, one.readings[i], hypothesis);
                continue;
            }
            for (const Reading& reading : file.readings) {
                const bool isUp = reading.coding == Coding::FromTheFoot;  // where the rows run upwards, or it is stated
                if (isUp && !one.geometry.bottomUp && file.readings.size() > 1) continue;
                const double wrong = wrongIn(file, reading, hypothesis);
                if (wrong < one.wrong[i]) one.wrong[i] = wrong, one.readings[i] = reading;
            }
        }
        if (!best || one.sum(all) < best->sum(all)) best = std::move(one);
    }
    for (const std::uint8_t drawn : hypothesis.context.covered) best->drawn += drawn;
    return std::move(*best);
}

}  // namespace pipeline::foreign
