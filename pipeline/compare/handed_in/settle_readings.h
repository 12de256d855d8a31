#pragma once
#include "pipeline/compare/verdict.h"

namespace pipeline::foreign {

// Their files as they are read, and beside the reference: conventions and findings of the report. Each of these is false
// where it was stopped.
bool readFiles(Report& report, const StatedConventions& stated);

// Pixels may be sampled at their corner: the first of their rows and columns. Taken where it explains the outlines.
bool settleSamples(Report& report, const StatedConventions& stated);

// 1 may stand for dropped polygons, or front and back are exchanged: what is drawn of them tells. Where nothing does, both
// are said.
void settleFlags(Report& report);

// The files in the readings under which a frame explains them, where those are others.
bool readAs(Report& report, const StatedConventions& stated, const Misfit& misfit);

}  // namespace pipeline::foreign
