// Defects within the illumination of a point by one light, and in the test of its shadow.
#include <algorithm>
#include <cmath>

#include "pipeline/defects/defect_ways.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/stages/shadow_factor.h"

namespace pipeline {
namespace {

// What no formula of a scene within its ranges comes near, and what float still squares.
constexpr double kMost = 1e18;

// A value that is none becomes 0, one without bound the largest.
template <class Real>
Real bounded(Real x) {
    return x > Real(-kMost) ? (x < Real(kMost) ? x : Real(kMost)) : (x <= Real(-kMost) ? Real(-kMost) : Real(0));
}
template <class Real>
Vec3<Real> bounded(Vec3<Real> v) {
    return {bounded(v.x), bounded(v.y), bounded(v.z)};
}

// From the surface to the light, at its own length.
template <class Real>
Vec3<Real> rawDirection(const Light& light, const Surface<Real>& at) {
    const Vec3<Real> place(light.position);
    return light.kind == LightKind::AtInfinity ? place : place - at.position;
}

// What follows from another L.
template <class Real>
void follow(const Surface<Real>& at, UnitForm unit, LightSample<Real>& s) {
    s.nDotL = bounded(glm::dot(at.N, s.L));
    s.R = bounded(2 * s.nDotL * at.N - s.L);
    s.rDotV = bounded(glm::dot(s.R, at.V));
    s.H = normalized(s.L + at.V, unit);
    s.nDotH = glm::dot(at.N, s.H);
}

// The terms of the model for other directions, or with another form of the power.
template <class Real>
LightSample<Real> termsOf(const Illumination& illumination, const Light& light, const Material& material,
                          const Surface<Real>& at, bool attenuated, PowerForm form, LightSample<Real> s) {
    LightDetail detail = illumination.detail;
    detail.power = form;
    s.ambient = s.diffuse = s.specular = Vec3<Real>(0);
    std::get<AddLight<Real>>(lightTermsOf(illumination.model))(
        {light, material, at, detail, effectiveExponent(illumination.model, illumination.exponentFactor, material),
         usesHalfway(illumination.model, material), attenuated},
        s);
    return s;
}

}  // namespace

template <class Real>
void spoilDirections(const Illumination& illumination, const Light& light, const Surface<Real>& at,
                     LightSample<Real>& s) {
    const Planted& planted = illumination.detail.planted;
    const UnitForm unit = illumination.detail.unit;
    if (planted.own && ownDirections(*planted.own, light, at, s)) follow(at, unit, s);
    switch (planted.defect) {
        case Defect::LRaw:
            s.L = rawDirection(light, at);
            follow(at, unit, s);
            return;
        case Defect::LightFrom:
            s.L = -s.L;
            follow(at, unit, s);
            return;
        case Defect::RFlip:
            s.R = planted.way == 0   ? s.L - 2 * s.nDotL * at.N
                  : planted.way == 1 ? s.nDotL * at.N - s.L
                                     : 2 * s.nDotL * (at.N - s.L);
            if (planted.way == 3) s.R = normalized(s.R, unit);
            s.rDotV = glm::dot(s.R, at.V);
            return;
        case Defect::NormalShort:
            if (planted.way == 1) {  // after N·L it is made unit
                const Vec3<Real> n = normalized(at.N, unit);
                s.R = Real(2) * glm::dot(n, s.L) * n - s.L;
                s.rDotV = glm::dot(s.R, at.V), s.nDotH = glm::dot(n, s.H);
            }
            return;
        case Defect::HRaw:
            s.H = planted.way == 0 ? normalized(rawDirection(light, at) + at.V, unit) : (s.L + at.V) / Real(2);
            s.nDotH = glm::dot(at.N, s.H);
            return;
        default: return;
    }
}

template <class Real>
void spoilTerms(const Illumination& illumination, const Light& light, const Material& material, const Surface<Real>& at,
                bool attenuated, LightSample<Real>& s) {
    const Planted& planted = illumination.detail.planted;
    const auto again = [&](const Surface<Real>& surface, const LightSample<Real>& sample, PowerForm form) {
        return termsOf(illumination, light, material, surface, attenuated, form, sample);
    };
    const PowerForm form = illumination.detail.power;
    const bool behind = !(s.nDotL > 0);
    if (planted.own) {
        if (isOwnVectorOff(*planted.own, at, s)) s = again(at, s, PowerForm::Pow);
        return ownTerms(*planted.own, illumination, light, material, at, s);
    }
    switch (planted.defect) {
        // The stable form of the power is of unit vectors alone.
        case Defect::LRaw:
        case Defect::NormalShort: s = again(at, s, PowerForm::Pow); break;
        case Defect::HRaw:
            if (planted.way > 0) s = again(at, s, PowerForm::Pow);
            break;
        case Defect::RFlip:
            if (planted.way > 0) s = again(at, s, PowerForm::Pow);
            break;
        case Defect::Exponent: {  // left out, or a factor
            if (planted.way == kPowerOfNegative) {
                // NaN, whose byte is 0. Buffers hold in its place what stays below 0 whatever is added.
                const bool isLobe = modelFacts(illumination.model).lobe != Lobe::None;
                const Real cosine = usesHalfway(illumination.model, material) ? s.nDotH : s.rDotV;
                if (isLobe && !behind && cosine < 0 && material.specular != Vec3d(0))
                    s.specular = Vec3<Real>(Real(-kMost));
                break;
            }
            Material linear = material;
            linear.exponent /= effectiveExponent(illumination.model, illumination.exponentFactor, material);
            s.specular = termsOf(illumination, light, linear, at, attenuated, PowerForm::Pow, s).specular;
            if (planted.way == 3) s.specular *= Real(material.exponent);
            break;
        }
        case Defect::NoMax:
            if (planted.way >= 2) {  // half Lambert, and its square
                LightSample<Real> other = s;
                other.nDotL = (s.nDotL + 1) / 2;
                if (planted.way > 2) other.nDotL *= other.nDotL;
                s.diffuse = again(at, other, form).diffuse;
            } else if (behind) {
                // The term is linear in N·L: of the other side, with the sign that was not cut off, or cut off too much.
                LightSample<Real> other = s;
                other.nDotL = -s.nDotL;
                const Vec3<Real> diffuse = again({at.position, -at.N, at.V}, other, form).diffuse;
                s.diffuse = planted.way == 0 ? -diffuse : diffuse;
            }
            break;
        case Defect::SpecBehind:
            if (behind) {
                LightSample<Real> lit = s;
                lit.nDotL = 1;  // its diffuse term is not taken
                lit = again(at, lit, form);
                s.specular = lit.specular, s.specularPower = lit.specularPower, s.power = lit.power;
            }
            break;
        case Defect::KsKd: s.specular *= Vec3<Real>(material.diffuse); break;
        case Defect::NoSpecular: s.specular = Vec3<Real>(0); break;
        case Defect::FadeTwice:
            s.ambient *= s.fading, s.diffuse *= s.fading, s.specular *= s.fading;
            s.fading *= s.fading;
            break;
        default: break;
    }
    s.specularPower = bounded(s.specularPower);
    s.ambient = bounded(s.ambient), s.diffuse = bounded(s.diffuse) + Vec3<Real>(0);
    s.specular = bounded(s.specular) + Vec3<Real>(0);
}

template <class Real>
void spoilShadowPoint(const ShadowSettings& settings, Vec3<Real>& position) {
    if (settings.planted.defect == Defect::ShadowSpace) position = toView(*settings.eye, position);
}

void spoilTexel(const ShadowSettings& settings, glm::ivec2 size, glm::ivec2& texel) {
    if (settings.planted.defect == Defect::ShadowFlip) texel.y = size.y - 1 - texel.y;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                            \
    template void spoilDirections(const Illumination&, const Light&, const Surface<Real>&, LightSample<Real>&); \
    template void spoilTerms(const Illumination&, const Light&, const Material&, const Surface<Real>&, bool,    \
                             LightSample<Real>&);                                                               \
    template void spoilShadowPoint(const ShadowSettings&, Vec3<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
