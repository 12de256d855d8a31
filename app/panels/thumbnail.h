#pragma once
#include <QImage>
#include <optional>

#include "pipeline/run/frame.h"

namespace app {

// A small picture of a buffer, at most as large as `size`, of the part of the picture where
// something is drawn.
// polygonId: the frame's, so that several thumbnails share it.
QImage thumbnail(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer, QSize size,
                 const std::optional<pipeline::AnyBuffer>& polygonId);

}  // namespace app
