#include "pipeline/inspect/equation_terms.h"
#include "pipeline/core/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/inspect/formula_parts.h"

namespace pipeline {
namespace {

// Of a setting, or of a product of two: 15 digits give back every decimal number that was written, and none of the noise
// of a product (1.1 · 0.2).
std::string settingText(double value) {
    return shortest(pipeline::readNumber(fmt::format("{:.15g}", value)).value_or(value));
}

using TermForm = Term::Kind;

constexpr const char* kChannels[]{"r", "g", "b"};
constexpr const char* kColors[]{"red", "green", "blue"};

bool isPlain(const Formula& f) { return f.kind == Formula::Kind::Text && f.refers.empty(); }

// Adds the factors of a product of numbers, a point between each two; finish() adds the last ones.
class NumberRow {
public:
    explicit NumberRow(std::vector<Formula>& parts) : m_parts(parts) {}
    void add(Formula factor) {
        if (!m_isFirst) m_plain += "·";
        m_isFirst = false;
        if (isPlain(factor)) {
            m_plain += factor.text;
            return;
        }
        finish();
        m_parts.push_back(std::move(factor));
    }
    // A factor that a clamp set to 0.
    void addClamped(Formula factor) {
        add(struck(std::move(factor)));
        m_parts.push_back(text("0"));
    }

