#pragma once
#include <QWidget>

class QLabel;

namespace app {

class Document;
class MathView;

// The equation of the picked pixel, with its value in the frame buffer and its colour.
class TalkEquation : public QWidget {
    Q_OBJECT
public:
    TalkEquation(Document& document, QWidget* parent);

    // Whether the talk has room for it. Without a picked pixel that a polygon covers it stays hidden.
    void setWanted(bool wanted);

private:
    void showPixel();

    Document& m_document;
    MathView* m_math;
    QLabel *m_value, *m_swatch;
    bool m_isWanted = true;
};

}  // namespace app
