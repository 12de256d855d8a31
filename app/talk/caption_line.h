#pragma once
#include <QWidget>

class QPainter;

namespace app {

// The bottom line of a presentation: the stage, a sentence, one dot per cue, and the last key.
class CaptionLine : public QWidget {
    Q_OBJECT
public:
    explicit CaptionLine(QWidget* parent) : QWidget(parent) {}

    void setText(const QString& stage, const QString& sentence);
    void setCues(int count, int current);  // current: -1 for none
    void setKey(const QString& key);
    const QString& sentence() const { return m_sentence; }
    const QString& key() const { return m_key; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintSentence(QPainter& painter, int room) const;

    QString m_stage, m_sentence, m_key;
    int m_count = 0, m_current = -1;
};

}  // namespace app
