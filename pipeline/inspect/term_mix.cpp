#include "pipeline/inspect/term_mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "pipeline/core/number.h"
#include "pipeline/core/text.h"
#include "pipeline/run/frame_data.h"

namespace pipeline {
namespace {

constexpr std::array<std::string_view, 4> kTermNames{"emission", "ambient", "diffuse", "specular"};

constexpr std::string_view kSolo = "solo", kMuted = "muted";

BufferName bufferOf(const TermStrip& strip) {
    constexpr std::array kBuffers{BufferId::Emission, BufferId::Ambient, BufferId::Diffuse, BufferId::Specular};
    return {kBuffers[std::size_t(strip.kind)], strip.light};
}

// "diffuse.0", as parseMix reads it.
std::string key(const TermStrip& strip) {
    const std::string name(kTermNames[std::size_t(strip.kind)]);
    return strip.light < 0 ? name : fmt::format("{}.{}", name, strip.light);
}

template <class Real>
using TermPicture = Buffer2D<Vec3<Real>>;

template <class Real>
struct Terms {
    std::vector<const TermPicture<Real>*> pictures;  // of the strips, in their order
    std::vector<Real> weights;
    const TermPicture<Real>* translucent = nullptr;  // null where no layers are laid over
    const Buffer2D<Real>* transmittance = nullptr;

    // The stage adds emission and ambient first, each light's two terms after that.
    Vec3<Real> sumAt(std::size_t i) const {
        Vec3<Real> sum = weights[0] * pictures[0]->pixels[i] + weights[1] * pictures[1]->pixels[i];
        for (std::size_t k = 2; k < pictures.size(); ++k) sum += weights[k] * pictures[k]->pixels[i];
        if (translucent) sum = transmittance->pixels[i] * sum + translucent->pixels[i];
        return sum;
    }
};

template <class Real>
Result<MixedPicture> mixOf(const Frame& frame, const FrameData<Real>& data, const TermMix& mix, const Stop& stop) {
    const auto lacks = [&](const BufferName& name) {
        return Error{{}, fmt::format("no {} in this frame: {}", name.text(), frame.whyAbsent(name))};
    };
    if (!data.shading || !data.zBuffer) return lacks({BufferId::Ambient});
    const ShadingOutput<Real>& shading = *data.shading;
    Terms<Real> terms;
    for (std::size_t i = 0; i < mix.size(); ++i) {
        const auto& pictures = shading.vectors[index(bufferOf(mix[i]).id)];
        const std::size_t light = std::size_t(std::max(0, mix[i].light));
        if (light >= pictures.size() || pictures[light].empty()) return lacks(bufferOf(mix[i]));
        terms.pictures.push_back(&pictures[light]);
        terms.weights.push_back(Real(weight(mix, i)));
    }
    if (data.keys.shading.layers.drawn) {
        const auto& added = shading.vectors[index(BufferId::Translucent)];
        const auto& left = shading.scalars[index(BufferId::Transmittance)];
        if (added.empty() || left.empty()) return lacks({BufferId::Translucent});
        terms.translucent = &added[0];
        terms.transmittance = &left[0];
    }
    const glm::ivec2 size = shading.color.size;
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(3 * shading.color.pixels.size());
    MixedPicture mixed;
    for (int y = 0; y < size.y; ++y) {
        if (stop.stop_requested()) return Error{{}, "stopped"};
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = shading.color.offset({x, y});
            const Vec3d intensity(terms.sumAt(i));
            const Color8 value = frameBufferValue(intensity, shading.iMax, data.keys.shading.planted);
            for (int c = 0; c < 3; ++c) (*bytes)[3 * i + std::size_t(c)] = value[c];
            mixed.clamped += std::max({intensity.x, intensity.y, intensity.z}) > shading.iMax;
        }
    }
    mixed.color = {{BufferId::Mix},
                   &bufferInfo(BufferId::Mix),
                   {std::size_t(size.y), std::size_t(size.x), 3},
                   std::span<const std::uint8_t>(*bytes),
                   bytes};
    return mixed;
}

}  // namespace

