#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/compare/own/own_stage.h"
#include "pipeline/core/elementary.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/stages/shading.h"

namespace pipeline::foreign {

namespace {

Vec3d vectorOf(const Values& values, std::size_t i) { return {values.at(i)[0], values.at(i)[1], values.at(i)[2]}; }

// What they have handed in of the terms, and which of it was read.
class TheirTerms {
public:
    TheirTerms(const Conventions& conventions, const Reference& reference) : m_reference(reference) {
        for (const ReadFile& file : conventions.files) m_files.emplace(file.file->name.buffer.text(), &file.mine);
    }

    const Values* find(const std::string& name) const {
        const auto found = m_files.find(name);
        return found == m_files.end() ? nullptr : found->second;
    }
    // Theirs at a pixel, else the reference's.
    Vec3d vector(const std::string& name, std::size_t i) {
        const Values* const theirs = find(name);
        if (theirs && theirs->there[i]) return read(name), vectorOf(*theirs, i);
        const Values* const right = m_reference.values.find(name);
        return right ? vectorOf(*right, i) : Vec3d(0);
    }
    double number(const std::string& name, std::size_t i) {
        const Values* const theirs = find(name);
        if (theirs && theirs->there[i]) return read(name), theirs->at(i)[0];
        const Values* const right = m_reference.values.find(name);
        return right ? right->at(i)[0] : 0;
    }
    void read(const std::string& name) {
        if (std::ranges::find(from, name) == from.end()) from.push_back(name);
    }
    std::vector<std::string> from;

private:
    std::map<std::string, const Values*> m_files;  // asked for each pixel
    const Reference& m_reference;
};

// One light at a pixel with their normal and position, their S, and their dot products where they have handed them in.
class LightThere {
public:
    LightThere(TheirTerms& terms, const Reference& reference, const ShadingInputs& inputs)
        : m_terms(terms), m_reference(reference), m_inputs(inputs) {}

    Surface<double> surface(std::size_t i) {
        Surface<double> out;
        out.color = color(i);
        out.N = m_terms.vector("normal", i);
        out.V = vectorOf(m_reference.values.at("view_vector"), i);
        out.position = vectorOf(m_reference.values.at("position"), i);
        const Values* const z = m_terms.find("z_view");
        if (m_terms.find("position")) {
            out.position = m_terms.vector("position", i);
        } else if (z && z->there[i]) {
            m_terms.read("z_view");
            const std::size_t width = m_reference.context.width;
            out.position =
                worldPoint(m_reference.context.view, {double(i % width) + 0.5, double(i / width) + 0.5}, z->at(i)[0]);
        }
        return out;
    }
    LightSample<double> sample(std::size_t i, std::size_t k, std::size_t object) {
        const Surface<double> at = surface(i);
        return sampleLight(m_inputs.illumination, m_inputs.lights[k], m_inputs.materials[object], at);
    }

private:
    // Of the vertices of what the reference sees there.
    Vec3d color(std::size_t i) const {
        const auto& data = *dataOf<double>(*m_reference.frame);
        if (!m_inputs.colored || data.zBuffer->triangle->pixels[i] == kNoTriangle) return Vec3d(1);
        const std::uint32_t triangle = data.zBuffer->triangle->pixels[i];
        const auto width = int(m_reference.context.width);
        RowCrossings row;
        return pixelColor(m_inputs, data.shadingSources(), data.transform->topology->polygonOf(triangle),
                          vertexWeights(m_inputs.interpolation, *data.transform, triangle,
                                        data.zBuffer->barycentric.pixels[i], {int(i) % width, int(i) / width}, row));
    }

