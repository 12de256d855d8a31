#pragma once
#include <QCheckBox>
#include <QRadioButton>

namespace app {

// An option of a question as a row: its mark, its words in as many lines as they need, its key at the right. `Button` is
// QRadioButton or QCheckBox, which a screen reader knows.
template <class Button>
class OptionButton : public Button {
public:
    // plain: the words. key: 1 to 9.
    OptionButton(const QString& plain, int key, QWidget* parent);
    // Off: it was tried and is wrong; the reader's last answer, where it has a name, stays to be seen.
    void setOff(bool off);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool hitButton(const QPoint& at) const override { return this->rect().contains(at); }

private:
    QRect textRect(int width) const;

    int m_key;
    bool m_off = false;
};

extern template class OptionButton<QRadioButton>;
extern template class OptionButton<QCheckBox>;

}  // namespace app
