#pragma once
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace app {

// The bottom of a dialog that writes files: the equivalent command line, a progress bar, a sentence, and the buttons
// that start, cancel, close and show the folder.
class JobBar : public QWidget {
    Q_OBJECT
public:
    // name: begins the names of its controls, as "film" those of filmStart, filmCancel and filmMessage.
    JobBar(const QString& name, const QString& start, QWidget* parent);

    void setCommand(const QString& command);
    void setReady(bool ready, const QString& whyNot);  // to start; not while it runs
    QString message() const;
    // Another way to take what is started, enabled when that is.
    QPushButton* addButton(const QString& objectName, const QString& text);

    void begin();
    void setProgress(double share, const QString& what = {});  // share: 0 to 1
    // folder: where the files are; empty where nothing was written.
    void finish(const QString& sentence, const QString& folder);

signals:
    void startAsked();
    void cancelAsked();  // while it runs
    void closeAsked();   // else

private:
    void showButtons();

    bool m_running = false, m_ready = false;
    QString m_whyNot, m_folder;
    QLineEdit* m_command;
    QLabel* m_message;
    QProgressBar* m_progress;
    QPushButton *m_showFolder, *m_cancel, *m_start;
    QPushButton* m_other = nullptr;
    QHBoxLayout* m_row;
};

}  // namespace app
