#pragma once
#include <bitset>
#include <concepts>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/plan/needs.h"

namespace pipeline {

// What decides the needs of one scene, part by part: each is decided when it is first asked for, and may ask for others.
class Decision {
public:
    const Scene& scene;
    const Scene& drawn;  // without what light cannot show
    StageId until;       // after this stage the run ends

    Decision(const Scene& whole, const Scene& lit, StageId last, Needs& out);

    const Need& operator[](Part part) const;
    const Need& of(Part part, std::size_t light) const;
    const std::vector<bool>& ownNormals() const;  // Needs::ownNormals
    bool isInForce(Rule rule) const { return m_needs.rules[index(rule)]; }
    BufferSet wanted() const { return m_needs.buffers; }
    bool isRead(Part part) const { return m_reads[part]; }  // by a buffer that is asked for

    void decide(Part part) const;

    // Left out for the reason where the rule is in force, else needed. An empty reason: needed.
    Need unless(Rule rule, std::string reason) const;
    // Left out by the stage, element by element.
    Need within(Rule rule) const { return isInForce(rule) ? Need{{}, rule} : Need{}; }
    // A reason that holds for all objects, or for those that are drawn alone.
    std::string ofAll(const std::string& all, const std::string& ofDrawn) const {
        return &drawn == &scene ? all : ofDrawn;
    }

private:
    Needs& m_needs;
    PartSet m_reads;
    mutable std::bitset<kPartCount> m_isDecided;
};

// A text, or what a function makes of the scene and its needs, and of a light where the part is per light.
struct Words {
    using Of = std::string (*)(const Scene& scene, const Needs& needs, std::size_t light);
    std::string_view text{};
    Of of = nullptr;

    constexpr Words() = default;
    constexpr Words(const char* one) : text(one) {}
    template <std::convertible_to<Of> F>
    constexpr Words(F make) : of(make) {}
    std::string operator()(const Scene& scene, const Needs& needs, std::size_t light = 0) const {
        return of ? of(scene, needs, light) : std::string(text);
    }
};

struct PartInfo {
    Part id;
    StageId stage;
    std::string_view name{};  // in the plan, "{}" for the light's number; empty: the plan does not list it
    bool isHanded = true;     // to the stage, in its Parts; else it is told in another way, or the runner sees to it
    Need (*need)(const Decision& d, std::size_t light);
    // Of a part per light, of all lights together; null: the part is not per light.
    Need (*forAll)(const Scene& scene, const std::vector<Need>& each) = nullptr;
    Words runs{};    // why it is carried out
    Words within{};  // likewise, where the stage leaves some of it out; empty where that is not said
    Words saves{};   // what is saved where a rule leaves it out
    bool (*isListed)(const Scene& scene, const Needs& needs) = nullptr;  // null: always
    bool ofOutlines = true;                                              // also listed where outlines are drawn
    Words useless{};  // why a scene has no use for the buffers that read it, or empty
};
const PartInfo& partInfo(Part part);

}  // namespace pipeline
