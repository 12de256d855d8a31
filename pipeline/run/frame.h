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

// How often a stage did something, or how often a rule left it out.
struct Tally {
    std::string_view what;  // "shadow look-ups"
    long long done = 0, leftOut = 0;
    std::optional<Rule> rule{};  // empty if no rule leaves it out
    bool operator==(const Tally&) const = default;
};

// What happened when a stage last ran.
struct StageRun {
    double milliseconds = 0;
    std::string counts;  // "5 vertices", "3 of 5 polygons kept"
    std::vector<Tally> tallies;
    std::optional<Remark> remark{};  // if its output is not what was requested
};

// The request for a frame, apart from the scene.
struct FrameRequest {
    BufferSet wanted;                  // buffers that must exist afterwards
    StageId until = StageId::Shading;  // later stages do not run
    int threads = 0;                   // 0: as many as the machine has
    Stop stop;                         // checked for each tile
    // Planted in the frame's scene: no rule acts then, no kernel draws, and every pixel is shaded by itself.
    std::shared_ptr<const Own> own{};
};

struct FrameStages;  // the stages' outputs; pipeline/run/frame_data.h
struct Topology;     // pipeline/scene/mesh/topology.h

// One computed frame. Immutable and shared: reuse is copying a pointer.
class Frame {
public:
    const Scene& scene() const { return *m_scene; }
    const std::shared_ptr<const Scene>& sharedScene() const { return m_scene; }
    const Plan& plan() const;  // its texts are made when it is first read
    const StageRun& run(StageId stage) const { return m_runs[index(stage)]; }
    double milliseconds() const { return m_milliseconds; }          // wall clock of this frame alone
    double planMilliseconds() const { return m_planMilliseconds; }  // the part of it that planning took
    long number() const { return m_number; }                        // counts from 1 along a chain of frames
    StageId until() const { return m_until; }

    // The buffer, or nothing if the plan left it out or its stage has not run. If a stage keeps it in another form, the
    // first read converts it.
    std::optional<AnyBuffer> buffer(const BufferName& name) const;
    // The reason if buffer() returns nothing, else empty.
    std::string whyAbsent(const BufferName& name) const;
    // All existing buffers, in the order of the stages.
    std::vector<AnyBuffer> buffers() const;

    // A polygon's object and its number in it. Buffers count polygons over all objects in scene order.
    struct PolygonPlace {
        std::size_t object, polygon;
    };
    PolygonPlace placeOf(int polygon) const;

    const FrameStages& stages() const { return *m_stages; }

    BufferSet wanted() const { return m_wanted; }  // the request's
    BufferSet made() const { return m_made; }      // the buffers that were written; all if unread ones are not left out
    const Topology& topology() const { return *m_topology; }
    // Shared by all frames in a row that have the same meshes.
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
    mutable std::vector<AnyBuffer> m_read;  // converted for readers; guarded by m_readMutex
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace pipeline
