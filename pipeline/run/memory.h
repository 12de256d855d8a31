#pragma once

namespace pipeline {

// For a program to call once, before it computes. Buffers of some megabytes come and go with every frame. The C library
// takes each of them from the system and gives it back, and the system clears it page by page every time: two thirds of
// a small frame's time went there. Now they stay with the process. Does nothing where the C library has no such choice.
void keepFreedMemory();

}  // namespace pipeline
