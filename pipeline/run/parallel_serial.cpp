// For builds without threads: every piece runs in the calling thread.
#include <utility>

#include "pipeline/run/parallel.h"

namespace pipeline {

struct Threads::Team {};

Threads::Threads(int, Stop stop) : m_stop(std::move(stop)) {}
Threads::~Threads() = default;

void Threads::share(std::size_t pieces, const std::function<void(std::size_t, std::size_t)>& run) { run(0, pieces); }

}  // namespace pipeline
