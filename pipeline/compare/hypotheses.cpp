#include "pipeline/compare/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "pipeline/compare/measured_errors.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline::foreign {

namespace {

constexpr double kPixels = 320 * 240;  // of the picture that hypotheses are ranked in
constexpr std::size_t kConfirmed = 8;  // in the picture's own size
constexpr double kExplains = 0.9;      // of what is wrong with the right frame, at least
constexpr double kLeftOfDrawn = 0.15;  // of the pixels drawn, at most: who draws nothing explains little
constexpr double kTwin = 10,
                 kTwinShare = 0.05;  // as good: so many elements more, or such a share of those wrong

// Two errors at once fit more by accident than one: they have to explain nearly all, and neither may do so alone.
constexpr double kPixelsOfTwo = 160 * 120;  // of the picture that they are ranked in
constexpr std::size_t kFirsts = 3;          // errors that a second one is tried with
constexpr double kPart = 0.05;              // of what is wrong: what one of these explains, at least
constexpr double kTwoExplain = 0.97, kTwoLeaveOfDrawn = 0.03;
constexpr double kRest = 0.01;     // of the pixels drawn: what one error leaves for a second one to explain, at least
constexpr double kMatters = 0.25;  // of what each leaves alone: what both leave, at most

Scene smaller(Scene scene, std::size_t factor) {
    scene.settings.width = std::max(1, scene.settings.width / int(factor));
    scene.settings.height = std::max(1, scene.settings.height / int(factor));
    scene.camera.pixelsPerUnit /= double(factor);
    scene.settings.shadowSize = std::min(scene.settings.shadowSize, 512);
    return scene;
}

// Whether a scene with two errors can be drawn. A second defect is beyond what the text of a scene may state.
bool isValid(Scene scene) {
    scene.settings.defectWay = 0;
    return checkScene(scene).empty();
}

// The frames of a scene with errors beside the files, in one size.
class Court {
public:
    Court(const Reference& right, const Conventions& conventions, const StatedConventions& stated, std::size_t factor)
        : m_right(right),
          m_evidence(conventions, stated, right, factor),
          m_factor(factor),
          m_corner(factor == 1 ? right.corner : PixelCorner::None),  // in a smaller picture that
                                                                     // is a part of a pixel
          m_first(factor == 1 ? right.frame : nullptr) {}

    // Nothing where it was stopped. The first scene is the right one: what its
    // frame has in common with others serves.
    std::optional<Misfit> of(const Scene& scene, const Stop& stop) {
        const Scene sized = m_factor == 1 ? scene : smaller(scene, m_factor);
        auto made = makeHypothesis(sized, m_right, m_evidence.compared(), m_corner, m_first, stop);
        if (!made) return {};
        if (!m_first) m_first = made->frame;
        made->isSmaller = m_factor > 1;
        return m_evidence.misfit(*made);
    }

private:
    const Reference& m_right;
    FolderEvidence m_evidence;
    std::size_t m_factor;
    PixelCorner m_corner;
    FramePtr m_first;
};

// All known errors of a scene and what each leaves of each file, measured once.
class Trial {
public:
    Trial(const Scene& scene, std::vector<KnownError> errors, const Reference& reference,
          const Conventions& conventions, const StatedConventions& stated)
        : m_scene(scene),
          m_reference(reference),
          m_conventions(conventions),
          m_stated(stated),
          m_errors(std::move(errors)),
          m_factor(factorOf(scene, kPixels)),
          m_full(reference, conventions, stated, 1) {
        if (m_factor > 1) m_small.emplace(reference, conventions, stated, m_factor);
    }

    // The errors whose numbers leave `part`, divided by `parts`. False where it was stopped.
    bool measure(std::size_t part, std::size_t parts, const Stop& stop, const HypothesisProgress& progress,
                 const MeasuredErrors& given = {}) {
        auto right = m_full.of(m_scene, stop);
        if (!right || (m_small && !m_small->of(m_scene, stop))) return false;
        m_right = std::move(*right);
        m_misfits.resize(m_errors.size());
        for (std::size_t i = part; i < m_errors.size(); i += parts) {
            if (progress) progress(i, m_errors.size());
            if (const auto known = given.find(i); known != given.end()) {
                m_misfits[i] = known->second;
                continue;
            }
            auto misfit = (m_small ? *m_small : m_full).of(m_errors[i].plant(m_scene), stop);
            if (!misfit) return false;
            m_misfits[i] = left(m_errors[i], std::move(*misfit));
            if (m_factor > 1)
                for (double& wrong : m_misfits[i].wrong) wrong *= double(m_factor * m_factor);
        }
        m_small.reset();  // with its files and its first frame: what follows is drawn in the picture's own size
        return true;
    }
    const Misfit& misfit(std::size_t i) const { return m_misfits[i]; }
    std::size_t tried() const { return m_errors.size(); }
    const KnownError* find(const std::string& id) const {
        const auto found = std::ranges::find(m_errors, id, &KnownError::id);
        return found == m_errors.end() ? nullptr : &*found;
    }
    const Misfit& right() const { return m_right; }

