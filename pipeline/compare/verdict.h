#pragma once
#include <functional>

#include "pipeline/compare/evidence.h"
#include "pipeline/compare/hypotheses.h"
#include "pipeline/compare/own/own_stage.h"
#include "pipeline/compare/their_contracts.h"

namespace pipeline::foreign {

enum class Standing : std::uint8_t { Agrees, WrongHere, GivenInput, NoFile, CannotTell };
std::string_view words(Standing standing);  // "agrees", "wrong here", …

struct StageVerdict {
    StageId stage;
    Standing standing = Standing::NoFile;
    std::vector<std::size_t> findings;  // into Report::findings
    std::string own;                    // what it does with what it got, one sentence; may be empty
};

struct CompareOptions {
    std::map<std::string, double> tolerances;  // by the buffer's name, in its unit
    StageId until = StageId::Shading;
    bool known = true;                   // whether known errors are looked for
    std::vector<std::string> without{};  // ids of known errors that are not tried
    bool strict = false;                 // conventions count as errors
    int hints = 3;                       // how much is given away: 0 nothing, 1 the stage, 2 the place, 3 the name
    Stop stop;
    // What is being done, and how far it is.
    std::function<void(std::string_view what, std::size_t done, std::size_t all)> progress;
};

struct Report {
    std::shared_ptr<const Scene> scene;
    std::string given;  // the folder or files, for titles
    std::shared_ptr<const Reference> reference;
    std::shared_ptr<const HandedIn> in;
    Conventions conventions;
    std::vector<Finding> findings;              // in the order of the stages
    std::vector<std::optional<OwnResult>> own;  // of each finding
    std::vector<Standing> standings;            // likewise
    std::vector<BrokenContract> broken;
    std::array<StageVerdict, kStageCount> stages;
    std::optional<StageId> firstWrong;   // where one stage alone can be it
    std::vector<StageId> possiblyWrong;  // the first wrong stage is one of these; none: the files do not tell
    bool isCertain = false;  // of that: chain and own comparison say so; else a known error, or what differs
    std::optional<Suspects> suspects;
    Evidence evidence;  // of files that hold nothing
    CompareOptions options;

    bool agrees() const;  // everything handed in does
    bool conventionsDiffer() const;
    // The finding in which the error shows first; nothing where all agree.
    const Finding* firstDifference() const;
    const ReadFile& fileOf(const Finding& finding) const;
    std::vector<std::string> notHandedIn() const;
};

// Nothing where it was stopped, or an error where no file could be compared.
Result<Report> compareRenderer(const Scene& scene, const std::vector<std::string>& paths,
                               const CompareOptions& options);
// The same of files that are in memory. given: what they are called in titles.
Result<Report> compareRenderer(const Scene& scene, std::shared_ptr<const Reference> reference, HandedIn in,
                               const std::string& given, const CompareOptions& options);
// Tries the known errors, which a report lacks that was made with options.known false: the report is then the one that it
// would have been with it, without comparing again. False: stopped, and the report is of no use.
bool nameKnownErrors(Report& report);

// "Normals is the first wrong stage."
std::string headline(const Report& report);
// "None of the 102 known errors explains this.", "Your files are those of a renderer with this error."; empty where none was
// looked for.
std::string namesText(const Report& report);
// What they have handed in, in the numbers of the file where these are colours: "10 20 30", "nothing".
std::string mineText(const Report& report, const Finding& finding, std::size_t element);
// What the headline rests on, one sentence; may be empty.
std::string evidence(const Report& report);
// The three hints, as far as they are given away.
std::vector<std::string> hints(const Report& report);

}  // namespace pipeline::foreign
