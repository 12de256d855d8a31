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
