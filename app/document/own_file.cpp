#include "app/document/own_file.h"

#include <QFile>
#include <QFileInfo>

#include "app/document/document.h"
#include "app/look/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace app {

QString ownFile(const Document& document) {
    const KeptScene& kept = document.kept();
    const QFileInfo info(kept.file);
    if (!kept.scene || info.suffix().toLower() != QLatin1String("toml") || !info.isWritable()) return {};
    if (pipeline::builtInSceneOf(kept.file.toStdString())) return {};
    const auto text = toTomlScene(*kept.scene);
    QFile file(kept.file);
    if (!text || file.size() != qint64(text->size()) || !file.open(QIODevice::ReadOnly)) return {};
    return file.readAll() == QByteArrayView(text->data(), qsizetype(text->size())) ? kept.file : QString();
}

}  // namespace app
