#pragma once
#include <QPainter>
#include <QStyledItemDelegate>

#include "app/look/theme.h"

namespace app {

// A digit's width of air on either side: a number at the right of its column keeps off the words at
// the left of the next. A style sheet's padding would hold for the selected row alone.
class PaddedCells : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    // A selected row keeps its colours, as that of a verdict: a style sheet's would take their place.
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem plain = option;
        if (option.state.testFlag(QStyle::State_Selected)) {
            painter->fillRect(option.rect, Theme::current().colors().tint);
            plain.state &= ~(QStyle::State_Selected | QStyle::State_MouseOver | QStyle::State_HasFocus);
        }
        QStyledItemDelegate::paint(painter, plain, index);
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->text = ' ' + option->text + ' ';
    }
};

}  // namespace app
