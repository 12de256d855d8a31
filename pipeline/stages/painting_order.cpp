// Newell, Newell and Sancha's order.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "pipeline/stages/painting_piece.h"

namespace pipeline {
namespace {

using namespace painting;

constexpr std::size_t kPollEvery = 1024;  // comparisons: far below a millisecond

class Newell {
public:
    Newell(std::span<const PaintTriangle> triangles, const Stop& stop, std::size_t maxComparisons, PaintingOrder& out)
        : m_triangles(triangles), m_stop(stop), m_maxComparisons(maxComparisons), m_out(out) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const auto& c = triangles[i].snapped.corners;
            add({{i, {}}, {glm::dvec2(c[0]), glm::dvec2(c[1]), glm::dvec2(c[2])}, {}, {}, 0, 0});
        }
        m_limit = kMaxPiecesPerTriangle * triangles.size() + kMaxExtraPieces;
    }

    void run() {
        while (!m_stack.empty() || !m_rest.empty()) {
            if (m_stack.empty()) push(m_rest.begin()->second);
            const std::uint32_t p = m_stack.back();
            const Conflict conflict = firstConflict(p);
            if (m_ended) break;
            if (conflict.relation == Relation::Free || !resolve(p, conflict)) {
                m_out.unordered += conflict.relation != Relation::Free;
                m_out.pieces.push_back(m_pieces[p].piece);
                m_stack.pop_back();
            }
        }
        // At the limit, where there is something left: those that wait, the last first, then by their farthest points.
        m_out.unordered += m_stack.size() + m_rest.size();
        for (auto p = m_stack.rbegin(); p != m_stack.rend(); ++p) m_out.pieces.push_back(m_pieces[*p].piece);
        for (const auto& [farthest, p] : m_rest) m_out.pieces.push_back(m_pieces[p].piece);
    }

private:
    struct Conflict {
        Relation relation = Relation::Free;
        std::uint32_t with = 0;
    };

    void add(Piece piece) {
        const DepthPlane& plane = m_out.planes[piece.piece.triangle];
        piece.low = piece.high = piece.outline[0];
        piece.nearest = piece.farthest = plane.at(piece.outline[0]);
        for (const glm::dvec2& p : piece.outline) {
            piece.low = glm::min(piece.low, p), piece.high = glm::max(piece.high, p);
            piece.nearest = std::min(piece.nearest, plane.at(p) - plane.error(p));
            piece.farthest = std::max(piece.farthest, plane.at(p) + plane.error(p));
        }
        m_pieces.push_back(std::move(piece));
        await(std::uint32_t(m_pieces.size() - 1));
    }
    void await(std::uint32_t p) {
        m_pieces[p].waits = false;
        m_rest.insert({-m_pieces[p].farthest, p});
    }
    void push(std::uint32_t p) {
        m_rest.erase({-m_pieces[p].farthest, p});
        m_pieces[p].waits = true;
        m_stack.push_back(p);
    }

    // How far triangle a is behind triangle b at p: 1, -1, or 0 where rounding does not let one tell.
    int behind(std::uint32_t a, std::uint32_t b, glm::dvec2 p) const {
        const DepthPlane &planeA = m_out.planes[a], &planeB = m_out.planes[b];
        const double difference = planeA.at(p) - planeB.at(p), error = planeA.errorNear(p) + planeB.errorNear(p);
        return difference > error ? 1 : difference < -error ? -1 : 0;
    }
    Relation over(std::uint32_t a, std::uint32_t b, const std::vector<glm::dvec2>& outline) const {
        bool back = false, front = false;
        for (const glm::dvec2& p : outline) {
            const int side = behind(a, b, p);
            back |= side > 0, front |= side < 0;
        }
        return back && front ? Relation::Mixed : back ? Relation::Behind : front ? Relation::InFront : Relation::Free;
    }
    Relation relation(const Piece& p, const Piece& q) {
        const std::uint32_t a = p.piece.triangle, b = q.piece.triangle;
        if (a == b || p.low.x >= q.high.x || q.low.x >= p.high.x || p.low.y >= q.high.y || q.low.y >= p.high.y)
            return Relation::Free;
        if (p.nearest >= q.farthest) return Relation::Behind;
        const SnappedTriangle &s = m_triangles[a].snapped, &t = m_triangles[b].snapped;
        if (separated(s, t) || separated(t, s)) return Relation::Free;
        const std::vector<glm::dvec2> common = commonOutline(p.outline, q.outline);
        if (!hasArea(common)) return Relation::Free;
        return q.nearest >= p.farthest ? Relation::InFront : over(a, b, common);
    }

