#pragma once
#include <QPolygonF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace app {

// What stands over a held picture beside its grips, in pixels of the canvas.
struct HeldMarks {
    struct Lead {
        // A number's track; to what a lamp goes around; to where a vertex was.
        enum class Kind { Track, Lamp, Before };
        Kind kind;
        QPointF from, to;
    };
    struct Vectors {
        QPointF at, N, L;  // where they begin and end
        std::optional<QPointF> H;
        bool isLit;  // L is above the horizon
        QPolygonF arc, horizon;
    };
    std::vector<Lead> leads;
    std::optional<QPointF> ring;  // around the picked pixel
    std::optional<Vectors> vectors;
    QString play, shows;  // the sentence at the top, the words at the bottom; may be empty
};

// Paints them in the dark theme's colours, as all that is on the black around a picture, and lets the mouse through.
class HoldMarks : public QWidget {
public:
    explicit HoldMarks(QWidget* canvas);
    void show(HeldMarks marks);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void line(QPainter& painter, QPointF a, QPointF b, const QColor& color, Qt::PenStyle style = Qt::SolidLine) const;
    void paintLead(QPainter& painter, const HeldMarks::Lead& lead) const;
    void paintVectors(QPainter& painter, const HeldMarks::Vectors& vectors) const;
    void paintLetter(QPainter& painter, QPointF from, QPointF to, const QString& name, const QColor& color) const;
    void paintWords(QPainter& painter) const;

    HeldMarks m_marks;
};

}  // namespace app
