#pragma once
#include <QTextBrowser>

namespace app {

// Markdown at its full height, in the theme's fonts: it grows with its text and leaves scrolling to
// what it stands in. A letter N, L, V, R or H in bold italics is that vector, in its colour; "I_b" and "n^2"
// outside code get a subscript and a superscript.
class ProseView : public QTextBrowser {
    Q_OBJECT
public:
    enum class Tone { Plain, Heading, Question, Right, NotYet };

    explicit ProseView(QWidget* parent = nullptr);

    void setProse(const QString& markdown, Tone tone = Tone::Plain);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void typeset();
    void markVectors();
    void raiseScripts();
    void fitHeight();

    QString m_markdown;
    Tone m_tone = Tone::Plain;
};

}  // namespace app
