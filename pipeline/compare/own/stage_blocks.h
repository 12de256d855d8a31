#pragma once
#include <span>

#include "pipeline/compare/handed_in/handed_in.h"
#include "pipeline/compare/own/own_blocks.h"

namespace pipeline::foreign {

// A whole stage in a program of somebody's own: what the stages before it leave, as text blocks, and what the program makes
// of it. See own_blocks.h for what a block is; `polygons` has the count of its vertices first in each row, `scene` a key and a
// value.
struct StageBlocks {
    StageId stage;
    std::array<std::string_view, 8> gets, gives;  // buffers; of a buffer for each light the name without a number
};
// Nothing for the shadow buffer: light views of other renderers are not compared.
const StageBlocks* stageBlocks(StageId stage);

// All that these blocks need, in double, with nothing left out. Null where it was stopped.
FramePtr stageFrame(const Scene& scene, const StageBlocks& blocks, const Stop& stop);
std::string stageText(const Frame& frame, const StageBlocks& blocks);

// The program's output, and beside it what it was handed, as files in memory with the program's own conventions stated.
// Errors name blocks of another name or size; any subset of the blocks is enough.
Result<HandedIn> readStage(const Frame& frame, const StageBlocks& blocks, std::string_view text);

}  // namespace pipeline::foreign
