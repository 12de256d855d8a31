#include "app/document/export_plan.h"

#include <QRegularExpression>

#include "app/look/text.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/folder/size_text.h"

namespace app {

namespace {

// As an array of a picture.
std::uint64_t bytesOf(const pipeline::BufferName& name, const pipeline::Scene& scene) {
    const pipeline::BufferInfo& info = bufferInfo(name.id);
    // Numbers of an expression are double.
    const std::uint64_t element = info.element == pipeline::Element::Real    ? 8
                                  : info.element == pipeline::Element::Int32 ? 4
                                                                             : 1;
    return element * std::uint64_t(info.channels) * std::uint64_t(scene.settings.width) *
           std::uint64_t(scene.settings.height);
}

}  // namespace

std::vector<ExportRow> exportRows(const pipeline::Frame& frame, const lessons::DerivedRecipe& recipe) {
    std::vector<ExportRow> rows;
    for (const pipeline::BufferName& name : pipeline::allBuffers(frame.scene().lights.size())) {
        ExportRow row{.name = name, .whyNot = {}};
        if (const auto buffer = frame.buffer(name)) {
            row.bytes = std::visit([](const auto& data) { return std::uint64_t(data.size_bytes()); }, buffer->data);
        } else {
            row.whyNot = toQString(frame.whyAbsent(name));
        }
        rows.push_back(std::move(row));
    }
    for (const pipeline::BufferName& name : pipeline::allDerived(frame.scene().lights.size())) {
        const auto buffers = buffersFor(name, recipe, frame.scene());
        rows.push_back(
            {name, bytesOf(name, frame.scene()), buffers ? QString() : toQString(buffers.errors().front().found)});
    }
    return rows;
}

QString sizeText(std::uint64_t bytes) { return toQString(pipeline::sizeText(bytes)); }

QString shellWord(const QString& word) {
    static const QRegularExpression plain("^[A-Za-z0-9_./:=,+@%-]+$");
    if (plain.match(word).hasMatch()) return word;
    QString quoted = word;
    quoted.replace("'", "'\\''");
    return '\'' + quoted + '\'';
}

std::vector<pipeline::PlannedFile> plannedDerived(const pipeline::Scene& scene,
                                                  const pipeline::ExportRequest& request) {
    std::vector<pipeline::PlannedFile> files;
    for (const pipeline::BufferName& name : request.buffers) {
        if (!pipeline::isDerived(name.id)) continue;
        for (const std::string& format : request.formats) {
            const pipeline::Exporter* exporter = pipeline::findExporter(format);
            if (exporter && exporter->refuses(bufferInfo(name.id)).empty())
                files.push_back({name, format, name.text() + '.' + format, bytesOf(name, scene), false, {}});
        }
    }
    return files;
}

QString sceneWord(const pipeline::Scene& scene) {
    return shellWord(toQString(scene.file.empty() ? scene.name : scene.file));
}

QStringList recipeWords(const std::vector<pipeline::BufferName>& buffers, const lessons::DerivedRecipe& recipe) {
    bool needsText = false, needsMix = false;
    for (const pipeline::BufferName& name : buffers) {
        needsMix = needsMix || name.id == pipeline::BufferId::Mix;
        needsText = needsText || name.id == pipeline::BufferId::Condition || name.id == pipeline::BufferId::Expression;
    }
    QStringList words;
    if (needsText) words << "--where" << shellWord(toQString(recipe.text));
    if (const std::string mix = mixText(recipe.mix); needsMix && !mix.empty())
        words << "--mix" << shellWord(toQString(mix));
    return words;
}

QString exportCommand(const pipeline::Scene& scene, const QStringList& changes, const pipeline::ExportRequest& request,
                      const lessons::DerivedRecipe& recipe, bool allBuffers) {
    QStringList words{"shadescope", "export", sceneWord(scene), "-o", shellWord(toQString(request.folder.string()))};
    QStringList formats, buffers;
    bool anyDerived = false;
    for (const std::string& format : request.formats) formats += toQString(format);
    words << "--format" << formats.join(',');
    for (const pipeline::BufferName& name : request.buffers) {
        const bool isDerived = pipeline::isDerived(name.id);
        anyDerived = anyDerived || isDerived;
        if (isDerived || !allBuffers) buffers += toQString(name.text());
    }
    if (allBuffers && anyDerived) buffers.prepend("all");
    if (!buffers.isEmpty()) words << "--buffers" << buffers.join(',');
    return (words + recipeWords(request.buffers, recipe) + changes).join(' ');
}

}  // namespace app
