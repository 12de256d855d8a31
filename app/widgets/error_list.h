#pragma once
#include <QFrame>

#include "pipeline/core/result.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace app {

// The errors of a file or a value: a sentence, and one line per error that can be selected and copied. Hidden until
// there is an error; closing hides it again.
class ErrorList : public QFrame {
    Q_OBJECT
public:
    explicit ErrorList(QWidget* parent = nullptr);

    // `sentence` says what could not be done and what stays: "The scene before is still open."
    void report(const QString& sentence, const pipeline::Errors& errors);
    QString text() const;  // what Copy puts on the clipboard

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  // Esc closes

private:
    void fit();

    QLabel* m_sentence;
    QPlainTextEdit* m_lines;
    QPushButton* m_showFile;
    QString m_file;
};

}  // namespace app
