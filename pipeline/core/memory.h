#pragma once
#include <cstddef>

namespace pipeline {

// What the system's memory is asked for. Each does nothing where the C library or the system has no such choice.

// For a program to call once, before it computes. Buffers of some megabytes come and go with every frame. The C library
// takes each of them from the system and gives it back, and the system clears it page by page every time: two thirds of
// a small frame's time went there. Now they stay with the process, in one heap for all of its threads.
void keepFreedMemory();

// Gives the system back what is free now: for once, when much of it was needed for a moment.
void giveBackFreedMemory();

// Asks for pages of 2 MB instead of 4 KB where whole ones lie in a piece of memory, of 9 MB and more, that is about to be
// written as a whole. The system clears a page when it is first written, and at ten million polygons that took a third of
// a frame, page by page. Nothing that stands in the piece changes.
void preferLargePages(void* piece, std::size_t bytes);

}  // namespace pipeline
