#pragma once

namespace pipeline {

// Tells the thread sanitizer that everything before give() happens before everything after take(). It knows this of
// locks and atomics, but not of oneTBB, whose library is not built for it. In other builds both do nothing.
class HappensBefore {
public:
    void give();
    void take();
};

}  // namespace pipeline
