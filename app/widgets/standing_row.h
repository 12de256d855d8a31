#pragma once
#include <QAbstractButton>

#include "pipeline/compare/verdict.h"

class QPainter;

namespace app {

// ✓ ring, ✗ filled square, ↯ flash, – line, ? dashed ring: each told by its shape alone.
void paintStanding(QPainter& painter, const QRectF& box, pipeline::foreign::Standing standing);
QColor standingColor(pipeline::foreign::Standing standing);

// A stage of somebody else's renderer: its number, its name, how it stands, and a line of what was found. A click shows it.
class StandingRow : public QAbstractButton {
    Q_OBJECT
public:
    explicit StandingRow(pipeline::StageId stage, QWidget* parent = nullptr);

    pipeline::StageId stage() const { return m_stage; }
    pipeline::foreign::Standing standing() const { return m_standing; }
    // line: below the name; may be empty. isFirst: the first wrong stage.
    void show(pipeline::foreign::Standing standing, const QString& line, bool isFirst);
    void setOnShow(bool onShow);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    pipeline::StageId m_stage;
    pipeline::foreign::Standing m_standing = pipeline::foreign::Standing::NoFile;
    QString m_line;
    bool m_isFirst = false, m_onShow = false;
};

// The mark alone, as large as a heading.
class StandingMark : public QWidget {
    Q_OBJECT
public:
    explicit StandingMark(QWidget* parent = nullptr);
    void show(pipeline::foreign::Standing standing);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    pipeline::foreign::Standing m_standing = pipeline::foreign::Standing::NoFile;
};

}  // namespace app
