#pragma once
#include <vector>

#include "app/buffer_view/buffer_feature.h"
#include "app/buffer_view/hold_places.h"

class QPushButton;

namespace app {

class Hand;
class HeldBand;
class HeldFiles;

// What a page of a lesson lets the user hold, over the picture: grips of its holds and of a spot on a row, and what
// stands beside them. An object is also moved by its surface, the eye by the rest of the
// picture, a spot by all of it.
class BufferHolds : public BufferFeature {
    Q_OBJECT
public:
    explicit BufferHolds(BufferView& view);

    // Of the views on show only the first has grips.
    void setOn(bool on);
    // As a page of a lesson has it whose picture is held: on black, without the header.
    void setHeld(bool held);
    bool isHeld() const { return m_isHeld; }
    HeldFiles& files() const { return *m_files; }  // to stand beside the canvas
    HeldBand& band() const { return *m_band; }     // to stand below it

    pipeline::BufferSet want() override;
    void show() override;
    void place(CanvasRoom& room) override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    // Pixels of the grip's room: where it began, where the pointer is, and where what it holds is; Shift moves by a tenth.
    struct Drag {
        std::size_t grip;  // its place in m_grips
        QPointF pressed, last, at;
        std::optional<glm::ivec2> pixelBefore;
    };

    bool areShown() const;
    std::optional<std::size_t> gripAt(QPointF canvas) const;  // by the surface of its object, or as the eye
    void make();
    void add(HeldGrip::What what, std::size_t hold, const QString& name, HoldGrip::Look look);
    void fit();
    void placeGrips();
    void placeInside();
    void begin(std::size_t grip, QPointF at);
    void moveTo(QPointF at, Qt::KeyboardModifiers modifiers);
    void end();
    void cancel();
    void nudge(const HeldGrip& grip, QPoint by, bool isCoarse);
    void restore(const HeldGrip& grip);
    void click(QPointF at);
    void pickOnRow(int column);

    Hand& m_hand;
    HoldMarks* m_layer;
    HeldFiles* m_files;
    HeldBand* m_band;
    HoldPlaces m_places;
    QPushButton* m_inside;
    std::vector<HeldGrip> m_grips;
    int m_tracks = 0;
    bool m_isOn = false, m_isHeld = false, m_fits = false;
    std::optional<Drag> m_drag;
};

}  // namespace app