    TheirTerms& m_terms;
    const Reference& m_reference;
    const ShadingInputs& m_inputs;
};

}  // namespace

std::vector<std::string> ownShading(const Conventions& conventions, const Reference& reference,
                                    const BufferName& buffer, Values& right) {
    const auto& data = *dataOf<double>(*reference.frame);
    const ShadingInputs inputs = withAllVectors(data.keys.shading);
    TheirTerms terms(conventions, reference);
    LightThere there(terms, reference, inputs);
    const Values& objects = reference.values.at("object_id");
    const std::size_t lights = inputs.lights.size();
    const bool byPixel = inputs.shading == Shading::Phong;
    const auto transmittance = reference.frame->buffer({BufferId::Transmittance});
    const auto translucent = reference.frame->buffer({BufferId::Translucent});
    const std::string k = std::to_string(buffer.light);
    const auto has = [&](std::initializer_list<std::string> names) {
        return std::ranges::any_of(names, [&](const std::string& name) { return terms.find(name); });
    };
    using enum BufferId;
    // A term with S at a pixel: from their dot product where they have one, else from their normal.
    const auto term = [&](BufferId id, std::size_t i, std::size_t light) {
        const std::string of = std::to_string(light);
        const auto object = std::size_t(objects.at(i)[0]);
        LightSample<double> s = there.sample(i, light, object);
        const double nDotL = terms.find("n_dot_l." + of) ? terms.number("n_dot_l." + of, i) : s.nDotL;
        const double shadow = terms.number("shadow." + of, i);
        if (id == Diffuse) {
            if (nDotL <= 0) return Vec3d(0);
            return shadow * (s.nDotL > 0 ? s.diffuse * (nDotL / s.nDotL) : s.diffuse);
        }
        const bool halfway = usesHalfway(inputs.illumination.model, inputs.materials[object]);
        const std::string dot = (halfway ? "n_dot_h." : "r_dot_v.") + of;
        if (nDotL <= 0) return Vec3d(0);
        if (terms.find(dot) && s.specularPower > 1e-9) {
            const double cosine = std::clamp(terms.number(dot, i), 0.0, 1.0);
            const double n = effectiveExponent(inputs.illumination.model, inputs.illumination.exponentFactor,
                                               inputs.materials[object]);
            return shadow * s.specular * (pipeline::pow(cosine, n) / s.specularPower);
        }
        return shadow * s.specular;
    };
    const auto at = [&](std::size_t i) -> std::optional<Vec3d> {
        const auto object = std::size_t(objects.at(i)[0]);
        const auto light = std::size_t(std::max(0, buffer.light));
        switch (buffer.id) {
            case LightVector:
            case ReflectionVector:
            case HalfwayVector:
            case NDotL:
            case RDotV:
            case NDotH: {
                if (!byPixel || !has({"normal", "position", "z_view"})) return {};
                if (buffer.id != LightVector && !has({"normal"})) return {};
                const LightSample<double> s = there.sample(i, light, object);
                if (buffer.id == LightVector) return s.L;
                if (buffer.id == ReflectionVector) return s.R;
                if (buffer.id == HalfwayVector) return s.H;
                return Vec3d(buffer.id == NDotL ? s.nDotL : buffer.id == RDotV ? s.rDotV : s.nDotH);
            }
            case Diffuse:
            case Specular:
                if (!byPixel || !has({"normal", "n_dot_l." + k, "r_dot_v." + k, "n_dot_h." + k, "shadow." + k}))
                    return {};
                return term(buffer.id, i, light);
            case Color:
                if (const Values* const theirs = terms.find("intensity"); theirs && theirs->there[i]) {
                    const Color8 color = frameBufferValue(terms.vector("intensity", i), reference.context.iMax);
                    return Vec3d(color[0], color[1], color[2]);
                }
                [[fallthrough]];
            case Intensity: {
                bool any = has({"ambient", "emission"});
                for (std::size_t l = 0; l < lights; ++l) {
                    const std::string of = std::to_string(l);
                    any = any || has({"diffuse." + of, "specular." + of});
                    any = any || (byPixel && has({"normal", "n_dot_l." + of, "shadow." + of}));
                }
                if (!any) return {};
                Vec3d sum = terms.vector("ambient", i) + terms.vector("emission", i);
                for (std::size_t l = 0; l < lights; ++l)
                    for (const BufferId id : {Diffuse, Specular}) {
                        const std::string name = (id == Diffuse ? "diffuse." : "specular.") + std::to_string(l);
                        sum += terms.find(name) || !byPixel ? terms.vector(name, i) : term(id, i, l);
                    }
                if (transmittance) sum *= transmittance->flat(i);
                if (translucent)
                    sum += Vec3d(translucent->flat(3 * i), translucent->flat(3 * i + 1), translucent->flat(3 * i + 2));
                if (buffer.id == Intensity) return sum;
                const Color8 color = frameBufferValue(sum, reference.context.iMax);
                return Vec3d(color[0], color[1], color[2]);
            }
            default: return {};
        }
    };
    for (std::size_t i = 0; i < right.count(); ++i) {
        if (!reference.context.covered[i]) continue;
        const auto value = at(i);
        if (!value) return {};
        for (int c = 0; c < right.channels; ++c) right.at(i)[c] = std::isfinite((*value)[c]) ? (*value)[c] : 0;
    }
    return terms.from;
}

}  // namespace pipeline::foreign
