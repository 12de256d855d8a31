#include "pipeline/buffers/verdict.h"

namespace pipeline {

std::string_view name(Verdict verdict) {
    static constexpr std::string_view kNames[kVerdictCount]{
        "kept",
        "back-facing",
        "degenerate",
        "outside the near plane",
        "outside the far plane",
        "outside the left plane",
        "outside the right plane",
        "outside the top plane",
        "outside the bottom plane",
        "clipped",
        "wholly transparent",
        "not yet decided",
    };
    return kNames[std::size_t(verdict)];
}

char letter(Verdict verdict) { return "KBDOOOOOOCT-"[std::size_t(verdict)]; }

}  // namespace pipeline
