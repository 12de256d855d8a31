#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// The terms of the illumination as the strips of a mixing desk: each with a gain, alone (solo), or not at all (muted).

enum class TermKind : std::uint8_t { Emission, Ambient, Diffuse, Specular };
struct TermStrip {
    TermKind kind;
    int light = -1;   // of diffuse and specular; the other two are sums over the lights
    double gain = 1;  // 0 to kMostGain
    bool solo = false, muted = false;
    std::string name() const;  // "diffuse 0"
    bool operator==(const TermStrip&) const = default;
};
inline constexpr double kMostGain = 4;

// In the order in which the shading stage adds them up: emission, ambient, then diffuse and specular of each light.
using TermMix = std::vector<TermStrip>;
TermMix plainMix(std::size_t lights);
bool isPlain(const TermMix& mix);  // every term as it is
// What a term is multiplied by: 0 where it is muted, or another strip is solo and it is not; else its gain.
double weight(const TermMix& mix, std::size_t strip);
std::string describe(
    const TermMix& mix);  // "diffuse 0 alone", "specular 0 × 2.5, no ambient"; "every term" where plain

// "diffuse.0=2,ambient=muted,specular.0=solo": the strips that are named take these gains, or stand alone, or are left
// out. Errors say which word, and what is expected.
Result<TermMix> parseMix(std::string_view text, std::size_t lights);
std::string mixText(const TermMix& mix);  // that parseMix reads as the same mix; empty where every term is as it is

// The buffers that mixing reads.
BufferSet mixBuffers();
// Why the pictures of a scene cannot be mixed; empty where they can.
std::string whyNoMix(const Scene& scene);

// The picture that the weighted terms make: their sum in the stage's own order and precision, under the translucent
// layers as they are, scaled by the frame's I_max and rounded as the frame buffer is. Where every weight is 1 it has
// the bits of `color`; beside that the last bit may differ where the arithmetic is `fast`, and with more than one
// sample a pixel `color` is a mean, this a pixel's centre.
struct MixedPicture {
    AnyBuffer color;          // the buffer `mix`: {H, W, 3}, uint8
    std::size_t clamped = 0;  // pixels of which a channel is above I_max
};
// An error names the buffer that the frame lacks. whyNoMix(scene) is empty. Stopped: the error "stopped".
Result<MixedPicture> mixTerms(const Frame& frame, const TermMix& mix, Stop stop = {});

}  // namespace pipeline
