#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "pipeline/compare/handed_in/conventions.h"
#include "pipeline/core/stop.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/run/frame.h"

namespace pipeline::foreign {

// Whether right renderers may see another polygon at a pixel: found where somebody asks for it.
enum class PixelState : std::uint8_t { NotAsked, Open, Closed };

// What this program makes of the scene, with all that a comparison reads of it.
struct Reference {
    FramePtr frame;  // in double, with the buffers that are compared
    ReferenceValues values;
    std::map<std::string, double> tolerances;  // by the buffer's name, in its unit
    ReadingContext context;
    PixelCorner corner = PixelCorner::None;  // where pixels are sampled; vertices in the picture stay where they are
    bool isSmaller = false;                  // a picture of fewer pixels than the files': at outlines it tells nothing

    // Per pixel: whether a border between two polygons, or of one, is within a pixel.
    std::vector<std::uint8_t> outline;
    // Per pixel, of OpenPixels: each file and reading asks anew. Shared by copies and threads. Null where outline is empty.
    std::shared_ptr<std::vector<std::atomic<PixelState>>> openPixels;
    // Per light and pixel: whether right renderers may differ in S there, because an edge of a shadow is near or the
    // surface hardly faces the light. Empty where a light casts none.
    std::vector<std::vector<std::uint8_t>> shadowOpen;
    // Per pixel: whether it is in a shadow; whether some light hardly falls on its plane, so that a bias decides; and by how
    // much of 255 the lights that cast shadows may change its colour. Empty where no light casts one.
    std::vector<std::uint8_t> shadowed, grazing;
    std::vector<float> shadowContrast;
    // Per pixel, intensity: the terms of the lights that cast shadows, with S = 1. Empty where no light casts one.
    std::vector<Vec3<float>> unshadowedTerms;
    // Per pixel: the least and the greatest color (0 to 255) and intensity that are right as far as S is open. Empty where
    // no S is.
    std::vector<Color8> colorLow, colorHigh;
    std::vector<Vec3<float>> intensityLow, intensityHigh;
};

// The numbers of a buffer of a frame in double, in the order of the buffer, without a copy: copies of all terms of light
// take as much memory as the frame. Empty where the frame has no such buffer.
class NumbersInPlace {
public:
    NumbersInPlace(const Frame& frame, const std::string& name);
    bool empty() const { return m_numbers.empty(); }
    double operator[](std::size_t number) const { return m_numbers[number]; }
    Vec3d vector(std::size_t pixel) const {  // of a buffer of three channels
        return {m_numbers[3 * pixel], m_numbers[3 * pixel + 1], m_numbers[3 * pixel + 2]};
    }

private:
    std::optional<AnyBuffer> m_buffer;  // keeps the frame's data alive
    std::span<const double> m_numbers;
};

// In double, every rule off, sampled where their pixels are.
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
