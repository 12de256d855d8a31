#pragma once
#include <QAbstractButton>
#include <functional>

#include "app/frames/stage_status.h"
#include "pipeline/compare/verdict.h"

namespace app {

// One stage of the strip: number, name, and the state as mark, word and colour; time and error;
// counts. Where the stage is left out, the reason instead. A click goes to the stage.
class StageCard : public QAbstractButton {
    Q_OBJECT
public:
    explicit StageCard(pipeline::StageId stage, QWidget* parent = nullptr);

    pipeline::StageId stage() const { return m_stage; }
    const StageStatus& status() const { return m_status; }
    void setStatus(const StageStatus& status);
    // How another renderer's stage stands, in place of this program's state and numbers; nothing: these again.
    void setStanding(std::optional<pipeline::foreign::Standing> standing, const QString& finding = {});
    void setOnShow(bool onShow);
    bool isOnShow() const { return m_onShow; }
    void setCompact(bool compact);  // two lines, the state as its mark alone

    // What of its name and its state has room, and the name's width and room in pixels. The tool tip has both whole.
    struct Words {
        QString name, state;
        int nameWidth = 0, nameRoom = 0;
    };
    Words shownWords() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void entered();  // a double click: to the stage's end, with nothing after it

protected:
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void paintBox(QPainter& painter) const;
    double titleSize() const { return m_compact ? 13 : 14; }
    int titleWidth() const;
    // The first line: number and name, and at its right the mark, alone where the word has no room.
    struct Head {
        QRect line, title;
        bool isMarkBelow = false;  // large letters: the title has its line alone
        QString state;
    };
    Head head() const;
    QFont titleFont(int room) const;
    static int numberWidth(const QFont& title);
    QString titleIn(int room, const QFont& font) const;
    void paintState(QPainter& painter, const Head& head) const;
    void paintStanding(QPainter& painter, const Head& head) const;
    void paintFinding(QPainter& painter, const QRect& line) const;
    void paintTitle(QPainter& painter, QRect line) const;
    void paintNumbers(QPainter& painter, const QRect& line) const;

    pipeline::StageId m_stage;
    StageStatus m_status;
    std::optional<pipeline::foreign::Standing> m_standing;
    QString m_finding;
    bool m_onShow = false, m_compact = false;
};

// ● ran, ○ reused, – left out, ◐ in progress, · not yet: in the state's colour, 10 by 10 at scale 1.
void paintMark(QPainter& painter, QPointF centre, StageState state);
QColor stateColor(StageState state);

// A text, or its beginning up to a sign where it can end; nothing where that does not fit either.
QString fitting(QString text, const std::function<bool(const QString&)>& fits);

// Counts with their numbers from 10 000 on in three digits: "498k of 1.00M polygons kept".
QString withShortNumbers(QString text);
// A card's counts: exact, or their beginning; where no part of them fits, in three digits, the tool tip having all.
QString fittingCounts(const QString& counts, const std::function<bool(const QString&)>& fits);
// The same of an error: its first part, then the number alone, whether or not that fits.
QString fittingError(QString error, const std::function<bool(const QString&)>& fits);

}  // namespace app
