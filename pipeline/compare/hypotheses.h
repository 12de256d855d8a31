#pragma once
#include <functional>

#include "pipeline/compare/known_errors.h"
#include "pipeline/compare/misfit.h"

namespace pipeline::foreign {

// A known error that may explain what was handed in.
struct Candidate {
    KnownError error;
    Misfit misfit;
    double left = 0;         // elements that are wrong with its frame too: see Misfit
    double explained = 0;    // 1 − left / those that are wrong with the right frame
    bool otherRows = false;  // than those under which the right frame is nearest
};

struct Experiment {
    std::string buffer, place;
    std::vector<std::string> values;  // one a candidate
};

struct Suspects {
    double right = 0;                   // elements that are wrong with the right frame
    std::vector<Candidate> candidates;  // the best first: one, or all that are as good
    std::vector<std::size_t> files;     // what they explain, as indices of findings
    std::optional<Candidate> next;      // the best of the others
    std::optional<Experiment> experiment;
    std::string kind;          // what the candidates have in common, where the shadow alone tells: "no light arrives"
    bool areTogether = false;  // the two candidates are made at once, that of the earlier stage first
    std::size_t tried = 0;
    bool stopped = false;
};

// Told of every frame: how many of how many.
using HypothesisProgress = std::function<void(std::size_t done, std::size_t all)>;

// What the files have told before any error is tried.
struct FirstWrong {
    std::vector<StageId> possible;       // the first wrong stage is one of these; none: it may be any
    std::optional<StageId> certain;      // the stages' own comparison says so
    std::vector<std::size_t> wrongHere;  // findings that are wrong given what they got, or differ in that stage
};

// Where the frames of the first two differ most, in the first buffer in which they clearly do.
std::optional<Experiment> experimentBetween(const std::vector<Candidate>& candidates, const Scene& scene,
                                            const Reference& reference, const Stop& stop);

// Which known errors explain the files. Each is tried under every reading of the folder that is possible, and counted as
// the verdict counts: where right renderers may differ nothing is held against it. Large pictures are ranked in a smaller
// one, and the best are confirmed in their own size. Where none explains all of the files, what explains the first wrong
// file and leaves those before as they are is taken, or what explains the picture alone and is of a stage that may be wrong.
//
// If none explains them, two errors at once are tried: the best ones with every other.
Suspects findSuspects(const Scene& scene, std::vector<KnownError> errors, const Reference& reference,
                      const Conventions& conventions, const StatedConventions& stated,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress = {});

// What the shadow test alone can have done: where nearly all pixels that are wrong have the very colour that they have in
// light or in shadow, S is wrong and nothing else. How it changes tells the kind; of `errors` those of that kind.
struct ShadowAlone {
    std::string kind;              // "no light arrives"; empty: it is not S alone
    std::vector<std::string> ids;  // of known errors
    double explained = 0;          // the share of the wrong pixels
};
ShadowAlone shadowAlone(const Finding& color, const Values& theirs, const Reference& reference);

}  // namespace pipeline::foreign