std::string TermStrip::name() const {
    const std::string_view kindName = kTermNames[std::size_t(kind)];
    return light < 0 ? std::string(kindName) : fmt::format("{} {}", kindName, light);
}

TermMix plainMix(std::size_t lights) {
    TermMix mix{{TermKind::Emission}, {TermKind::Ambient}};
    for (int k = 0; k < int(lights); ++k)
        for (const TermKind kind : {TermKind::Diffuse, TermKind::Specular}) mix.push_back({kind, k});
    return mix;
}

bool isPlain(const TermMix& mix) {
    return std::ranges::all_of(mix, [](const TermStrip& s) { return s.gain == 1 && !s.solo && !s.muted; });
}

double weight(const TermMix& mix, std::size_t strip) {
    const bool anySolo = std::ranges::any_of(mix, &TermStrip::solo);
    return mix[strip].muted || (anySolo && !mix[strip].solo) ? 0 : mix[strip].gain;
}

std::string describe(const TermMix& mix) {
    if (isPlain(mix)) return "every term";
    const bool anySolo = std::ranges::any_of(mix, &TermStrip::solo);
    std::string text;
    for (std::size_t i = 0; i < mix.size(); ++i) {
        const double w = weight(mix, i);
        if (anySolo ? w == 0 : w == 1) continue;
        std::string one = mix[i].name();
        if (w == 0)
            one = fmt::format("no {}", one);
        else if (w != 1)
            one = fmt::format("{} × {}", one, shortestText(w));
        text += (text.empty() ? "" : ", ") + one;
    }
    if (text.empty()) return "no term";
    return anySolo ? text + " alone" : text;
}

Result<TermMix> parseMix(std::string_view text, std::size_t lights) {
    TermMix mix = plainMix(lights);
    std::vector<std::string_view> gained;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::string_view name = word.substr(0, word.find('='));
        const auto strip = std::ranges::find_if(mix, [&](const TermStrip& s) { return key(s) == name; });
        if (strip == mix.end()) {
            std::string known;
            for (const TermStrip& s : mix) known += (known.empty() ? "" : ", ") + key(s);
            return Error{{}, fmt::format("there is no term {}", inQuotes(name)), known};
        }
        const std::string_view number = name.size() < word.size() ? word.substr(name.size() + 1) : std::string_view();
        if (number == kSolo || number == kMuted) {
            (number == kSolo ? strip->solo : strip->muted) = true;
            continue;
        }
        const double gain = readNumber(number).value_or(-1);
        if (!(gain >= 0 && gain <= kMostGain))
            return Error{{},
                         fmt::format("found {}", inQuotes(word)),
                         fmt::format("{}=GAIN, from 0 to 4, =solo or =muted", key(*strip))};
        if (std::ranges::find(gained, name) != gained.end())
            return Error{{}, fmt::format("the gain of {} is given twice", name), "each once"};
        gained.push_back(name);
        strip->gain = gain;
    }
    return mix;
}

std::string mixText(const TermMix& mix) {
    std::string text;
    const auto add = [&](const TermStrip& strip, std::string_view value) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ",", key(strip), value);
    };
    for (const TermStrip& strip : mix) {
        if (strip.gain != 1) add(strip, shortestText(strip.gain));
        if (strip.solo) add(strip, kSolo);
        if (strip.muted) add(strip, kMuted);
    }
    return text;
}

BufferSet mixBuffers() {
    return setOf({BufferId::Emission, BufferId::Ambient, BufferId::Diffuse, BufferId::Specular, BufferId::Translucent,
                  BufferId::Transmittance});
}

std::string whyNoMix(const Scene& scene) {
    if (scene.settings.visibility == Visibility::None) return "Outlines are not shaded: they have no terms.";
    return {};
}

Result<MixedPicture> mixTerms(const Frame& frame, const TermMix& terms, Stop stop) {
    assert(terms.size() == plainMix(frame.scene().lights.size()).size());
    return readStages(frame, [&](const auto& data) { return mixOf(frame, data, terms, stop); });
}

}  // namespace pipeline
