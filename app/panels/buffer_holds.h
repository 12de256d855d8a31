#pragma once
#include <vector>

#include "app/panels/buffer_feature.h"
#include "pipeline/inspect/picture_vectors.h"

class QPainter;

namespace app {

class Hand;
class HeldFiles;
class HoldGrip;

// What a page of a lesson lets the user hold, over the picture: grips, the play, and what leads to a lamp or shows where a
// vertex was. An object is also moved by its surface, the eye by the rest of the picture.
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

    pipeline::BufferSet want() override;
    void show() override;
    void place(CanvasRoom& room) override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    class Layer;

    bool areShown() const;
    QLineF trackOf(std::size_t hold) const;  // of a number, from low to high; on the canvas
    QPointF onCanvas(glm::dvec2 picture) const;
    glm::dvec2 forHand(std::size_t hold, QPointF canvas) const;
    std::optional<std::size_t> holdAt(QPointF canvas) const;  // by the surface of its object, or as the eye
    bool showsVectors() const;
    void make();
    void fit();
    void placeGrips();
    void begin(std::size_t hold, QPointF at);
    void moveTo(QPointF at, Qt::KeyboardModifiers modifiers);
    void end();
    void click(QPointF at);
    void paint(QPainter& painter) const;
    void paintPlay(QPainter& painter) const;

    Hand& m_hand;
    Layer* m_layer;
    HeldFiles* m_files;
    std::vector<HoldGrip*> m_grips;
    bool m_isOn = false, m_isHeld = false, m_fits = false;
    std::optional<std::size_t> m_dragged;
    // Of a drag, on the canvas: where it began, where the pointer is, and where what it holds is; Shift moves by a tenth.
    QPointF m_pressed, m_last, m_at;
    std::optional<pipeline::PictureVectors> m_vectors;
};

}  // namespace app
