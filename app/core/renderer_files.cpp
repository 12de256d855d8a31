#include "app/core/renderer_files.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/core/text.h"
#include "pipeline/buffers/verdict.h"
#include "pipeline/compare/compare_text.h"

namespace app {

namespace foreign = pipeline::foreign;
using pipeline::BufferId;

namespace {

constexpr int kMostWatched = 10000;  // as many as are read

QString stampOfFile(const QFileInfo& file) {
    return QStringLiteral("%1 %2 %3\n")
        .arg(file.absoluteFilePath())
        .arg(file.size())
        .arg(file.lastModified().toMSecsSinceEpoch());
}

// The key of a line "key = value"; empty of another line.
std::string keyOfLine(const std::string& line) {
    const auto equals = line.find('=');
    if (equals == line.npos) return {};
    const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t", equals - 1);
    return first >= equals ? std::string() : line.substr(first, last - first + 1);
}

// What a reading says for every key that it has a value for.
std::vector<std::pair<std::string, std::string>> valuesOf(const foreign::Reading& reading, bool isPicture,
                                                          bool hasChannels, const std::string& codingKey) {
    std::vector<std::pair<std::string, std::string>> values;
    if (isPicture) values.emplace_back("rows", reading.bottomUp ? "bottom-up" : "top-down");
    if (isPicture) values.emplace_back("columns", reading.mirrored ? "right-to-left" : "left-to-right");
    if (hasChannels) values.emplace_back("channels", reading.bgr ? "bgr" : "rgb");
    if (codingKey.empty()) return values;
    const foreign::CodingInfo& coding = codingInfo(reading.coding);
    values.emplace_back(codingKey, coding.key.empty() ? "own" : std::string(coding.value));
    return values;
}

void addOnce(std::vector<std::string>& values, const std::string& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
}

// Theirs says kept or dropped and gives no reason: it has ours where the two agree.
pipeline::Verdict verdictOf(bool kept, double ours) {
    const auto reference = static_cast<pipeline::Verdict>(int(ours));
    if (goesOn(reference) == kept) return reference;
    return kept ? pipeline::Verdict::Kept : pipeline::Verdict::BackFacing;
}

template <class T>
void fill(pipeline::AnyBuffer& buffer, const std::vector<double>& numbers) {
    auto made = std::make_shared<std::vector<T>>(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if constexpr (std::is_integral_v<T>) {
            constexpr double kLow = std::numeric_limits<T>::lowest(), kHigh = std::numeric_limits<T>::max();
            (*made)[i] = std::isnan(numbers[i]) ? T(0) : T(std::lround(std::clamp(numbers[i], kLow, kHigh)));
        } else
            (*made)[i] = T(numbers[i]);
    }
    buffer.data = std::span<const T>(*made);
    buffer.owner = std::move(made);
}

}  // namespace

QString stampOf(const QStringList& paths) {
    QString stamp;
    for (const QString& path : paths) {
        const QFileInfo info(path);
        if (!info.isDir()) {
            if (info.exists()) stamp += stampOfFile(info);
            continue;
        }
        const QFileInfoList files = QDir(path).entryInfoList(QDir::Files, QDir::Name);
        for (const QFileInfo& file : files.first(std::min<qsizetype>(files.size(), kMostWatched)))
            stamp += stampOfFile(file);
    }
    return stamp;
}

std::string withStated(const std::string& text, const StatedByHand& byHand) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (!byHand.contains(keyOfLine(line))) out += line + '\n';
        at = end + 1;
    }
    for (const auto& [key, value] : byHand) out += key + " = \"" + value + "\"\n";
    return out;
}

std::vector<ConventionChoice> conventionChoices(const foreign::Report& report) {
    std::vector<ConventionChoice> choices;
    for (const foreign::ReadFile& file : report.conventions.files) {
        const auto readings = readingsOf(*file.file, report.reference->context);
        const bool isPicture = bufferInfo(file.file->name.buffer.id).domain == pipeline::Domain::Pixel;
        const bool hasChannels = file.file->name.buffer.id == BufferId::Color;
        // Encodings, depths, normals: a file has codings of one key at most, beside the program's own.
        std::string codingKey;
        for (const foreign::Reading& reading : readings)
            if (const auto key = codingInfo(reading.coding).key; !key.empty()) codingKey = key;
        for (const auto& [key, now] : valuesOf(file.reading, isPicture, hasChannels, codingKey)) {
            auto choice = std::ranges::find(choices, key, &ConventionChoice::key);
            if (choice == choices.end()) choice = choices.insert(choice, {key, now, {}, {}, {}});
            for (const foreign::Reading& reading : readings)
                for (const auto& [otherKey, value] : valuesOf(reading, isPicture, hasChannels, codingKey))
                    if (otherKey == key) addOnce(choice->values, value);
            const auto said = std::ranges::find_if(report.conventions.said, [&](const foreign::Convention& one) {
                return one.key == key && one.buffer == file.file->name.text();
            });
            if (said == report.conventions.said.end()) continue;
            // Of several files the first that can tell is named with how clear it is.
            if (choice->certainty.isEmpty() || said->certainty == foreign::Certainty::Clear) {
                if (choice->buffers.isEmpty() || choice->value != now) choice->value = now;
                choice->certainty = toQString(certaintyText(*said));
            }
            choice->buffers += (choice->buffers.isEmpty() ? "" : ", ") + toQString(said->buffer);
        }
    }
    std::erase_if(choices, [](const ConventionChoice& choice) { return choice.values.size() < 2; });
    std::ranges::stable_partition(choices, [](const ConventionChoice& choice) { return !choice.certainty.isEmpty(); });
    return choices;
}

std::optional<pipeline::AnyBuffer> handedBuffer(const foreign::Report& report, const pipeline::AnyBuffer& like) {
    const auto file = std::ranges::find_if(
        report.conventions.files, [&](const foreign::ReadFile& one) { return one.file->name.buffer == like.name; });
    if (file == report.conventions.files.end()) return {};
    const foreign::Values& mine = file->mine;
    if (mine.channels != like.channels()) return {};
    std::vector<double> numbers = mine.numbers;
    for (std::size_t i = 0; i < mine.count(); ++i) {
        double* const at = numbers.data() + i * std::size_t(mine.channels);
        if (like.name.id == BufferId::PolygonsVerdict) at[0] = double(verdictOf(at[0] != 0, like.flat(i)));
        if (mine.there[i]) continue;
        if (like.name.id == BufferId::ZView) at[0] = std::numeric_limits<double>::infinity();
        if (like.name.id == BufferId::PolygonId || like.name.id == BufferId::ObjectId) at[0] = -1;
    }
    pipeline::AnyBuffer buffer{like.name, like.info, like.shape, {}, nullptr};
    if (like.count() != numbers.size()) return {};
    std::visit([&]<class T>(std::span<const T>) { fill<T>(buffer, numbers); }, like.data);
    return buffer;
}

}  // namespace app
