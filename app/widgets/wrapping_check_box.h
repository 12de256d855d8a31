#pragma once
#include <QCheckBox>
#include <QStyle>
#include <QStyleOptionButton>
#include <algorithm>

#include "app/widgets/folded_text.h"

namespace app {

// A check box whose words take as many lines as they need.
class WrappingCheckBox : public QCheckBox {
public:
    WrappingCheckBox(const QString& words, QWidget* parent) : QCheckBox(words, parent), m_words(words) {
        setAccessibleName(words);
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return sizeOf(folded(width)).height(); }
    QSize sizeHint() const override { return sizeOf(m_words); }
    // Of its longest word.
    QSize minimumSizeHint() const override {
        int least = 0;
        for (const QString& word : m_words.split(QLatin1Char(' '))) least = std::max(least, sizeOf(word).width());
        return {least, sizeOf(QString()).height()};
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QCheckBox::resizeEvent(event);
        if (const QString lines = folded(width()); lines != text()) setText(lines);
    }

private:
    QSize sizeOf(const QString& text) const {
        QStyleOptionButton option;
        initStyleOption(&option);
        option.text = text;
        return style()->sizeFromContents(QStyle::CT_CheckBox, &option,
                                         fontMetrics().size(Qt::TextShowMnemonic, text.isEmpty() ? "x" : text), this);
    }
    QString folded(int width) const {
        const auto fits = [&](const QString& part) { return sizeOf(part).width() <= width; };
        return foldedAtSpaces(m_words, fits, fits).join(QLatin1Char('\n'));
    }

    QString m_words;
};

}  // namespace app
