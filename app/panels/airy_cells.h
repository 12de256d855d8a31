#pragma once
#include <QStyledItemDelegate>

namespace app {

// A digit's width of air on either side: a number at the right of its column keeps off the words at
// the left of the next. A style sheet's padding would hold for the selected row alone.
class AiryCells : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->text = ' ' + option->text + ' ';
    }
};

}  // namespace app