    void finish() {
        if (!m_plain.empty()) m_parts.push_back(text(std::move(m_plain)));
        m_plain.clear();
    }

private:
    std::vector<Formula>& m_parts;
    std::string m_plain;
    bool m_isFirst = true;
};

// Whether a formula is to stand between parentheses as a factor or below an exponent.
bool isSum(const Term& term) { return term.kind == TermForm::Sum || term.kind == TermForm::Difference; }

Formula between(const char* left, Formula inside, const char* right) {
    return row({text(left), std::move(inside), text(right)});
}

}  // namespace

const char* EquationTerms::channel() const { return kChannels[c]; }
std::string EquationTerms::materialKey(std::string_view name) const {
    return fmt::format("material.{}.{}", report.object, name);
}

Formula EquationTerms::number(double value, int decimals, std::string refers) const {
    const auto own = chosen ? chosen(value) : std::nullopt;
    return own ? numeral(*own, std::move(refers)) : text(fixed(value, decimals), std::move(refers));
}
Formula EquationTerms::wholeOr(double value, int decimals) const {
    return number(value, value == 0 || value == 1 || value == -1 ? 0 : decimals);
}
Formula EquationTerms::components(Vec3d v) const {
    return row({text("("), wholeOr(v.x, 3), text(","), wholeOr(v.y, 3), text(","), wholeOr(v.z, 3), text(")")});
}

// L, R, N·L carry the light's index only where there are several.
Formula EquationTerms::indexed(Formula letter, int light) const {
    return scene.lights.size() > 1 ? script(std::move(letter), text(std::to_string(light)), row({})) : letter;
}
Formula EquationTerms::dot(Formula a, Formula b) const {
    return row({text("("), std::move(a), text("·"), std::move(b), text(")")});
}
Formula EquationTerms::L(int k) const { return indexed(vector(VectorCode::L, fmt::format("light_vector.{}", k)), k); }
Formula EquationTerms::R(int k) const {
    return indexed(vector(VectorCode::R, fmt::format("reflection_vector.{}", k)), k);
}
Formula EquationTerms::H(int k) const { return indexed(vector(VectorCode::H, fmt::format("halfway_vector.{}", k)), k); }
Formula EquationTerms::N() const { return vector(VectorCode::N, "normal"); }
Formula EquationTerms::V() const { return vector(VectorCode::V, "view_vector"); }

double EquationTerms::valueOf(Quantity quantity, double index, const Evaluation& e, const LightReport* light) const {
    using enum Quantity;
    const auto notBelow0 = [](double cosine) { return std::max(cosine, 0.0); };
    const Light* const source = light ? &scene.lights[std::size_t(light->light)] : nullptr;
    switch (quantity) {
        case Emission: return material().emission[c];
        case Ambient: return e.color[c] * material().ambient[c];
        case AmbientLight: return scene.ambient.lightIn(scene.settings.model)[c];
        case Diffuse: return e.color[c] * material().diffuse[c];
        case Specular: return material().specular[c];
        case Exponent: return effectiveExponent(scene.settings.model, scene.settings.exponentFactor, material());
        case Shadow: return light->shadow;
        case Fading: return light->fading;
        case Intensity:
        case GlDiffuse: return source->intensity * source->color[c];
        case GlAmbient: return source->intensity * source->gl.ambient[c];
        case GlSpecular: return source->intensity * source->gl.specular[c];
        case NDotL: return notBelow0(light->nDotL);
        case Mirror: return notBelow0(halfway() ? light->nDotH : light->rDotV);
        case NDotV: return notBelow0(glm::dot(e.N, e.V));
        case NDotH: return notBelow0(light->nDotH);
        case VDotH: return notBelow0(glm::dot(e.V, light->H));
        case LDotV: return glm::dot(light->L, e.V);
        case Factor: return light->factors[std::size_t(index)];
        case Number: return index;
    }
    return 0;
}

double EquationTerms::valueOf(const Term& term, const Evaluation& e, const LightReport* light) const {
    const auto part = [&](std::size_t i) { return valueOf(term.parts[i], e, light); };
    switch (term.kind) {
        case TermForm::Leaf: return valueOf(term.quantity, term.number, e, light);
        case TermForm::Sum: {
            double sum = 0;
            for (const Term& summand : term.parts) sum += valueOf(summand, e, light);
            return sum;
        }
        case TermForm::Difference: return part(0) - part(1);
        case TermForm::Product: return productOf(term.parts, e, light);
        case TermForm::Power: {
            const bool isMirror = term.parts[0].quantity == Quantity::Mirror && term.parts[0].kind == TermForm::Leaf;
            return isMirror ? light->specularPower : std::pow(part(0), part(1));
        }
        case TermForm::Fraction: return part(0) / part(1);
        case TermForm::Root: return std::sqrt(part(0));
        case TermForm::Largest: return std::max(part(0), part(1));
    }
    return 0;
}

double EquationTerms::productOf(Factors factors, const Evaluation& e, const LightReport* light) const {
    double product = 1;
    for (const Term& factor : factors) product *= valueOf(factor, e, light);
    return product;
}

double EquationTerms::valueOf(const Evaluation& e) const {
    double sum = 0;
    for (const Term& term : model().base) sum += valueOf(term, e, nullptr);
    const LightFormula& formula = model().light;
    for (const LightReport& light : e.lights) {
        const auto optional = [&](Factors factors) { return factors.empty() ? 0 : productOf(factors, e, &light); };
        const double reflected = light.nDotL > 0 ? optional(formula.diffuse) + optional(formula.specular) : 0;
        sum += productOf(formula.before, e, &light) *
               (optional(formula.ambient) + productOf(formula.shadowed, e, &light) * reflected);
    }
    return sum;
}

Formula EquationTerms::symbolOf(const Term& leaf, int k) const {
    using enum Quantity;
    const std::string index = std::to_string(k), light = "light." + index + ".", own = channel();
    switch (leaf.quantity) {
        case Emission: return sub("k", "e", "emission");
        case Ambient: return sub("k", "a", materialKey("ka" + own));
        case AmbientLight: return sub("I", "a", "ambient.intensity");
        case Diffuse: return sub("k", own, materialKey("k" + own));
        // Lecture 1 has one for all colours.
        case Specular: return sub("k", "s", materialKey(model().found.ownAmbient ? "ks" + own : "ks"));
        case Exponent: return symbol("n", materialKey("n"));
        case Shadow: return sub("S", index, "shadow." + index);
        case Fading: return sub("F", index);
        case Intensity: return sub("I", index, light + "intensity");
        case GlDiffuse: return sub("d", index, light + "intensity");
        case GlAmbient: return sub("a", index, light + "ambient_" + kColors[c]);
        case GlSpecular: return sub("s", index, light + "specular_" + kColors[c]);
        case NDotL: return dot(N(), L(k));
        case Mirror: return halfway() ? dot(N(), H(k)) : dot(R(k), V());
        case NDotV: return dot(N(), V());
        case NDotH: return dot(N(), H(k));
        case VDotH: return dot(V(), H(k));
        case LDotV: return dot(L(k), V());
        case Factor: return indexed(symbol(std::string(model().factors[std::size_t(leaf.number)].letter)), k);
        case Number: return text(shortest(leaf.number));
    }
    return {};
}

Formula EquationTerms::symbolsOf(const Term& term, int k) const {
    const auto part = [&](std::size_t i) { return symbolsOf(term.parts[i], k); };
    const auto closed = [&](std::size_t i) { return isSum(term.parts[i]) ? between("(", part(i), ")") : part(i); };
    switch (term.kind) {
        case TermForm::Leaf: return symbolOf(term, k);
        case TermForm::Sum: {
            std::vector<Formula> sum{part(0)};
            for (std::size_t i = 1; i < term.parts.size(); ++i) sum.push_back(text("+")), sum.push_back(part(i));
            return row(std::move(sum));
        }
        case TermForm::Difference: return row({part(0), text("−"), part(1)});
        case TermForm::Product: {
            std::vector<Formula> parts;
            appendSymbols(term.parts, k, parts);
            return row(std::move(parts));
        }
        case TermForm::Power: return power(closed(0), part(1));
        case TermForm::Fraction: return fraction(part(0), part(1));
        case TermForm::Root: return row({text("√("), part(0), text(")")});
        case TermForm::Largest: return row({text("max("), part(0), text(","), part(1), text(")")});
    }
    return {};
}

void EquationTerms::appendSymbols(Factors product, int k, std::vector<Formula>& parts) const {
    for (const Term& factor : product)
        parts.push_back(isSum(factor) ? between("(", symbolsOf(factor, k), ")") : symbolsOf(factor, k));
}

Formula EquationTerms::numberOf(const Term& leaf, const Evaluation& e, const LightReport* light) const {
    using enum Quantity;
    const double value = valueOf(leaf.quantity, leaf.number, e, light);
    const std::string k = light ? std::to_string(light->light) : std::string();
    switch (leaf.quantity) {
        case Shadow: {
            // Lit or not is no measure; a share of texels or samples is, with as many digits as the dot products.
            const bool isShare = value != 0 && value != 1;
            return isShare ? number(value, 4, "shadow." + k) : text(settingText(value), "shadow." + k);
        }
        case Fading:
        case NDotV:
        case VDotH:
        case LDotV:
        case Factor: return number(value, 4);
        case NDotL: return number(light->nDotL, 4, "n_dot_l." + k);
        case NDotH: return number(light->nDotH, 4, "n_dot_h." + k);
        case Mirror:
            return halfway() ? number(light->nDotH, 4, "n_dot_h." + k) : number(light->rDotV, 4, "r_dot_v." + k);
        case Exponent: return text(settingText(value), materialKey("n"));
        default: return text(settingText(value));
    }
}

Formula EquationTerms::numbersOf(const Term& term, const Evaluation& e, const LightReport* light) const {
    const auto part = [&](std::size_t i) { return numbersOf(term.parts[i], e, light); };
    const auto closed = [&](std::size_t i) { return isSum(term.parts[i]) ? between("(", part(i), ")") : part(i); };
    switch (term.kind) {
        case TermForm::Leaf: return numberOf(term, e, light);
        case TermForm::Sum: {
            std::vector<Formula> sum{part(0)};
            for (std::size_t i = 1; i < term.parts.size(); ++i) sum.push_back(text("+")), sum.push_back(part(i));
            return row(std::move(sum));
        }
        case TermForm::Difference: return row({part(0), text("−"), part(1)});
        case TermForm::Product: {
            std::vector<Formula> parts;
            appendNumbers(term.parts, e, light, parts);
            return row(std::move(parts));
        }
        case TermForm::Power: return power(closed(0), part(1));
        case TermForm::Fraction: return fraction(part(0), part(1));
        case TermForm::Root: return row({text("√("), part(0), text(")")});
        case TermForm::Largest: return row({text("max("), part(0), text(","), part(1), text(")")});
    }
    return {};
}

// What a clamp removes is struck.
void EquationTerms::appendNumbers(Factors product, const Evaluation& e, const LightReport* light,
                                  std::vector<Formula>& parts) const {
    NumberRow numbers(parts);
    for (const Term& factor : product) {
        const bool isCosine = factor.kind == TermForm::Leaf && factor.quantity == Quantity::NDotL;
        const bool isMirror = factor.kind == TermForm::Power && factor.parts[0].quantity == Quantity::Mirror;
        if (isCosine && !(light->nDotL > 0)) {
            numbers.addClamped(numberOf(factor, e, light));
        } else if (isMirror &&
                   !(light->nDotL > 0 && ((halfway() ? light->nDotH : light->rDotV) > 0 || light->specularPower > 0))) {
            numbers.addClamped(numberOf(factor.parts[0], e, light));
        } else {
            Formula own = numbersOf(factor, e, light);
            numbers.add(isSum(factor) ? between("(", std::move(own), ")") : std::move(own));
        }
    }
    numbers.finish();
}

void EquationTerms::symbols(std::vector<Formula>& parts) const {
    const LightFormula& formula = model().light;
    for (const Term& term : model().base) {
        if (&term != &model().base.front()) parts.push_back(text("+"));
        term.kind == TermForm::Product ? appendSymbols(term.parts, 0, parts) : parts.push_back(symbolsOf(term, 0));
    }
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
        const int k = int(light);
        const auto reflected = [&](const char* left, const char* right) {
            parts.push_back(text(left));
            appendSymbols(formula.diffuse, k, parts);
            if (!formula.diffuse.empty() && !formula.specular.empty()) parts.push_back(text("+"));
            appendSymbols(formula.specular, k, parts);
            parts.push_back(text(right));
        };
        parts.push_back(text("+"));
        appendSymbols(formula.before, k, parts);
        if (formula.ambient.empty()) {
            appendSymbols(formula.shadowed, k, parts);
            reflected("[", "]");
            continue;
        }
        parts.push_back(text("["));
        appendSymbols(formula.ambient, k, parts);
        parts.push_back(text("+"));
        appendSymbols(formula.shadowed, k, parts);
        reflected("(", ")");
        parts.push_back(text("]"));
    }
}

