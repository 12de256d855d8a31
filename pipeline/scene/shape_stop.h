#pragma once
#include "pipeline/core/stop.h"

namespace pipeline {

// While one lives, makeShape(shape) in this thread looks at its stop: for settings, which remake shapes and know of none.
class ShapeStop {
public:
    explicit ShapeStop(Stop stop);
    ~ShapeStop();
    ShapeStop(const ShapeStop&) = delete;
    ShapeStop& operator=(const ShapeStop&) = delete;

    static Stop innermost();  // nobody's where none lives

private:
    ShapeStop* m_outer;
    Stop m_stop;
};

}  // namespace pipeline
