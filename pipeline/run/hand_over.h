#pragma once

namespace pipeline {

// Work on its way from one thread to others, or back: what give() stands behind, take() stands before. The thread sanitizer
// sees this of locks and atomics, but not of oneTBB, whose library is not built for it; in other builds both do nothing.
class HandOver {
public:
    void give();
    void take();
};

}  // namespace pipeline
