#pragma once
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/defects/own_judge.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// More calls of one function are not handed over: a class' programs read them as text.
inline constexpr std::size_t kMostOwnCalls = 200'000;

// Results that change what is stored lead to calls that the right function does not make, such as those of a z-buffer that is
// never written: they are asked in further runs, at most so many in all.
inline constexpr int kOwnRuns = 8;

// The scene in which a function or a stage is judged: at most 160 pixels wide, with all that the picture shows, since some
// hand over a row of text for each pixel.
Scene ownScene(Scene scene);

// What somebody's program has returned, by the arguments; nothing where it was no number.
class OwnRecord {
public:
    void add(const OwnElement& element, const std::optional<OwnValue>& result);
    const std::optional<OwnValue>* find(std::span<const double> in) const;

private:
    std::unordered_map<std::string, std::optional<OwnValue>> m_results;  // by the bytes of the arguments
};

struct OwnFrame {
    FramePtr frame;  // null where it was stopped
    std::vector<OwnElement>
        unknown;         // calls that the record has no result for, each arguments once: the right one stands in
    bool isCut = false;  // there were more than kMostOwnCalls
};

// The frame of a scene, in double, with the recorded results in the place of a function. With an empty record it is the
// right frame, and `unknown` has all of the function's calls in the order of the pipeline.
OwnFrame ownFrame(const Scene& scene, OwnFunction function, std::shared_ptr<const OwnRecord> record, const Stop& stop);

}  // namespace pipeline
