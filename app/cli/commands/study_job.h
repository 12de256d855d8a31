#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/interrupt.h"
#include "pipeline/export/study/study_html.h"
#include "pipeline/study/analysis.h"
#include "pipeline/study/run_study.h"

namespace app {

struct StudyOrder {
    pipeline::StudyRequest request;
    int processes = 3;
    std::filesystem::path folder;
    bool restart = false;
    std::vector<std::string> arguments;  // that make the same request of a process that takes times
};

// Finds the errors of every point, has processes of their own take the times one after the other, and keeps what there
// is in the folder all the way, so that the same call goes on where this one was stopped. Gives the report, or nothing
// after the reason went to standard error and `status` was set.
std::optional<pipeline::StudyReport> runStudy(const StudyOrder& job, const Interrupt& interrupt, int& status);

// Says that the study goes on from what the folder keeps. Gives the exit status.
int studyCancelled(const StudyOrder& job);

// What such a process does: takes times and writes them to a file. Gives its exit status.
int takeTimes(const pipeline::StudyRequest& request, const std::filesystem::path& file, const std::string& which,
              const Interrupt& interrupt);

// Writes the folder's files and prints the table, or the whole study as JSON. limits: what is 0 is chosen from the
// front. Gives the exit status: that the answer is no where no point has an answer, or a limit was given that none keeps.
int reportStudy(const pipeline::StudyReport& report, pipeline::StudyLimits limits,
                const std::vector<pipeline::StudyPictures>& pictures, const std::filesystem::path& folder, bool json);

}  // namespace app
