#pragma once
#include <QByteArrayView>
#include <QString>

#include "pipeline/core/result.h"

namespace app {

// Writes the whole file, or keeps the old one; then the errors give the reason.
pipeline::Errors writeFile(const QString& file, QByteArrayView bytes);

}  // namespace app
