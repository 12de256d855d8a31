#pragma once
#include <QWidget>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace app {

// One line: a running task, its progress, and a link to click.
class ProgressLine : public QWidget {
public:
    explicit ProgressLine(QWidget* parent);

    void tell(const QString& what);
    void setShare(std::optional<double> share);  // 0 to 1; nothing: nobody knows
    void setBar(bool shown);
    QProgressBar* bar() { return m_bar; }
    QPushButton* link() { return m_link; }

private:
    QLabel* m_what;
    QProgressBar* m_bar;
    QPushButton* m_link;
};

}  // namespace app
