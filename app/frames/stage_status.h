#pragma once
#include <array>

#include <QString>
#include <QStringList>

#include "app/frames/frame_check.h"
#include "pipeline/steps/steps.h"

namespace app {

enum class StageState : unsigned char { Ran, Reused, LeftOut, InProgress, NotYet };
QString word(StageState state);  // "left out"

// The texts of a stage's card. Numbers are empty if the stage has none.
struct StageStatus {
    StageState state = StageState::NotYet;
    QString time;                      // "0.161 ms": of the run that made the result, even if it was reused
    QString error;                     // "3.9e-6" against double precision; "…" until it is computed
    QString counts;                    // "3 of 5 polygons kept", and the parts that are left out
    QString reason;                    // why the stage ran, was reused or left out
    QString tooltip;                   // lines: the stage, its state and reason, and each of its parts
    std::optional<double> progress{};  // 0 to 1, while the user steps through it
};

// "1.5e-5 px"
QString errorOf(const pipeline::StageError& error);

// For the six stages of this frame; without a frame they are not yet run, or in progress.
std::array<StageStatus, pipeline::kStageCount> stageStatus(const pipeline::Frame* frame, const StageErrors& errors,
                                                           bool busy);

// The same inside a stage: that stage is in progress, with its fragments and its place instead of time and counts;
// later stages are not yet run.
std::array<StageStatus, pipeline::kStageCount> stageStatus(const pipeline::Steps& steps, pipeline::Moment at,
                                                           pipeline::StepLevel level, const StageErrors& errors);

// The texts of the last card.
struct FrameStatus {
    QString title;     // "Frame 42"
    QString time;      // "0.287 ms"
    QString actions;   // "1 ran, 4 reused, 1 left out"
    QString format;    // "float, 640 × 480"
    QString defect{};  // "Planted: z-flip"; empty without one
};
FrameStatus frameStatus(const pipeline::Frame& frame);
FrameStatus frameStatus(const pipeline::Steps& steps, pipeline::Moment at, pipeline::StepLevel level);

// The frame in a sentence: "Shading ran again because material 0 changed; 4 stages were reused."
QString frameSentence(const pipeline::Frame& frame);

}  // namespace app
