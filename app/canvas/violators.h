#pragma once
#include "app/canvas/shown_buffer.h"
#include "pipeline/compare/verdict.h"
#include "pipeline/contracts/contract.h"

namespace app {

// What the contracts about a buffer of pixels read.
pipeline::BufferSet violatorBuffers(pipeline::BufferId shown);

// Masks the pixels that violate a contract about the buffer, in the colour of NaN with a hatch. The notice names the
// contracts and their counts; empty if all hold or if stopped.
QString violators(const pipeline::ContractInput& input, const pipeline::BufferName& shown, CanvasContent& content,
                  const std::stop_token& stop);

// The colours of a renderer's pixels by their classes, and a notice of what they stand for. Nothing where the buffer
// was not handed in.
void addClasses(const pipeline::foreign::Report& report, ShownBuffer& shown);

}  // namespace app
