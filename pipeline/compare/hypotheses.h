#pragma once
#include <functional>
#include <map>

#include "pipeline/compare/finding.h"
#include "pipeline/compare/known_errors.h"

namespace pipeline::foreign {

// A known error that may explain what was handed in.
struct Candidate {
    KnownError error;
    double distance = 0;     // root of the mean square difference, in tolerances, over the buffer that fits least
    double explained = 0;    // 1 − distance² / distance of the right renderer²
    bool otherRows = false;  // than those that are taken
};

struct Experiment {
    std::string buffer, place;
    std::vector<std::string> values;  // one a candidate
};

struct Suspects {
    double right = 0;                   // distance of this program's frame
    std::vector<Candidate> candidates;  // the best first: one where it is clearly best, else those as good
    std::optional<Candidate> next;      // the best of the others
    std::optional<Experiment> experiment;
    std::size_t tried = 0;
    bool stopped = false;
};

// Told of every frame: how many of how many.
using HypothesisProgress = std::function<void(std::size_t done, std::size_t all)>;

// What the stages' own comparison has told: nothing where it is not certain.
struct FirstWrong {
    std::optional<StageId> stage;
    std::vector<std::size_t> wrongHere;  // findings that are wrong given what they got, or differ in that stage
};

// Where the frames of the first two differ most, in the first buffer in which they clearly do.
std::optional<Experiment> experimentBetween(const std::vector<Candidate>& candidates, const Scene& scene,
                                            const Reference& reference, const Stop& stop);

// Which known errors explain the files. Ranked in a small picture; the best five are confirmed in the picture's own size.
// Where none explains all of them, what explains the first wrong file and leaves those before as they are is taken.
Suspects findSuspects(const Scene& scene, const Reference& reference, const Conventions& conventions,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress = {});

}  // namespace pipeline::foreign