    // What explains these files.
    Suspects judge(const std::vector<std::size_t>& files, const Stop& stop) {
        Suspects out;
        out.tried = m_errors.size(), out.right = m_right.sum(files);
        std::vector<std::size_t> ranked = ranking(files);
        if (m_factor > 1) {
            ranked.resize(std::min(ranked.size(), kConfirmed));
            for (const std::size_t i : ranked)
                if (!confirm(i, stop)) return out.stopped = true, out;
        }
        std::vector<Candidate> best;
        for (const std::size_t i : ranked) best.push_back(candidate(i, files, out.right));
        // Of those that are as good the rows of the right frame are the likelier.
        std::ranges::stable_sort(best, {}, [](const Candidate& one) { return std::tuple(one.left, one.otherRows); });
        std::vector<Candidate> ofEach;  // the best way of each error stands for it
        for (Candidate& one : best)
            if (std::ranges::none_of(ofEach, [&](const Candidate& other) { return other.error.id == one.error.id; }))
                ofEach.push_back(std::move(one));
        if (ofEach.empty()) return out;
        const double least = ofEach[0].left, drawn = double(std::max<std::size_t>(1, ofEach[0].misfit.drawn));
        const bool explains = ofEach[0].explained >= kExplains && least <= kLeftOfDrawn * drawn;
        const double asGood = least + std::max(kTwin, kTwinShare * std::min(out.right, drawn));
        for (Candidate& one : ofEach) {
            if (explains && one.left <= asGood && one.explained > 0.5)
                out.candidates.push_back(std::move(one));
            else if (!out.next)
                out.next = std::move(one);
        }
        if (!out.candidates.empty()) out.files = files;
        if (out.candidates.size() > 1) out.experiment = experimentBetween(out.candidates, m_scene, m_reference, stop);
        return out;
    }

    // Which two at once explain these files: one pair, or none if several do. firsts: errors that explain a part of them;
    // none: the best.
    Suspects judgeTwo(const std::vector<std::size_t>& files, const std::vector<Candidate>& firsts, const Stop& stop) {
        Suspects out;
        out.tried = m_errors.size(), out.right = m_right.sum(files);
        std::vector<Two> pairs;
        if (!rankTwo(files, firsts, stop, pairs)) return out.stopped = true, out;
        pairs.resize(std::min(pairs.size(), kConfirmed));
        for (Two& pair : pairs) {
            auto misfit = m_full.of(m_errors[pair.second].plant(m_errors[pair.first].plant(m_scene)), stop);
            if (!misfit || !confirm(pair.first, stop) || !confirm(pair.second, stop)) return out.stopped = true, out;
            pair.misfit = left(m_errors[pair.second], left(m_errors[pair.first], std::move(*misfit)));
        }
        const auto leaves = [&](const Two& pair) { return pair.misfit.sum(files); };
        std::ranges::stable_sort(pairs, {}, leaves);
        if (pairs.empty()) return out;
        const Two& best = pairs[0];
        const double least = leaves(best), drawn = double(std::max<std::size_t>(1, best.misfit.drawn));
        const double alone = std::min(m_misfits[best.first].sum(files), m_misfits[best.second].sum(files));
        if (least > (1 - kTwoExplain) * out.right || least > kTwoLeaveOfDrawn * drawn || least > kMatters * alone)
            return out;
        const double asGood = least + std::max(kTwin, kTwinShare * std::min(out.right, drawn));
        const std::set<std::string> named = idsOf(best);
        if (std::ranges::any_of(pairs, [&](const Two& pair) { return leaves(pair) <= asGood && idsOf(pair) != named; }))
            return out;
        for (const std::size_t i : {best.first, best.second}) {
            out.candidates.push_back({m_errors[i], best.misfit});
            out.candidates.back().left = least, out.candidates.back().explained = 1 - least / out.right;
        }
        std::ranges::stable_sort(out.candidates, {}, [](const Candidate& one) { return one.error.stage; });
        out.areTogether = true, out.files = files;
        return out;
    }

private:
    struct Two {
        std::size_t first, second;  // of the known errors
        Misfit misfit;
    };
    std::set<std::string> idsOf(const Two& pair) const { return {m_errors[pair.first].id, m_errors[pair.second].id}; }

