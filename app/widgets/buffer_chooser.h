#pragma once
#include <QToolButton>

#include "app/document/document.h"

class QLineEdit;
class QTreeWidget;

namespace app {

// The name of the buffer on show; opens a list of all of them by stage, filtered by typing.
class BufferChooser : public QToolButton {
    Q_OBJECT
public:
    explicit BufferChooser(const Document& document, QWidget* parent = nullptr);

    void setName(const pipeline::BufferName& name);
    QSize sizeHint() const override;

signals:
    void chosen(const pipeline::BufferName& name);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open();
    void fill();
    void filter(const QString& text);
    void accept();

    const Document& m_document;
    pipeline::BufferName m_name{pipeline::BufferId::Color};
    QWidget* m_popup;
    QLineEdit* m_field;
    QTreeWidget* m_list;
};

}  // namespace app