    // To be asked before each pair: whether it may be compared. Where not, none is any more.
    bool mayCompare() {
        m_ended = m_ended || m_out.compared == m_maxComparisons ||
                  (m_out.compared % kPollEvery == 0 && m_stop.stop_requested());
        m_out.compared += !m_ended;
        return !m_ended;
    }

    // Something that p must not be painted before.
    Conflict firstConflict(std::uint32_t p) {
        const auto conflicts = [&](std::uint32_t q) {
            if (!mayCompare()) return Relation::Free;
            const Relation r = relation(m_pieces[p], m_pieces[q]);
            return r == Relation::Behind ? Relation::Free : r;
        };
        for (const std::uint32_t q : m_stack)
            if (q != p)
                if (const Relation r = conflicts(q); r != Relation::Free || m_ended) return {r, q};
        for (const auto& [farthest, q] : m_rest) {
            if (-farthest <= m_pieces[p].nearest) break;
            if (const Relation r = conflicts(q); r != Relation::Free || m_ended) return {r, q};
        }
        return {};
    }

    // Splits p, which stands in the stack no more afterwards, by the plane of triangle b.
    bool split(std::uint32_t p, std::uint32_t b) {
        const Piece& whole = m_pieces[p];
        const std::uint32_t a = whole.piece.triangle;
        if (a == b || m_pieces.size() + 2 > m_limit || over(a, b, whole.outline) != Relation::Mixed) return false;
        if (std::ranges::any_of(whole.piece.cuts, [&](const PaintPiece::Cut& cut) { return cut.by == b; }))
            return false;
        const auto difference = [&](glm::dvec2 x) { return m_out.planes[a].at(x) - m_out.planes[b].at(x); };
        Piece back = whole, front = whole;
        back.outline = cutOutline(whole.outline, difference);
        front.outline = cutOutline(whole.outline, [&](glm::dvec2 x) { return -difference(x); });
        if (back.outline.size() < 3 || front.outline.size() < 3) return false;
        back.piece.cuts.push_back({b, true});
        front.piece.cuts.push_back({b, false});
        std::erase(m_stack, p);
        add(std::move(back));
        add(std::move(front));
        ++m_out.splits;
        return true;
    }

    bool resolve(std::uint32_t p, const Conflict& conflict) {
        const std::uint32_t q = conflict.with;
        if (conflict.relation == Relation::Mixed) return split(p, m_pieces[q].piece.triangle);
        if (!m_pieces[q].waits) {
            push(q);
            return true;
        }
        // From q upwards each waits for the next, and p for q. Of three some member crosses another's plane, for else the
        // planes would order them; a larger cycle without that was never seen, and counts as unordered.
        const auto first = std::ranges::find(m_stack, q) - m_stack.begin();
        const std::vector<std::uint32_t> cycle(m_stack.begin() + first, m_stack.end());
        for (auto one = cycle.rbegin(); one != cycle.rend(); ++one)
            for (const std::uint32_t other : cycle) {
                if (!mayCompare()) return false;
                if (!split(*one, m_pieces[other].piece.triangle)) continue;
                for (const std::uint32_t member : cycle)
                    if (member != *one) await(member);
                m_stack.resize(std::size_t(first));
                return true;
            }
        return false;
    }

    std::span<const PaintTriangle> m_triangles;
    const Stop& m_stop;
    std::size_t m_maxComparisons;
    PaintingOrder& m_out;
    std::vector<Piece> m_pieces;
    std::set<std::pair<double, std::uint32_t>> m_rest;  // the farthest first
    std::vector<std::uint32_t> m_stack;                 // each but the last waits for the next
    std::size_t m_limit = 0;
    bool m_ended = false;
};

}  // namespace

PaintingOrder paintingOrder(std::span<const PaintTriangle> triangles, bool split, const Stop& stop,
                            std::size_t maxComparisons) {
    PaintingOrder out;
    for (const PaintTriangle& t : triangles) out.planes.push_back(planeOf(t));
    if (split) {
        Newell(triangles, stop, maxComparisons, out).run();
        return out;
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) out.pieces.push_back({i, {}});
    std::ranges::stable_sort(out.pieces, [&](const PaintPiece& a, const PaintPiece& b) {
        const PaintTriangle &s = triangles[a.triangle], &t = triangles[b.triangle];
        return s.mean != t.mean ? s.mean > t.mean : s.polygon < t.polygon;
    });
    return out;
}

}  // namespace pipeline