    // The errors, those first that leave the least of these files.
    std::vector<std::size_t> ranking(const std::vector<std::size_t>& files) const {
        std::vector<std::size_t> ranked(m_errors.size());
        for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i] = i;
        std::ranges::stable_sort(ranked, {}, [&](std::size_t i) { return m_misfits[i].sum(files); });
        return ranked;
    }
    // The errors, the best way of each, that a second one is tried with.
    std::vector<std::size_t> firstsOf(const std::vector<std::size_t>& files,
                                      const std::vector<Candidate>& firsts) const {
        std::vector<std::size_t> out;
        for (const std::size_t i : ranking(files)) {
            const std::string& id = m_errors[i].id;
            const bool isTaken = std::ranges::any_of(out, [&](std::size_t j) { return m_errors[j].id == id; });
            const bool isAsked = std::ranges::any_of(firsts, [&](const Candidate& one) { return one.error.id == id; });
            const bool isPart = m_misfits[i].sum(files) <= (1 - kPart) * m_right.sum(files);
            if (!isTaken && (firsts.empty() ? isPart : isAsked) && out.size() < kFirsts) out.push_back(i);
        }
        return out;
    }
    // False where it was stopped.
    bool rankTwo(const std::vector<std::size_t>& files, const std::vector<Candidate>& firsts, const Stop& stop,
                 std::vector<Two>& pairs) const {
        Court coarse(m_reference, m_conventions, m_stated, factorOf(m_scene, kPixelsOfTwo));
        if (!coarse.of(m_scene, stop)) return false;
        for (const std::size_t first : firstsOf(files, firsts)) {
            const Scene one = m_errors[first].plant(m_scene);
            for (std::size_t second = 0; second < m_errors.size(); ++second) {
                if (m_errors[second].id == m_errors[first].id) continue;
                const Scene two = m_errors[second].plant(one);
                if (two == one || !isValid(two)) continue;
                auto misfit = coarse.of(two, stop);
                if (!misfit) return false;
                pairs.push_back({first, second, std::move(*misfit)});
            }
        }
        std::ranges::stable_sort(pairs, {}, [&](const Two& pair) { return pair.misfit.sum(files); });
        return true;
    }
    static std::size_t factorOf(const Scene& scene, double most) {
        const double pixels = double(scene.settings.width) * scene.settings.height;
        return std::max<std::size_t>(1, std::size_t(std::sqrt(pixels / most) + 0.01));
    }
    bool confirm(std::size_t i, const Stop& stop) {
        if (m_factor == 1 || m_isConfirmed[i]) return true;
        auto misfit = m_full.of(m_errors[i].plant(m_scene), stop);
        if (!misfit) return false;
        m_misfits[i] = left(m_errors[i], std::move(*misfit));
        return m_isConfirmed[i] = true;
    }
    // With what the right frame leaves where the error leaves a buffer right.
    Misfit left(const KnownError& error, Misfit misfit) const {
        for (std::size_t i = 0; i < misfit.wrong.size(); ++i)
            if (std::ranges::find(error.leaves, m_conventions.files[i].file->name.buffer.id) != error.leaves.end())
                misfit.wrong[i] = m_right.wrong[i], misfit.readings[i] = m_right.readings[i];
        return misfit;
    }
    Candidate candidate(std::size_t i, const std::vector<std::size_t>& files, double right) const {
        Candidate one{m_errors[i], m_misfits[i]};
        one.left = one.misfit.sum(files);
        one.explained = right > 0 ? 1 - one.left / right : 0;
        one.otherRows = one.misfit.geometry.bottomUp != m_right.geometry.bottomUp;
        return one;
    }

    const Scene& m_scene;
    const Reference& m_reference;
    const Conventions& m_conventions;
    const StatedConventions& m_stated;
    std::vector<KnownError> m_errors;
    std::size_t m_factor;
    Court m_full;
    std::optional<Court> m_small;
    Misfit m_right;
    std::vector<Misfit> m_misfits;  // of each error
    std::map<std::size_t, bool> m_isConfirmed;
};

// Which files have to fit where a stage is known to be wrong first: what comes
// before, and its own that differs. What follows depends on more of their
// program.
std::vector<std::vector<std::size_t>> focusOn(const std::vector<Finding>& findings, StageId wrong,
                                              const std::vector<std::size_t>& wrongHere) {
    std::vector<std::vector<std::size_t>> out;
    for (const std::size_t i : wrongHere) {
        if (findings[i].stage != wrong) continue;
        std::vector<std::size_t> files;
        for (std::size_t before = 0; before < i; ++before)
            if (findings[before].stage < wrong || findings[before].agrees) files.push_back(before);
        files.push_back(i);
        out.push_back(std::move(files));
        if (wrong == StageId::Shading) break;  // its terms follow from each other
    }
    return out;
}

