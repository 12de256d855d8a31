#pragma once
#include <map>
#include <memory>

#include "pipeline/compare/handed_in/conventions.h"
#include "pipeline/core/stop.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/run/frame.h"

namespace pipeline::foreign {

// What this program makes of the scene, with all that a comparison reads of it.
struct Reference {
    FramePtr frame;       // in double, with nothing left out
    FramePtr unshadowed;  // the same without shadows; null where no light casts one
    ReferenceValues values;
    std::map<std::string, double> tolerances;  // by the buffer's name, in its unit
    ReadingContext context;
    PixelCorner corner = PixelCorner::None;  // where pixels are sampled; vertices in the picture stay where they are
    bool isSmaller = false;                  // a picture of fewer pixels than the files': at outlines it tells nothing

    // Per pixel: whether a border between two polygons, or of one, is within a pixel.
    std::vector<std::uint8_t> outline;
    // Per light and pixel: whether right renderers may differ in S there, because an edge of a shadow is near or the
    // surface hardly faces the light. Empty where a light casts none.
    std::vector<std::vector<std::uint8_t>> shadowOpen;
    // Per pixel: whether it is in a shadow; whether some light hardly falls on its plane, so that a bias decides; and by how
    // much of 255 the lights that cast shadows may change its colour. Empty where no light casts one.
    std::vector<std::uint8_t> shadowed, grazing;
    std::vector<double> shadowContrast;
    // Per pixel, of color and intensity: the values between which they are right as far as S is open. Empty where no S is.
    Values colorLow, colorHigh, intensityLow, intensityHigh;
};

// In double, with nothing left out, sampled where their pixels are: what is compared with.
std::shared_ptr<const Scene> referenceScene(Scene scene, PixelCorner corner = PixelCorner::None);

inline constexpr int kShadowBand = 3;  // pixels around an edge of a shadow: texels of any resolution

// `overrides`: by the buffer's name without a light's index, in its unit. Nothing where it was stopped.
std::optional<Reference> makeReference(const Scene& scene, const std::map<std::string, double>& overrides, Stop stop,
                                       PixelCorner corner = PixelCorner::None);

// The same of a scene with an error, for the buffers that are compared alone, with the tolerances of the right one. What
// its frame has in common with `before` (may be null) serves again.
std::optional<Reference> makeHypothesis(const Scene& wrong, const Reference& right, BufferSet compared,
                                        PixelCorner corner, const FramePtr& before, const Stop& stop);

}  // namespace pipeline::foreign
