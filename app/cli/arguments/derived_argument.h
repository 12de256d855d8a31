#pragma once
#include "app/headless/derived_wanted.h"

namespace CLI {
class App;
}

namespace app {

void declareDerived(CLI::App& command, DerivedArgument& argument);

}  // namespace app
