#pragma once
#include <QDialog>

#include "app/desktop/slide_picture.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace app {

// A picture for a slide: what of the window, how large, on what ground; with a preview.
class SlideDialog : public QDialog {
    Q_OBJECT
public:
    // state: what the window shows; goes into the file.
    SlideDialog(const Document& document, ViewArea& views, WindowState state, QWidget* parent = nullptr);

    SlideRequest request() const;
    bool save(const QString& file);  // false: why not stands in the dialog
    QString message() const;

private:
    QWidget* makeFields();
    void preview();
    void choose();
    void copy();

    const Document& m_document;
    ViewArea& m_views;
    WindowState m_state;
    QComboBox *m_what, *m_sizes;
    QSpinBox *m_width, *m_height;
    QCheckBox *m_transparent, *m_caption, *m_marks;
    QLabel *m_picture, *m_message;
    QPushButton* m_save;
    bool m_ready = false;
};

}  // namespace app
