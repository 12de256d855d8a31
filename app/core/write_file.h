#pragma once
#include <QByteArrayView>
#include <QString>

#include "pipeline/core/result.h"

namespace app {

// Writes the file whole, or leaves what stands there: then the errors say why.
pipeline::Errors writeFile(const QString& file, QByteArrayView bytes);

}  // namespace app
