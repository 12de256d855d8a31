#include "app/document/renderer_files.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pipeline/buffers/verdict.h"

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
