#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/derived_buffer.h"
#include "lessons/expression/changed_frames.h"
#include "lessons/lesson.h"
#include "lessons/questions/attempt.h"
#include "pipeline/export/json/json.h"
#include "pipeline/inspect/own_calls.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

// A call of the page: text comes as pointer and length, 1 means done and 0 refused, and answer() is there for text() and
// size().
#define WEB_CALL(name) extern "C" __attribute__((export_name(#name)))

namespace web {

using pipeline::Json;

// What a scene shows at a place inside its frame.
struct ShownScene {
    std::shared_ptr<const pipeline::Scene> scene;
    pipeline::FramePtr frame;                // whole
    std::unique_ptr<pipeline::Steps> steps;  // of it, once somebody steps
    pipeline::Moment moment;                 // where steps are
    pipeline::FramePtr atMoment;             // null at the end of the frame
    const pipeline::Frame& now() const { return atMoment ? *atMoment : *frame; }
    // Derived buffers of the frame `derivedOf`, by name: those that were asked for.
    std::map<std::string, lessons::DerivedBuffer> derived;
    pipeline::FramePtr derivedOf;
};

// The open lesson.
struct OpenLesson {
    lessons::Lesson lesson;
    std::vector<lessons::Progress> progress;  // of every page
    std::size_t page = 0;
    bool then = false;                 // the second half is shown
    pipeline::FramePtr first, half;    // frames as the author meant them: of the first half, and of the one shown
    lessons::ChangedFrames changed{};  // of what answers ask for with settings changed
};

// A function that the reader writes, in one of the scenes in which it is judged (write_calls.cpp).
struct Writing {
    std::size_t page = 0, number = 0;  // of the scene: 0 the page's own, then the trials
    pipeline::Scene scene;
    std::vector<pipeline::OwnElement> elements, asked;  // all calls; those whose results are still to come
    std::vector<double> numbers;                        // of the calls that are asked
    pipeline::OwnResults results;                       // of `elements`
    std::shared_ptr<pipeline::OwnRecord> record;
    pipeline::OwnVerdict verdict;
    pipeline::FramePtr right, mine;  // mine: null where the pipeline does not go on with the results
};

// Everything that calls share: there is one page.
struct LiveCore {
    std::map<std::string, std::string, std::less<>> files;  // that scenes and the engine may read, by name
    std::set<std::string> missing;                          // names that a scene has, and no file
    ShownScene own;                                         // the reader's
    std::optional<ShownScene> other;                        // what it is compared with
    pipeline::BufferSet wanted;
    lessons::DerivedRecipe recipe;  // of the buffers `condition`, `expression` and `mix`
    std::optional<OpenLesson> lesson;
    std::optional<Writing> writing;
};
LiveCore& core();

// The question that is open, or was; there has to be one.
const lessons::Question& questionOf(const OpenLesson& open);
// What an answer is judged by: the page's own frame, or the reader's where the reader changes it.
lessons::Context contextOf(OpenLesson& open);
Json verdictJson(const lessons::Verdict& verdict);

std::string_view textAt(const char* start, int size);

int give(const Json& json);
int giveText(std::string text);
int refuse(const pipeline::Errors& errors);  // {"errors": [{file, line, column, found, expected, keys, text}]}
int refuse(std::string found);
const std::string& answer();

// A buffer of what is shown, derived ones too; nothing, after the reason was given.
std::optional<pipeline::AnyBuffer> bufferNamed(ShownScene& shown, std::string_view text);

// What a page shows of every frame, beside the buffers of its views: ids to pick by, vertices to draw in space.
pipeline::BufferSet shownAlways();
// Runs the reader's frame again, with what is wanted now; fresh: nothing is reused. The frame of the author is the
// reader's as long as it has all that is wanted and no setting has moved.
void runOwn(bool fresh = false);
// What the page reads of the reader's frame beside its views; its text and its question have frames of their own.
pipeline::BufferSet readByPage(const OpenLesson& open);
// Takes over a scene, whose frame has yet to run.
void take(pipeline::Scene scene);

}  // namespace web
