#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"

namespace app {

// Which part of a frame a command wants: --buffers, --until, --threads.
struct FrameArgument {
    std::vector<std::string> buffers{"all"};  // names; "all": what the scene has a use for
    std::string until;                        // empty: the last stage that the buffers need
    int threads = 0;                          // 0: as many as the machine has
    bool makesDerived = false;                // whether derived buffers could have been named too
};

// Errors name the nearest buffer there is, or how many lights the scene has.
pipeline::Result<pipeline::BufferName> bufferNamed(const pipeline::Scene& scene, const std::string& text,
                                                   bool makesDerived = false);

struct WantedFrame {
    pipeline::FrameRequest request;
    std::vector<pipeline::BufferName> buffers;  // those asked for by name; empty: all that the frame holds
};

// Why the scene has no such buffer: it has fewer lights.
std::optional<pipeline::Error> noSuchLight(const pipeline::Scene& scene, const pipeline::BufferName& name);

// The last stage that leaves any of them.
pipeline::StageId lastStageOf(const pipeline::BufferSet& buffers);
// Why a buffer that comes from a stage is not there at the end of a run until another, if so.
std::optional<pipeline::Error> comesTooLate(const pipeline::BufferName& name, pipeline::StageId from,
                                            pipeline::StageId until);

// What the stages did not do as they were asked, and why nothing is seen, a line each. A manifest and a plan have it among
// their remarks.
std::string remarksText(const pipeline::Frame& frame);

// Errors name the buffer or stage that does not exist, and the nearest that does.
pipeline::Result<WantedFrame> wantedFrame(const pipeline::Scene& scene, const FrameArgument& argument);

}  // namespace app
