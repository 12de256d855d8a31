#pragma once
#include <QString>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/core/result.h"

namespace app {

// A picture to compare `like` with, as a buffer of the same kind. A NumPy array (.npy, as the
// program exports it: little-endian, C order, float32, float64, int32 or uint8) or an OpenEXR file
// (.exr, with the channels that the export writes) for any buffer; a
// PNG or another file of 8-bit colours for a buffer of 8-bit colours. Its shape may be another one.
pipeline::Result<pipeline::AnyBuffer> readPicture(const QString& file, const pipeline::AnyBuffer& like);

}  // namespace app
