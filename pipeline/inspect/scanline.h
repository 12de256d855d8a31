#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// A section through a picture along one row of pixels: how deep every polygon lies there, and how bright the row is
// with each shading method.

// One polygon's fragments in the row, left to right. A polygon may have several runs: what lies between is not its own.
struct ScanlineRun {
    int polygon = -1;  // over all objects
    struct Sample {
        int x = 0;
        double depth = 0;    // as it was compared: z_view, or the number that the depth format stores
        bool stays = false;  // it is what the pixel shows
    };
    std::vector<Sample> samples;
};

inline constexpr std::array<std::string_view, 3> kSectionShadings{"flat", "gouraud", "phong"};

struct ScanlineSection {
    int row = 0;
    int width = 0;                  // of the picture, pixels
    bool storesDepth = false;       // depths are those of a depth format, else z_view in world units
    bool nearIsLarger = false;      // of a reversed format
    std::vector<ScanlineRun> runs;  // in the order of drawing
    // Per shading method of kSectionShadings and x the intensity before it is scaled by I_max, r g b; NaN where
    // nothing is drawn, no translucent layer either. Empty until they are computed.
    std::array<std::vector<Vec3d>, 3> intensity;
    double iMax = 0;  // of the frame's own shading

    bool empty() const;
    std::optional<int> winnerAt(int x) const;  // the polygon that the pixel shows
    bool isShadedAt(int x) const;              // an opaque polygon or translucent layers
    std::pair<int, int> extent() const;        // first and last x of what is drawn; {0, width − 1} where nothing is
};

// What the frame of a section holds.
inline BufferSet sectionBuffers() { return setOf({BufferId::Intensity, BufferId::Layers}); }

// row: within the picture. The frame's z-buffer stage has run. What is stopped has fewer runs.
ScanlineSection scanlineSection(const Frame& frame, int row, const Stop& stop = {});
// With the intensities of all three shading methods: two more frames, which reuse what they can of this one. Nothing
// when stopped.
std::optional<ScanlineSection> shadedSection(const FramePtr& frame, int row, int threads, Stop stop = {});

// The row half way between the first and the last in which an opaque polygon is seen; the middle one where none is. The
// frame's z-buffer stage has run.
int middleDrawnRow(const Frame& frame);

// A line per x: the polygon seen, the depth of each polygon of the row (empty where it has no fragment), and the
// intensity of each method in r, g, b. RFC 4180, exact numbers.
std::string sectionCsv(const ScanlineSection& section);

}  // namespace pipeline
