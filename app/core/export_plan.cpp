#include "app/core/export_plan.h"

#include <QRegularExpression>

#include "app/core/text.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/settings_table.h"

namespace app {

std::vector<ExportRow> exportRows(const pipeline::Frame& frame) {
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
    return rows;
}

QString sizeText(std::uint64_t bytes) {
    if (bytes < 1000) return QStringLiteral("%1 B").arg(bytes);
    if (bytes < 100'000) return QStringLiteral("%1 kB").arg(double(bytes) / 1e3, 0, 'f', 1);
    return QStringLiteral("%1 MB").arg(double(bytes) / 1e6, 0, 'f', 1);
}

QString shellWord(const QString& word) {
    static const QRegularExpression plain("^[A-Za-z0-9_./:=,+@%-]+$");
    if (plain.match(word).hasMatch()) return word;
    QString quoted = word;
    quoted.replace("'", "'\\''");
    return '\'' + quoted + '\'';
}

QString exportCommand(const pipeline::Scene& scene, const pipeline::ExportRequest& request, bool allBuffers) {
    QStringList words{"shadescope", "export", shellWord(toQString(scene.file.empty() ? scene.name : scene.file)), "-o",
                      shellWord(toQString(request.folder.string()))};
    QStringList formats, buffers;
    for (const std::string& format : request.formats) formats += toQString(format);
    words << "--format" << formats.join(',');
    for (const pipeline::BufferName& name : request.buffers) buffers += toQString(name.text());
    if (!allBuffers) words << "--buffers" << buffers.join(',');
    const auto original = pipeline::readScene(scene.file);
    if (original && original->objects.size() == scene.objects.size() &&
        original->lights.size() == scene.lights.size()) {
        for (const pipeline::SettingRef& setting : pipeline::settingsOf(scene)) {
            const double value = setting.get(scene);
            if (value != setting.get(*original))
                words << "--set" << shellWord(toQString(setting.key() + "=" + formatSetting(setting, value)));
        }
    }
    return words.join(' ');
}

}  // namespace app