// What the picture tells of S by itself, where no frame explains the files:
// shadow buffers differ in frame, resolution and bias, so that the pattern of a
// wrong one is everybody's own.
void askTheShadow(const Trial& trial, const Reference& reference, const Conventions& conventions,
                  const std::vector<Finding>& findings, Suspects& out) {
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (findings[i].stage < StageId::Shading && !findings[i].agrees) return;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (findings[i].name.buffer.id != BufferId::Color || findings[i].agrees) continue;
        const ShadowAlone found = shadowAlone(findings[i], conventions.files[i].mine, reference);
        for (const std::string& id : found.ids)
            if (const KnownError* const error = trial.find(id)) {
                Candidate one{*error, trial.right()};
                one.explained = found.explained, one.left = (1 - found.explained) * out.right;
                out.candidates.push_back(std::move(one));
            }
        if (!out.candidates.empty()) out.kind = found.kind, out.next.reset(), out.files = {i};
    }
}

// What explains the first wrong file and leaves those before as they are; or the picture alone, as files may be written
// before the error is made, or after.
Suspects judgeInParts(Trial& trial, const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop) {
    if (first.certain)
        for (const std::vector<std::size_t>& files : focusOn(findings, *first.certain, first.wrongHere)) {
            Suspects focused = trial.judge(files, stop);
            if (!focused.candidates.empty() || focused.stopped) return focused;
        }
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (findings[i].name.buffer.id != BufferId::Color || findings[i].agrees) continue;
        Suspects focused = trial.judge({i}, stop);
        if (focused.stopped) return focused;
        std::erase_if(focused.candidates, [&](const Candidate& c) {
            return std::ranges::find(first.possible, c.error.stage) == first.possible.end();
        });
        if (focused.candidates.size() != 1) continue;
        return focused.experiment.reset(), focused;
    }
    return {};
}

// Whether one error explains the files, and leaves a rest that a second one may explain.
bool leavesRest(const Suspects& suspects) {
    if (suspects.candidates.size() != 1) return false;
    const Candidate& one = suspects.candidates[0];
    return one.left > kRest * double(one.misfit.drawn);
}

}  // namespace

Suspects findSuspects(const Scene& scene, std::vector<KnownError> errors, const Reference& reference,
                      const Conventions& conventions, const StatedConventions& stated,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress) {
    return findSuspects(scene, std::move(errors), reference, conventions, stated, findings, first, stop, progress, {});
}

std::optional<MeasuredErrors> measureErrors(const Scene& scene, std::vector<KnownError> errors,
                                            const Reference& reference, const Conventions& conventions,
                                            const StatedConventions& stated, std::size_t part, std::size_t parts,
                                            const Stop& stop, const HypothesisProgress& progress) {
    Trial trial(scene, std::move(errors), reference, conventions, stated);
    if (!trial.measure(part, parts, stop, progress)) return {};
    MeasuredErrors measured;
    for (std::size_t i = part; i < trial.tried(); i += parts) measured[i] = trial.misfit(i);
    return measured;
}

Suspects findSuspects(const Scene& scene, std::vector<KnownError> errors, const Reference& reference,
                      const Conventions& conventions, const StatedConventions& stated,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress, const MeasuredErrors& given) {
    Trial trial(scene, std::move(errors), reference, conventions, stated);
    Suspects stopped;
    stopped.stopped = true;
    if (!trial.measure(0, 1, stop, progress, given)) return stopped;
    std::vector<std::size_t> all(findings.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const auto isDecided = [](const Suspects& suspects) { return !suspects.candidates.empty() || suspects.stopped; };
    Suspects out = trial.judge(all, stop);
    if (isDecided(out)) {
        if (!leavesRest(out)) return out;
        Suspects two = trial.judgeTwo(all, out.candidates, stop);
        return isDecided(two) ? two : out;
    }
    askTheShadow(trial, reference, conventions, findings, out);
    if (isDecided(out)) return out;
    Suspects inParts;
    if (!first.possible.empty()) inParts = judgeInParts(trial, findings, first, stop);
    if (inParts.stopped) return inParts;
    Suspects two = trial.judgeTwo(all, inParts.candidates, stop);
    if (isDecided(two)) return two;
    return inParts.candidates.empty() ? out : inParts;
}

}  // namespace pipeline::foreign
