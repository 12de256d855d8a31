#include "pipeline/core/version.h"

namespace pipeline {

std::string_view programVersion() { return SHADESCOPE_VERSION; }

}  // namespace pipeline
