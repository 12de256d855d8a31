#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/study/picture.h"
#include "pipeline/study/study.h"
#include "pipeline/study/sweep.h"

namespace pipeline {

// A study is errors and times: errors once a point, times many times over, the points in turns, so that what disturbs
// the machine for a while disturbs all of them. Each is a function of its own, so that they can stand in different
// processes, be interrupted, and go on another day.

struct StudyRequest {
    std::shared_ptr<const Scene> scene;  // has passed checkScene
    Sweep sweep;
    std::optional<ErrorChoice> choice;  // instead of the sweep's own
    int threads = 1;                    // of the frames whose time is taken; 0: as many as the machine has
    int warmups = 2, repeats = 20;      // frames of each point and process
    std::size_t shard = 0, shards = 1;  // of all points those whose number leaves this remainder
};

// The points of the request with nothing measured.
StudyReport beginStudy(const StudyRequest& request);

// What a point shows, to look at: its frame and the pictures that it is compared with.
struct PointPictures {
    FramePtr frame;
    Picture picture;
    std::shared_ptr<const Reference> reference;  // of the model; null where there is none
};

// Finds errors, counters and blame, point by point; remembers references that the next point shares.
class ErrorFinder {
public:
    explicit ErrorFinder(const StudyRequest& request) : m_request(request) {}

    // Fills in a point. `report` learns which references there are, and why not. False when it was stopped.
    bool find(StudyPoint& point, StudyReport& report, Stop stop);
    // The same pictures again, for those who look; nothing where the point fails or it was stopped.
    std::optional<PointPictures> show(const StudyPoint& point, Stop stop);

private:
    std::shared_ptr<const Reference> modelReference(const Scene& scene, StudyReport* report, Stop stop);

    // Whether pixels are looked at as a whole, not by their centres alone.
    bool antialiases() const;
    // Of shadows, of area lights or of pixels: then the scene's own polygons, as they are shaded, are the reference.
    bool variesSamplesAlone() const;
    BufferSet wanted() const;

    StudyRequest m_request;
    Scene m_referenceKey;  // of m_reference: the scene without what a reference does not read
    std::shared_ptr<const Reference> m_reference;
};

// Adds one process' run times to the points that have not failed. progress(rounds done, rounds in all) is called after
// each round over the points. False when it was stopped: nothing was added then.
bool measureTimes(const StudyRequest& request, std::span<StudyPoint> points,
                  const std::function<void(int done, int all)>& progress, Stop stop);

// Takes over the times of a report of the same study, point by point: another process' measurements.
void addTimes(const StudyReport& from, StudyReport& to);

// Takes over how far references may themselves be wrong, of each measure the largest.
void addErrorBars(const std::vector<ErrorRow>& bars, StudyReport& report);

// Parts of one study, each with points of its own or with more times of the same ones, as one. Refused: parts of
// different studies, by the first member that differs.
Result<StudyReport> mergeStudies(std::vector<StudyReport> parts);

// Whether all points of the sweep are there; else how many are missing.
std::size_t missingPoints(const StudyReport& report);

}  // namespace pipeline
