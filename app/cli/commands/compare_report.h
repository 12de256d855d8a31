#pragma once
#include "pipeline/compare/verdict.h"

namespace app {

// A comparison as text on standard output, in bold and with marks where a terminal shows them.
void sayReport(const pipeline::foreign::Report& report);

}  // namespace app
