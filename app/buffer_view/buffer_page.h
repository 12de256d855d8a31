#pragma once
#include <QString>
#include <QWidget>

class QLabel;
class QPushButton;

namespace app {

// Why there is no picture, and what a button below that offers.
struct Absence {
    enum class Offer : unsigned char { Nothing, Compute, ComputeAnyway, Cancel };
    QString why;
    Offer offer = Offer::Nothing;
};

// The page in place of a buffer's picture.
class BufferPage : public QWidget {
    Q_OBJECT
public:
    explicit BufferPage(QWidget* parent);

    void show(const Absence& absence);
    void setBare(bool bare);  // for an audience: the buffer's name, larger words, no button
    void setTitle(const QString& name);
    QString text() const;

signals:
    void offerTaken();

private:
    void setFonts();

    bool m_bare = false;
    QLabel *m_title, *m_message;
    QPushButton* m_offer;
};

}  // namespace app
