#pragma once

namespace web {

// Whether this core has what shadow verdicts are made by: that of the whole program has.
bool castsRays();

}  // namespace web
