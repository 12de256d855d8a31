#pragma once
#include <QImage>
#include <optional>

#include "pipeline/run/frame.h"

namespace app {

// A small picture of a buffer, at most as large as `size`, of the part of the picture where
// something is drawn.
// polygonId: the frame's, so that several thumbnails share it. pixelRatio: of the screen's pixels a logical one of
// `size`.
QImage thumbnail(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer, QSize size,
                 const std::optional<pipeline::AnyBuffer>& polygonId, double pixelRatio = 1);

}  // namespace app
