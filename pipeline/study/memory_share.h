#pragma once
#include "pipeline/run/frame.h"

namespace pipeline {

// What a frame leaves in memory, and how fast memory takes as much.

// Bytes of all buffers that the frame holds. What its stages write and read on the way is not among them.
double bufferBytes(const Frame& frame);

// Bytes a second that `threads` threads, 0 for as many as the machine has, write with memset to 256 MB, which is more than
// caches hold: the fastest of five times. Takes about 256 MB and a tenth of a second.
double memsetBandwidth(int threads);

}  // namespace pipeline
