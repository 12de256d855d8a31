#pragma once
#include <QTextBrowser>
#include <vector>

#include "lessons/held.h"

namespace app {

class Hand;

// Beside the picture: the text files that the scene would be, of which one line follows the vertex in the hand.
class HeldFiles : public QTextBrowser {
    Q_OBJECT
public:
    HeldFiles(Hand& hand, const class Document& document, QWidget* parent);

    // Whether the view beside it is the one that has the grips.
    void setOn(bool on);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showFiles();
    void fold();
    QString htmlOf(std::size_t opened) const;

    Hand& m_hand;
    const Document& m_document;
    bool m_isOn = false, m_isFolding = false;
    std::vector<lessons::HeldFile> m_files;
};

}  // namespace app
