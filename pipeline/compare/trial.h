#pragma once
#include "pipeline/compare/own/stage_blocks.h"
#include "pipeline/compare/report/own_report.h"
#include "pipeline/compare/verdict.h"

// A program with one function or stage of somebody's own, run in a scene and judged. What the pipeline makes of the scene is
// made once; any number of programs are judged by it.

namespace pipeline::foreign {

struct ProgramOutput {
    std::string failure;   // why it was ended, or how it ended, one sentence; empty with status 0
    std::string output;    // standard output
    std::string messages;  // the last 4 kB of standard error
    double seconds = 0;    // wall clock
    bool isEnded = false;  // at a limit, or because it was asked to stop
};

// Hands a text to the program and collects what it prints. An error if it could not be started.
using Program = std::function<Result<ProgramOutput>(const std::string& input)>;

class FunctionTrial {
public:
    FunctionTrial(Scene scene, OwnFunction function, const Stop& stop);
    // Why no program can be judged: the function is never called. Nothing otherwise.
    std::optional<Error> whyNot() const;
    // Runs the program once; with `picture` up to seven times more, for calls that its own results lead to. An error if it
    // did not run to its end, if its output is not the block that was asked for, or if it was stopped.
    Result<OwnReport> judge(const Program& program, bool picture, const Stop& stop) const;

private:
    Scene m_scene;
    OwnFunction m_function;
    OwnFrame m_right;
};

class StageTrial {
public:
    // No frame and no reference where it is stopped.
    StageTrial(Scene scene, const StageBlocks& blocks, const Stop& stop);
    // Compares the outputs as those of another renderer, beside the inputs that were handed over. given: what they are called
    // in titles. Errors as above.
    Result<Report> judge(const Program& program, const std::string& given, const CompareOptions& options) const;

private:
    Scene m_scene;
    const StageBlocks& m_blocks;
    FramePtr m_frame;
    std::shared_ptr<const Reference> m_reference;
};

}  // namespace pipeline::foreign
