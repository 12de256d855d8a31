#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/model_facts.h"

namespace pipeline {

// A model's formula at a pixel, for one of the three colours: in symbols, in numbers, and as the number that it comes to.
// What is written and what is computed are read from the same tree.
struct EquationTerms {
    const Scene& scene;
    const PixelReport& report;
    int c;  // 0, 1 or 2: r, g, b
    const NumberText& chosen;

    const ModelFacts& model() const { return modelFacts(scene.settings.model); }
    const Material& material() const {
        return effectiveMaterial(scene.objects[std::size_t(report.object)], scene.settings, report.back);
    }
    bool halfway() const { return usesHalfway(scene.settings.model, material()); }  // (N·H)^n, not (R·V)^n
    const char* channel() const;

    // What was computed, as chosen, else with so many decimals. The lecture writes exact 0, 1 and -1 without decimals.
    Formula number(double value, int decimals, std::string refers = {}) const;
    Formula wholeOr(double value, int decimals) const;
    Formula components(Vec3d v) const;

    Formula dot(Formula a, Formula b) const;
    Formula L(int k) const;
    Formula R(int k) const;
    Formula H(int k) const;
    Formula N() const;
    Formula V() const;

    // The value of a quantity. light: where it is one of a light, else null.
    double valueOf(Quantity quantity, double index, const Evaluation& e, const LightReport* light) const;
    double valueOf(const Term& term, const Evaluation& e, const LightReport* light) const;
    double productOf(Factors factors, const Evaluation& e, const LightReport* light) const;
    // What the whole formula comes to: before a clamp, the intensity.
    double valueOf(const Evaluation& e) const;

    // The right side of the equation.
    void symbols(std::vector<Formula>& parts) const;
    void numbers(const Evaluation& e, std::vector<Formula>& parts) const;
    Formula symbolsOf(const Term& term, int k) const;
    Formula numbersOf(const Term& term, const Evaluation& e, const LightReport* light) const;

private:
    std::string materialKey(std::string_view name) const;
    Formula indexed(Formula letter, int light) const;
    Formula symbolOf(const Term& leaf, int k) const;
    Formula numberOf(const Term& leaf, const Evaluation& e, const LightReport* light) const;
    void appendSymbols(Factors product, int k, std::vector<Formula>& parts) const;
    void appendNumbers(Factors product, const Evaluation& e, const LightReport* light,
                       std::vector<Formula>& parts) const;
};

}  // namespace pipeline
