#pragma once
#include <array>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/core/stop.h"
#include "pipeline/plan/needs.h"
#include "pipeline/plan/plan.h"
#include "pipeline/scene/remark.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// How often something was done in a stage, or left out by a rule.
struct Tally {
    std::string_view what;  // "shadow look-ups"
    long long done = 0, leftOut = 0;
    std::optional<Rule> rule{};  // nothing where no rule leaves it out
    bool operator==(const Tally&) const = default;
};

// What happened in a stage when it last ran.
struct StageRun {
    double milliseconds = 0;
    std::string counts;  // "5 vertices", "3 of 5 polygons kept"
    std::vector<Tally> tallies;
    std::optional<Remark> remark{};  // where what it leaves is not what was asked for
};

// What is asked of a frame beside the scene.
struct FrameRequest {
    BufferSet wanted;                  // buffers that must be there afterwards
    StageId until = StageId::Shading;  // later stages do not run
    int threads = 0;                   // 0: as many as the machine has
    Stop stop;                         // asks to give up; checked per tile
};

struct FrameStages;  // the stages' outputs; pipeline/run/frame_data.h
struct Topology;     // pipeline/scene/topology.h

// One computed frame. Immutable and shared: reuse is copying a pointer.
class Frame {
public:
    const Scene& scene() const { return *m_scene; }
    const std::shared_ptr<const Scene>& sharedScene() const { return m_scene; }
    const Plan& plan() const;  // its parts are put into words when it is first read
    const StageRun& run(StageId stage) const { return m_runs[index(stage)]; }
    double milliseconds() const { return m_milliseconds; }          // wall clock of this frame alone
    double planMilliseconds() const { return m_planMilliseconds; }  // of that, for deciding what to do
    long number() const { return m_number; }                        // counts from 1 along a chain of frames
    StageId until() const { return m_until; }

    // The buffer, or nothing where the plan left it out or its stage has not run. What a stage keeps in another form is
    // put into this one when it is first read.
    std::optional<AnyBuffer> buffer(const BufferName& name) const;
    // Why buffer() gives nothing; empty when it gives something.
    std::string whyAbsent(const BufferName& name) const;
    // What there is, in the order of the stages.
    std::vector<AnyBuffer> buffers() const;

    // Polygons are counted over all objects in scene order, as in the buffers.
    struct PolygonPlace {
        std::size_t object, polygon;
    };
    PolygonPlace placeOf(int polygon) const;

    const FrameStages& stages() const { return *m_stages; }

    BufferSet wanted() const { return m_wanted; }  // the request's
    BufferSet made() const {
        return m_made;
    }  // what shading keeps beside; all of them where unread ones are not left out
    const Topology& topology() const { return *m_topology; }
    // The same for all frames in a row that have the same meshes.
    const std::shared_ptr<const Topology>& sharedTopology() const { return m_topology; }

private:
    friend class Runner;
    std::shared_ptr<const Scene> m_scene;
    std::shared_ptr<const Topology> m_topology;
    Needs m_needs;
    mutable Plan m_plan;
    mutable std::once_flag m_explained;
    std::array<StageRun, kStageCount> m_runs;
    double m_milliseconds = 0, m_planMilliseconds = 0;
    long m_number = 0;
    StageId m_until = StageId::Shading;
    BufferSet m_wanted, m_made;
    std::shared_ptr<const FrameStages> m_stages;
    mutable std::mutex m_readMutex;
    mutable std::vector<AnyBuffer> m_read;  // in this form for a reader; guarded by m_readMutex
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace pipeline
