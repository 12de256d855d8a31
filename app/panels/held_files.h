#pragma once
#include <QTextBrowser>

namespace app {

class Hand;

// Beside the picture: the text files that the scene would be, of which one line follows the vertex in the hand.
class HeldFiles : public QTextBrowser {
    Q_OBJECT
public:
    HeldFiles(Hand& hand, const class Document& document, QWidget* parent);

    // Whether the view beside it is the one that has the grips.
    void setOn(bool on);

private:
    void showFiles();

    Hand& m_hand;
    const Document& m_document;
    bool m_isOn = false;
};

}  // namespace app
