#include "app/core/write_file.h"

#include <QSaveFile>

namespace app {

pipeline::Errors writeFile(const QString& file, QByteArrayView bytes) {
    QSaveFile out(file);
    if (out.open(QIODevice::WriteOnly) && out.write(bytes.data(), bytes.size()) == bytes.size() && out.commit())
        return {};
    return {{{file.toStdString(), 0, 0}, "could not write: " + out.errorString().toStdString(), {}}};
}

}  // namespace app
