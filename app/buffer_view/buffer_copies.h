#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

// Copies the picked pixel's value, or the picture, to the clipboard, and says so.
class BufferCopies : public BufferFeature {
public:
    explicit BufferCopies(BufferView& view);

    QString whyNoValue() const;  // why copyValue() has nothing to copy; else empty
    void copyValue();
    void copyPicture();
};

}  // namespace app
