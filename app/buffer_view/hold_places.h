#pragma once
#include <QLineF>
#include <optional>
#include <vector>

#include "app/holds/hold_grip.h"
#include "app/holds/hold_marks.h"
#include "pipeline/inspect/picture_vectors.h"

namespace app {

class BufferView;
class Hand;
class HeldBand;

// A grip, and what it moves: a hold of the hand, by its number, or the spot on a row.
struct HeldGrip {
    enum class What { Hold, Spot };
    What what;
    std::size_t hold;
    HoldGrip* button;
    int track;  // of a number: how many tracks are to its left
};

// Where the grips of a held picture are, in the canvas or in the figure below it, and what stands beside them.
class HoldPlaces {
public:
    HoldPlaces(BufferView& view, HeldBand& band);

    QPointF onCanvas(glm::dvec2 picture) const;
    QPointF inPicture(QPointF canvas) const;
    glm::dvec2 forHand(const HeldGrip& grip, QPointF at) const;  // as Hand::begin() takes it
    HoldGrip::Place placeOf(const HeldGrip& grip) const;
    void follow(bool isShown);  // another picture is on show
    HeldMarks marks(const std::vector<HeldGrip>& grips, bool hasRing) const;

private:
    bool isOnBand(const HeldGrip& grip) const;
    QLineF trackOf(const HeldGrip& grip) const;  // from low to high
    bool hides(pipeline::BufferId id) const;
    HoldGrip::Place placeOfHold(const HeldGrip& grip) const;

    BufferView& m_view;
    Hand& m_hand;
    HeldBand& m_band;
    std::optional<pipeline::PictureVectors> m_vectors;
};

}  // namespace app
