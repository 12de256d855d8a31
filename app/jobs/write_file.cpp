#include "app/jobs/write_file.h"

#include <QFile>

#include "pipeline/export/folder/staging.h"

namespace app {

pipeline::Errors writeFile(const QString& file, QByteArrayView bytes) {
    const auto written =
        pipeline::writeWhole(QFile::encodeName(file).toStdString(), {bytes.data(), std::size_t(bytes.size())});
    return written ? pipeline::Errors() : written.errors();
}

}  // namespace app