void EquationTerms::numbers(const Evaluation& e, std::vector<Formula>& parts) const {
    const LightFormula& formula = model().light;
    for (const Term& term : model().base) {
        if (&term != &model().base.front()) parts.push_back(text("+"));
        appendNumbers(term.kind == TermForm::Product ? term.parts : Factors(&term, 1), e, nullptr, parts);
    }
    for (const LightReport& light : e.lights) {
        const auto reflected = [&](const char* left, const char* right) {
            parts.push_back(text(left));
            appendNumbers(formula.diffuse, e, &light, parts);
            if (!formula.diffuse.empty() && !formula.specular.empty()) parts.push_back(text("+"));
            appendNumbers(formula.specular, e, &light, parts);
            parts.push_back(text(right));
        };
        parts.push_back(text("+"));
        appendNumbers(formula.before, e, &light, parts);
        if (formula.ambient.empty()) {
            appendNumbers(formula.shadowed, e, &light, parts);
            reflected("[", "]");
            continue;
        }
        parts.push_back(text("["));
        appendNumbers(formula.ambient, e, &light, parts);
        parts.push_back(text("+"));
        appendNumbers(formula.shadowed, e, &light, parts);
        reflected("(", ")");
        parts.push_back(text("]"));
    }
}

}  // namespace pipeline
